"""Build the documentation: `python viz/site.py`, after `pip install '.[site]'`. No network is needed."""

from pathlib import Path
from typing import Annotated

import typer

from warpsample.cli.terminal import fail_plainly
from warpsample.host.files import check_output_folder

SOURCES = Path(__file__).parent / "site"


@fail_plainly()
def main(
    output: Annotated[
        Path, typer.Option("--output", "-o", help="Folder for the pages. A missing folder is created.")
    ] = Path("site"),
) -> None:
    """Build the pages of the documentation, with a search that works without a network."""
    check_output_folder(output, "--output")
    try:
        from sphinx.cmd.build import build_main  # noqa: PLC0415
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(f"the site needs {error.name}: pip install '.[site]'") from error
    status = build_main(["--quiet", "--fail-on-warning", "--keep-going", "-j", "auto", str(SOURCES), str(output)])
    if status:
        raise RuntimeError(f"--output: {output} is not complete; the messages of Sphinx above name the reason")
    print(f"{output / 'index.html'}: {len(list(output.rglob('*.html')))} pages")


if __name__ == "__main__":
    typer.run(main)
