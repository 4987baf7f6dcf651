"""Sources: each cited key is listed in warpsample/SOURCES.md, and each listed key is cited."""

import re

import pytest

import warpsample as ws

CITED_IN = (".py", ".md", ".ipynb")
KEY = re.compile(r"\b[A-Z][A-Za-z]+(?:1[89]|20)\d\d\b|\bShirleyTrick\b")
BY_NAME = re.compile(r"\b(?:[A-Z][a-z]+(?:'s)? |et al\.,? \(?)(?:1[89]|20)\d\d\b")
DATE = re.compile(r"(?:January|February|March|April|May|June|July|August|September|October|November|December) \d{4}")


@pytest.fixture(scope="module")
def listed(repository):
    lines = (repository / "warpsample/SOURCES.md").read_text().splitlines()
    rows = [line.split(" | ", 1) for line in lines if line.startswith("| ") and not line.startswith(("| key", "| ---"))]
    return {key.removeprefix("| "): entry for key, entry in rows}


@pytest.fixture(scope="module")
def texts(repository):
    """Return the files that may cite a source, keyed by path."""
    folders = ("warpsample", "tests", "viz")
    paths = [path for folder in folders for path in (repository / folder).rglob("*") if path.suffix in CITED_IN]
    own = {repository / "warpsample/SOURCES.md", repository / "tests/test_sources.py"}
    return {str(path.relative_to(repository)): path.read_text() for path in {*paths, repository / "README.md"} - own}


def test_entries_are_in_order_and_their_years_are_those_of_their_keys(listed):
    assert len(listed) > 30
    assert list(listed)[5:] == sorted(list(listed)[5:])
    for key, entry in listed.items():
        assert KEY.fullmatch(key), key
        assert key == "ShirleyTrick" or key[-4:] in entry, key


def test_each_key_that_is_cited_is_listed(listed, texts):
    unknown = {(path, key) for path, text in texts.items() for key in KEY.findall(text) if key not in listed}
    assert unknown == set()


def test_each_listed_source_is_cited(listed, texts):
    cited = {key for path, text in texts.items() if path.startswith("warpsample") for key in KEY.findall(text)}
    assert set(listed) - cited == set()


def test_sources_are_cited_by_their_keys(texts):
    """A citation such as "Walter et al. 2007" does not lead to an entry."""
    found = {(path, hit) for path, text in texts.items() for hit in BY_NAME.findall(DATE.sub("", text))}
    assert found == set()


def test_each_record_names_a_source(listed):
    distributions = [ws.distributions.get(name) for name in ws.distributions.names()]
    sequences = [ws.sequences.get(name) for name in ws.sequences.names()]
    for record in (*distributions, *sequences):
        assert set(KEY.findall(record.source)) & set(listed), record.name
