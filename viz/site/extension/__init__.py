"""What Sphinx does not know of this package: links of READMEs, commands, kernels' functions, examples, keys of sources."""

from typing import Any

from extension import commands, kernels, links, names, sources


def setup(app: Any) -> dict[str, bool]:
    """Connects to Sphinx's events."""
    app.add_directive("command", commands.Command)
    app.connect("builder-inited", links.find_homes)
    app.connect("include-read", links.rewrite)
    app.connect("autodoc-process-docstring", names.complete)
    app.connect("autodoc-process-signature", kernels.signature)
    app.connect("viewcode-follow-imported", names.module_of)
    app.connect("doctree-read", names.polish)
    app.connect("doctree-resolved", sources.link)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
