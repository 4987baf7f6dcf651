"""The site: its code blocks run, every public name is in it, and a browser shows all pages without an error."""

import importlib
import re
import subprocess
import sys
from html.parser import HTMLParser
from urllib.parse import unquote, urldefrag

import browser
import pytest
from page_reader import Reader

from warpsample.cli.commands import app

BLOCK = re.compile(r"^```(python|sh|text)\n(.*?)^```", re.DOTALL | re.MULTILINE)
NUMBER = re.compile(r"-?\d[\d,]*(?:\.\d*)?(?:e[-+]\d+)?")
TELLING = ("Warp ", "   ", "Module ")  # how lines of Warp's own begin
NEEDS = {"journeys/city": "rasterio", "journeys/asset": "xatlas", "journeys/cluster": "zarr"}
JOURNEYS = tuple(f"journeys/{name}" for name in ("sampler", "city", "enclosure", "kernel", "asset", "cluster"))


def steps(text):
    """Return (language, code, output or "") of the blocks of a page, in order."""
    found = BLOCK.findall(text)
    after = [*found[1:], ("", "")]
    return [
        (language, code, following[1] if following[0] == "text" else "")
        for (language, code), following in zip(found, after, strict=True)
        if language != "text"
    ]


def differences(printed, shown):
    """Return the lines that a page shows and the code does not print, in this order; "..." matches any lines.

    Numbers may differ by one unit in the last place, because processors round differently.
    """
    lines, missing = iter(printed.splitlines()), []
    for line in shown.splitlines():
        if line == "...":
            continue
        if not any(same(line, other) for other in lines):
            missing.append(line)
    return missing


def same(shown, printed):
    if NUMBER.sub("#", shown).split() != NUMBER.sub("#", printed).split():
        return False
    pairs = zip(NUMBER.findall(shown), NUMBER.findall(printed), strict=True)
    return all(abs(value(ours) - value(theirs)) <= unit(ours) * 1.001 for ours, theirs in pairs)


def value(number):
    return float(number.replace(",", ""))


def unit(number):
    """Return the unit of the last place; 0 for whole numbers without a decimal point, which are exact counts."""
    digits, _, exponent = number.partition("e")
    return 10.0 ** (int(exponent or 0) - len(digits.partition(".")[2])) if "." in digits else 0.0


@pytest.mark.slow
@pytest.mark.parametrize("name", ["start", *JOURNEYS, "right/index"])
def test_a_page_runs_and_prints_what_it_shows(name, repository, tmp_path, monkeypatch, call, capsys):
    pytest.importorskip(NEEDS.get(name, "warpsample"))
    monkeypatch.chdir(tmp_path)
    reader = Reader(name, tmp_path, call)
    monkeypatch.setitem(sys.modules, reader.module.__name__, reader.module)
    for language, code, shown in steps((repository / f"viz/site/{name}.md").read_text()):
        printed = getattr(reader, language)(code, capsys)
        assert differences(printed, shown) == [], printed
        assert shown or language == "sh" or not printed.strip(), f"prints what the page does not show: {printed}"


@pytest.mark.parametrize(
    ("shown", "printed", "alike"),
    [
        ("0.63 of 1,000", "0.64 of 1,000", True),
        ("0.63 of 1,000", "0.65 of 1,000", False),
        ("0.63 of 1,000", "0.63 of 1,001", False),
        ("2.0e-07 holds", "2.1e-07  holds", True),
        ("True", "False", False),
    ],
)
def test_a_line_may_differ_by_a_unit_of_its_last_place(shown, printed, alike):
    assert (differences(printed, shown) == []) == alike


@pytest.fixture
def names(repository, monkeypatch):
    """Return the module of the site that lists public names."""
    pytest.importorskip("zarr")  # and with it all that pages describe
    pytest.importorskip("sphinx")
    monkeypatch.syspath_prepend(repository / "viz/site")
    return importlib.import_module("extension.names")


@pytest.mark.slow
def test_every_public_name_is_in_the_reference_with_an_example(names, repository):
    pages = "\n".join(page.read_text() for page in sorted((repository / "viz/site/reference").glob("*.md")))
    shown = re.findall(r"^\.\. (?:auto\w+|py:class):: (\S+)$", pages, flags=re.MULTILINE)
    records = {f"warpsample.distributions.{name}" for name in ("Distribution", "Maps")}
    assert sorted(shown) == sorted({*names.public(), *records})
    assert [name for name in names.public() if not names.example(name)] == []


def test_every_command_is_in_the_reference(repository):
    page = (repository / "viz/site/reference/commands.md").read_text()
    said = {command.name or command.callback.__name__.removesuffix("_command") for command in app.registered_commands}
    assert set(re.findall(r"^\.\. command:: (\S+)$", page, flags=re.MULTILINE)) == {name.replace("_", "-") for name in said}


@pytest.mark.thorough
def test_examples_that_the_site_makes_run(names, tmp_path, monkeypatch):
    """Examples are the body of a kernel for each function of `funcs`, and lines for each distribution."""
    from extension.kernels import KERNEL

    lines = ["import numpy as np\nimport warp as wp\nimport warpsample as ws\nfrom warpsample import funcs\n"]
    for name in names.public():
        text = names.example(name)
        if name.startswith("warpsample.funcs.") and text.startswith("i = "):
            body = text.replace("\n", "\n    ")
            lines.append(f"@wp.kernel(enable_backward=False)\ndef of_{name.split('.')[-1]}({KERNEL}):\n    {body}\n")
        elif "lobe = " in text:
            lines.append(text.replace(">>> ", "") + "\nassert (p >= 0.0).all() and np.isfinite(w).all()\n")
    assert len(lines) > 70
    lines.append("wp.load_module(__name__, device='cpu')")
    script = tmp_path / "examples.py"
    script.write_text("\n\n".join(lines))
    subprocess.run([sys.executable, script], check=True, cwd=tmp_path)


class Links(HTMLParser):
    """Links, loaded files and anchors of a page."""

    def __init__(self, text):
        super().__init__()
        self.leads, self.loads, self.anchors = [], [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors |= {given[key] for key in ("id", "name") if given.get(key)}
        address = given.get("href") or given.get("src")
        if address:
            (self.leads if tag == "a" else self.loads).append(address)


@pytest.fixture(scope="module")
def site(repository, tmp_path_factory):
    """Build the site and return its folder."""
    pytest.importorskip("sphinx")
    pytest.importorskip("zarr")
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, repository / "viz/site.py", "-o", folder]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder


@pytest.mark.slow
def test_all_pages_and_references_are_read_without_a_warning(repository, tmp_path):
    """Sphinx resolves the links between pages and writes no page, which takes half the time of the whole site."""
    pytest.importorskip("sphinx")
    pytest.importorskip("zarr")
    options = ["--quiet", "--fail-on-warning", "--keep-going", "-b", "dummy"]
    command = [sys.executable, "-m", "sphinx", *options, repository / "viz/site", tmp_path / "site"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.thorough
def test_all_links_lead_somewhere_and_nothing_is_loaded_from_elsewhere(site):
    pages = {page: Links(page.read_text()) for page in sorted(site.rglob("*.html"))}
    assert len(pages) > 80
    for page, links in pages.items():
        assert [address for address in links.loads if "://" in address or address.startswith("//")] == [], page
        for address in links.leads + links.loads:
            if "://" in address or address.startswith("mailto:"):
                continue
            path, anchor = urldefrag(address)
            target = (page.parent / unquote(path.partition("?")[0])).resolve() if path else page
            assert target.exists(), f"{page}: {address}"
            assert not anchor or unquote(anchor) in pages[target].anchors, f"{page}: {address}"


@pytest.mark.thorough
def test_a_browser_shows_every_page_whole_and_finds_what_a_search_names(site, tmp_path):
    if browser.CHROMIUM is None:
        pytest.skip("no Chromium: apt-get install chromium")
    pages = [page.relative_to(site).as_posix() for page in sorted(site.rglob("*.html"))]
    searches = {"irradiation": "warpsample.irradiation", "sky+view+factor": "warpsample.sky_view_factor"}
    said = browser.opened(site, [*pages, *(f"search.html?q={words}" for words in searches)], (390, 1400), tmp_path)
    assert len(said) == 2 * (len(pages) + len(searches))
    assert [page for page in said if page["over"] > 0 or page["missing"] or page["errors"]] == []
    assert [page["found"][0] for page in said[-2 * len(searches) :: 2]] == list(searches.values())
