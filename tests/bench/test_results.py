"""What the README says was measured: it, the result files and the pictures belong together."""

import json
import re
from collections import Counter
from dataclasses import replace

import pytest
from bench_output import lines_of
from PIL import Image

from warpsample.bench import benchmarks
from warpsample.bench.reporting import readme
from warpsample.bench.result import RESULTS, load_results, save_repeats, save_summary
from warpsample.bench.rows import format_figure

NAMES = sorted(benchmarks())


@pytest.fixture(scope="module")
def results():
    """Of the first processor."""
    return load_results(readme.list_processors(RESULTS)[0], benchmarks())


@pytest.fixture
def copied(tmp_path):
    for path in RESULTS.glob("*.json"):
        (tmp_path / path.name).write_bytes(path.read_bytes())
    return tmp_path


def changed(value):
    """A spread 1.5 times as large, and a figure that is a text with a digit more."""
    if isinstance(value, list):
        return [1.5 * x for x in value]
    return f"{value}9" if isinstance(value, str) and re.fullmatch("[~<]?[0-9.]+", value) else value


def scale(path):
    """Makes every median and quartile in a file of results 1.5 times as large; figures in words get a digit more."""
    content = json.loads(path.read_text(encoding="utf-8"))
    for part in content.values():
        for row in part.get("rows", ()) if isinstance(part, dict) else ():
            row[:] = [changed(value) for value in row]
    path.write_text(json.dumps(content), encoding="utf-8")


def block(name):
    """An empty place for the tables of a benchmark."""
    return f"<!-- bench {name} -->\n<!-- end -->"


@pytest.fixture
def fill():
    """Return a function that fills a text from a folder, for a slice of its processors."""

    def fill_for(text, folder, chosen=slice(None)):
        return readme.fill_page(text, folder, readme.list_processors(folder)[chosen])

    return fill_for


@pytest.mark.parametrize("page", readme.list_pages(), ids=lambda page: page.name)
def test_each_page_shows_every_benchmark_once(page):
    assert sorted(re.findall("<!-- bench ([a-z-]+) -->", page.read_text(encoding="utf-8"))) == NAMES


@pytest.mark.parametrize(("page", "chosen"), readme.list_pages().items(), ids=lambda item: getattr(item, "name", ""))
def test_each_page_is_generated_from_the_results(page, chosen, fill):
    text = page.read_text(encoding="utf-8")
    assert fill(text, RESULTS, chosen) == text


def test_each_page_names_one_kind_of_processor():
    kinds = [set(re.findall(r"AMD EPYC,\s(AVX2|AVX-512)", page.read_text(encoding="utf-8"))) for page in readme.list_pages()]
    assert kinds == [{"AVX-512"}, {"AVX2"}]


def test_the_page_is_short():
    """Count the lines: a reader of one processor scrolls past nothing that is about the other."""
    assert len(readme.README.read_text(encoding="utf-8").splitlines()) <= 500


@pytest.mark.parametrize("name", NAMES)
def test_an_edit_of_a_result_changes_the_page_of_its_processor_alone(copied, name, fill):
    scale(copied / f"{name}-{readme.list_processors(copied)[0]}.json")
    texts = {page: page.read_text(encoding="utf-8") for page in readme.list_pages()}
    changed = [fill(text, copied, readme.list_pages()[page]) != text for page, text in texts.items()]
    assert changed == [True, False]


def test_an_edit_of_the_readme_is_seen_where_it_is_measured_and_only_there(fill):
    text = readme.README.read_text(encoding="utf-8")
    blocks = re.finditer("<!-- bench .*?<!-- end -->", text, flags=re.DOTALL)
    figures = [block.start() + found.start() for block in blocks for found in re.finditer(r"\d", block[0])]
    for at in figures[:: len(figures) // 8]:
        edited = text[:at] + str((int(text[at]) + 1) % 10) + text[at + 1 :]
        assert fill(edited, RESULTS, slice(1)) == text
    assert fill(f"{text}More.", RESULTS, slice(1)) == f"{text}More."


@pytest.mark.parametrize("name", NAMES)
def test_results_are_read_as_they_were_written(results, name, tmp_path):
    path = save_summary(benchmarks()[name], results[name], tmp_path)
    assert path.read_bytes() == (RESULTS / path.name).read_bytes()
    content = json.loads(path.read_text(encoding="utf-8"))
    assert content["command"] == f"bench {name}"
    assert content["seed"] == 0
    assert content["machine"]["commit"]
    assert not [part for part in content.values() if isinstance(part, dict) and "seconds" in part.get("columns", ())
                and isinstance(part["rows"][0][part["columns"].index("seconds")], list)]  # fmt: skip


def test_a_setting_that_is_a_path_is_written_as_its_text(results, tmp_path):
    path, asset = tmp_path / "all.json", tmp_path / "in.glb"
    result = replace(results["textures"], settings={"asset": asset})
    save_repeats(path, benchmarks()["textures"], result)
    assert json.loads(path.read_text(encoding="utf-8"))["settings"] == {"asset": str(asset)}
    assert json.loads(save_summary(benchmarks()["textures"], result, tmp_path).read_text())["settings"] == {
        "asset": str(asset)
    }


@pytest.mark.parametrize("content", ['{"command": "bench rays", "machine": {"cp', "{}", "[]", ""])
def test_a_damaged_file_of_results_is_named(copied, content, fill):
    path = copied / f"rays-{readme.list_processors(copied)[0]}.json"
    path.write_text(content, encoding="utf-8")
    with pytest.raises(
        ValueError, match=rf"^{re.escape(str(path))}: got \w+Error .*, want a file written by `warpsample bench"
    ):
        fill(block("rays"), copied)


def test_results_are_small():
    sizes = Counter()
    for path in RESULTS.glob("*.json"):
        sizes[path.stem.rpartition("-")[2]] += path.stat().st_size
    assert max(sizes.values()) <= 140_000


@pytest.mark.parametrize("name", NAMES)
def test_results_are_of_the_default_sizes_and_of_a_commit(results, name):
    assert results[name].settings == benchmarks()[name].settings()
    assert re.fullmatch("[0-9a-f]{12}", results[name].machine.commit)


def test_the_first_page_says_what_was_measured(repository):
    text = " ".join((repository / "README.md").read_text(encoding="utf-8").split())
    phrases = readme.list_headlines(readme.list_processors(RESULTS)[0])
    assert [phrase for phrase in phrases if phrase not in text] == []


def test_pictures_are_of_the_results(repository):
    shown = readme.find_pictures(readme.README.read_text(encoding="utf-8"))
    draw_pictures = {picture.name: name for name, benchmark in benchmarks().items() for picture in benchmark.pictures}
    assert sorted(shown) == ["error", "rays", "visibility"]
    for picture in shown:
        path = RESULTS / f"{draw_pictures[picture]}-{readme.list_processors(RESULTS)[0]}.json"
        with Image.open(repository / "viz" / f"bench_{picture}.png") as image:
            assert image.text["Description"] == readme.describe_source(path)


def test_the_lowest_plot_of_each_column_has_numbers_on_its_x_axis(results):
    """Seven plots in two rows leave a place empty, above which the axis had no numbers."""
    figure = benchmarks()["error"].figures(results["error"], ["error"])["error"]
    lowest = {axes.get_subplotspec().colspan.start: axes for axes in figure.axes if axes.axison}
    assert len(lowest) == 4
    assert all(axes.xaxis.get_major_ticks()[0].label1.get_visible() for axes in lowest.values())


def test_each_processor_has_its_tables_the_first_before_the_others(results, tmp_path, fill):
    for name, result in results.items():
        save_summary(
            benchmarks()[name], replace(result, machine=replace(result.machine, cpu="One", instructions="avx2")), tmp_path
        )
    result = results["peers"]
    save_summary(
        benchmarks()["peers"], replace(result, machine=replace(result.machine, cpu="Two", instructions="avx512")), tmp_path
    )
    text = fill("\n".join(map(block, NAMES)), tmp_path)
    listed = re.findall("`warpsample bench ([a-z-]+)`:[^;]*;\\s(One|Two),\\s(AVX2|AVX-512)", text)
    others = [(name, "One", "AVX2") for name in NAMES]
    others.insert(NAMES.index("peers"), ("peers", "Two", "AVX-512"))
    assert listed == others
    assert fill(text, tmp_path) == text


def test_every_figure_of_the_first_page_follows_its_result(copied):
    processor = readme.list_processors(copied)[0]
    before = readme.list_headlines(processor, copied)
    assert len(before) == 4
    for name, changed in (("peers", 0), ("rays", 1), ("visibility", 2)):
        scale(copied / f"{name}-{processor}.json")
        after = readme.list_headlines(processor, copied)
        assert [i for i in range(4) if after[i] != before[i]] == [changed]
        before = after


@pytest.mark.parametrize("name", NAMES)
def test_results_are_shown(results, name, capsys):
    """All lines fit; `lines_of` looks."""
    assert len(lines_of(name, results[name].settings, results[name].rows, capsys)) > 10


def test_small_figures_are_not_rounded_to_0():
    assert format_figure(0.00123) == "0.0012"
    assert [format_figure(x) for x in (0.0, 0.0051, 1.234, 12.34, 1234.5)] == ["0.00", "0.01", "1.23", "12.3", "1,234"]
