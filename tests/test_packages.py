"""Wheel and sdist, built from the checkout and used outside the checkout by a plain installation."""

import os
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

PAPERS = ("CHANGELOG.md", "CITATION.cff", "CONTRIBUTING.md", "LICENSE", "README.md", "SECURITY.md", "pyproject.toml")


def test_the_version_is_one(repository):
    version = re.search(r'^version = "(.*)"$', (repository / "pyproject.toml").read_text(), flags=re.MULTILINE)[1]
    assert re.search(rf"^version: {re.escape(version)}$", (repository / "CITATION.cff").read_text(), flags=re.MULTILINE)


def test_papers_are_one_screen_and_their_links_lead_to_files(repository):
    for name in ("CONTRIBUTING.md", "SECURITY.md"):
        text = (repository / name).read_text()
        assert len(text.splitlines()) < 50
        links = re.findall(r"\]\(([^)#]+)", text)
        assert [link for link in links if not (repository / link).exists()] == []


def environment(folder):
    """Return the Python of a new environment, and a function that runs commands there, outside the checkout."""
    subprocess.run([sys.executable, "-m", "venv", folder / "venv"], check=True)
    variables = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    python = str(folder / "venv" / "bin" / "python")

    def run(*arguments, fails=False):
        given = {"capture_output": True, "text": True, "cwd": folder, "env": variables}
        done = subprocess.run([python, *map(str, arguments)], check=False, **given)
        assert (done.returncode != 0) == fails, done.stdout + done.stderr
        return done.stderr if fails else done.stdout

    return run


@pytest.fixture(scope="module")
def packages(repository, tmp_path_factory):
    """Return the folder with a wheel and an sdist, built from a copy of the checkout's files."""
    folder = tmp_path_factory.mktemp("build")
    left_out = shutil.ignore_patterns(".git", ".*_cache", "__pycache__", ".venv")
    shutil.copytree(repository, folder / "checkout", ignore=left_out)
    run = environment(folder)
    run("-m", "pip", "install", "--quiet", "hatchling")
    run(
        "-c",
        "import os; os.chdir('checkout'); from hatchling.cli import hatchling; hatchling()",
        "build",
        "-d",
        folder / "dist",
    )
    return folder / "dist"


@pytest.mark.thorough
def test_both_hold_what_they_should(packages, repository):
    (wheel,), (sdist,) = packages.glob("*.whl"), packages.glob("*.tar.gz")
    with tarfile.open(sdist) as archive:
        held = {Path(*Path(name).parts[1:]).as_posix() for name in archive.getnames()}
    tracked = subprocess.run(["git", "ls-files"], cwd=repository, capture_output=True, text=True, check=True).stdout.split(
        "\n"
    )
    own = {name for name in tracked if name.startswith(("warpsample/", "tests/", "viz/"))}
    assert own | set(PAPERS) <= held
    inside = {name for name in zipfile.ZipFile(wheel).namelist() if ".dist-info/" not in name}
    assert inside == {name for name in own if name.startswith("warpsample/")}
    assert "warpsample/py.typed" in inside


@pytest.mark.thorough
def test_a_plain_installation_works_outside_of_the_checkout(packages, repository, tmp_path):
    run = environment(tmp_path)
    (wheel,) = packages.glob("*.whl")
    run("-m", "pip", "install", "--quiet", wheel)
    where = run("-c", "import warpsample; print(warpsample.__version__, warpsample.__file__)")
    assert where.startswith("0.2.0 ")
    assert str(tmp_path) in where
    blocks = re.findall(r"^```python\n(.*?)^```", (repository / "README.md").read_text(), flags=re.DOTALL | re.MULTILINE)
    (tmp_path / "second.py").write_text(blocks[1])
    assert "sky view 0.63, standard error 0.00" in run("second.py")
    bake = ("-m", "warpsample", "bake", "courtyard", "-o")
    assert "sky.ply: sky view factor of" in run(*bake, "sky.ply", "--quantity", "sky", "--samples", "16")
    assert (tmp_path / "sky.ply").stat().st_size > 10_000
    for needs, said in (
        ((*bake, "sky.png"), "pip install"),
        ((*bake, "year.csv", "--quantity", "irradiation", "--weather", "athens"), "pip install"),
        (("-c", "import warpsample as ws; ws.rasters.surface('dsm.tif')"), "pip install"),
    ):
        assert said in run(*needs, fails=True)
