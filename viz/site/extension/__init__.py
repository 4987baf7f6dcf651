"""Sphinx extension for this package: links of READMEs, commands, functions for kernels, examples, and keys of sources."""

from typing import Any

from extension import commands, kernels, links, names, sources


def setup(app: Any) -> dict[str, bool]:
    """Connect the functions of the extension to Sphinx's events."""
    app.add_directive("command", commands.Command)
    app.connect("builder-inited", links.find_homes)
    app.connect("include-read", links.rewrite)
    app.connect("autodoc-process-docstring", names.complete)
    app.connect("autodoc-process-signature", kernels.signature)
    app.connect("viewcode-follow-imported", names.module_of)
    app.connect("doctree-read", names.polish)
    app.connect("doctree-resolved", sources.link)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
