"""Links of included READMEs, which link to each other by their paths in the repository."""

import os
import re
from pathlib import Path
from typing import Any

REPOSITORY = Path(__file__).parents[3]
PAGES = Path(__file__).parents[1]
_INCLUDED = re.compile(r"^```\{include\} (\S+)", re.MULTILINE)
_LINK = re.compile(r"\[([^]]*)\]\((?![a-z]+:|#|/)([^)#\s]+)(#[^)\s]*)?\)")
_homes: dict[Path, str] = {}


def find_homes(app: Any = None) -> dict[Path, str]:  # noqa: ARG001
    """Return the page of the site that includes each README.

    If there are several pages, it is the first one that includes nothing else.
    """
    found = [(page, _INCLUDED.findall(page.read_text())) for page in sorted(PAGES.rglob("*.md"))]
    for page, papers in sorted(found, key=lambda item: -len(item[1])):
        for paper in papers:
            _homes[(page.parent / paper).resolve()] = f"/{page.relative_to(PAGES).as_posix()}"
    return _homes


def rewrite(app: Any, path: Path, parent: str, content: list[str]) -> None:  # noqa: ARG001
    """Replace the links in a README's text by links to pages of the site and to pictures of the repository."""
    folder = (PAGES / path).resolve().parent
    content[0] = _LINK.sub(lambda link: _resolve_link(folder, link), content[0])


def _resolve_link(folder: Path, link: re.Match[str]) -> str:
    label, path, heading = link.groups(default="")
    target = (folder / path).resolve()
    if target.suffix == ".png" and target.exists():
        return f"[{label}](/{os.path.relpath(target, PAGES)})"
    if target.suffix == ".py" and target.exists():
        return f"`{label}`"
    if target not in _homes:
        raise ValueError(f"{folder}: links to {path}, which no page of the site includes")
    return f"[{label}]({_homes[target]}{heading})"
