"""Links from keys of sources, such as Walter2007, to their rows on the page of sources."""

import re
from typing import Any

from docutils import nodes

PAGE = "reference/sources"
_KEY = re.compile(r"\b([A-Z][A-Za-z]+(?:1[89]|20)\d\d|ShirleyTrick)\b")


def link(app: Any, doctree: nodes.document, page: str) -> None:
    """Add an anchor to each row of the page of sources, and link keys such as Walter2007 on other pages to the row."""
    if page == PAGE:
        for row in doctree.findall(nodes.row):
            row["ids"].append(row[0].astext().lower())
        return
    for text in list(doctree.findall(nodes.Text)):
        inside = text.parent
        while inside is not None and not isinstance(
            inside, nodes.literal | nodes.literal_block | nodes.reference | nodes.title
        ):
            inside = inside.parent
        if inside is None and _KEY.search(text):
            text.parent.replace(text, _link_keys(app.builder.get_relative_uri(page, PAGE), text))


def _link_keys(address: str, text: str) -> list[nodes.Node]:
    parts = _KEY.split(text)
    made: list[nodes.Node] = []
    for i, part in enumerate(parts):
        made.append(nodes.reference("", part, refuri=f"{address}#{part.lower()}") if i % 2 else nodes.Text(part))
    return made
