"""The notebook runs; the gallery makes its pictures and a page that a browser shows without any other file."""

import json
import re
import subprocess
import sys
from importlib.util import find_spec

import matplotlib.image
import nbformat
import pytest
import pyvista
from browser import CHROMIUM, FLAGS
from hangs import HANGS

DRAWING = "--use-angle=swiftshader --enable-unsafe-swiftshader --virtual-time-budget=20000 --window-size=1000,900"
ASK = """<script>addEventListener("load", () => {
  const said = document.createElement("pre"); said.id = "said";
  said.textContent = JSON.stringify([...document.images].map(i => [i.alt, i.naturalWidth, i.naturalHeight]));
  document.body.append(said); });</script>"""


RUN = """
import sys, nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellTimeoutError
for last in (False, False, True):
    notebook = nbformat.read(sys.argv[1], as_version=4)
    try:
        NotebookClient(notebook, timeout=float(sys.argv[3]), kernel_name="python3").execute()
        break
    except CellTimeoutError:
        if last:
            raise
nbformat.write(notebook, sys.argv[2])
"""
"""Runs a notebook, again if a cell did not end: ipykernel 7.4 sometimes waits idly for a cell that the client has sent."""


def executed(notebook, folder, environment):
    """A notebook that a process of its own has run: in one whose event loops are nested, the client may wait for ever."""
    source, target = folder / "source.ipynb", folder / "target.ipynb"
    nbformat.write(notebook, source)
    command = [sys.executable, "-c", RUN, source, target, str(HANGS / 8)]
    subprocess.run(command, env=environment, check=True, timeout=HANGS)
    return nbformat.read(target, as_version=4)


@pytest.fixture
def tour(repository):
    return nbformat.read(repository / "viz" / "tour.ipynb", as_version=4)


TOLD = r"6,102 vertices, \d+ of 256 rays cast at each, RMS standard error 0\.00\d+"


@pytest.mark.slow
def test_the_cells_of_the_notebook_run(can_render, tour, monkeypatch, capsys):
    """In this process, which has loaded the kernels already; the test below has a notebook's pictures and values."""
    monkeypatch.setattr(pyvista, "set_jupyter_backend", lambda _: None)
    known = {}
    for cell in tour.cells:
        if cell.cell_type == "code":
            exec(cell.source, known)
    assert re.search(TOLD, capsys.readouterr().out)
    assert known["d"].vectors.shape == (2000, 256, 3)
    assert (known["d"].status == 0).all()


@pytest.mark.thorough
def test_the_notebook_runs(can_render, tour, tmp_path, child_environment):
    """From start to end; it shows four pictures, and its numbers are those that its text promises."""
    notebook = executed(tour, tmp_path, child_environment)
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert sum("image/png" in output.get("data", {}) for output in outputs) == 4
    text = "".join(output.get("text", "") + output.get("data", {}).get("text/plain", "") for output in outputs)
    assert "((2000, 256, 3), {<Status.OK: 0>: 2000})" in text
    assert "3.14159" in text
    assert re.search(TOLD, text)


@pytest.mark.slow
def test_a_notebook_shows_the_bar_of_a_long_call(tmp_path, child_environment):
    code = "import numpy as np, warpsample as ws\nn = np.ones((100, 3))\nd = ws.sample_directions(n, 8, progress={})"
    cells = [nbformat.v4.new_code_cell(code.format(asked)) for asked in (False, True)]
    notebook = executed(nbformat.v4.new_notebook(cells=cells), tmp_path, child_environment)
    shown = [any("application/vnd.jupyter.widget-view+json" in o.get("data", {}) for o in c.outputs) for c in notebook.cells]
    assert shown == [False, True]


def test_every_picture_of_a_readme_is_in_the_gallery(repository, script):
    texts = [path.read_text() for path in sorted(repository.rglob("README.md"))]
    shown = [name for text in texts for name in re.findall(r"!\[[^]]*\]\([^)]*?(\w+)\.png\)", text)]
    assert len(shown) == len(set(shown))
    assert set(shown) <= {shot.name for shot in script("gallery").SHOTS}
    assert {shot.name for shot in script("gallery").SHOTS} - set(shown) <= {"direction_clouds_wrong"}


def test_a_picture_that_cannot_be_made_is_a_sentence(script, tmp_path, monkeypatch, capsys):
    gallery = script("gallery")
    broken = gallery.Shot("x", "x", "x", "viz/nothing.py --screenshot FILE")
    monkeypatch.setattr(gallery, "SHOTS", (broken,))
    with pytest.raises(SystemExit):
        gallery.main(output=tmp_path / "out")
    said = capsys.readouterr().err
    assert said.startswith("error: python viz/nothing.py --screenshot FILE: ")
    assert "can't open file" in said
    assert list((tmp_path / "out").iterdir()) == []
    (tmp_path / "file").touch()
    with pytest.raises(SystemExit):
        gallery.main(output=tmp_path / "file")
    assert "which is a file, want a folder" in capsys.readouterr().err


@pytest.mark.thorough
def test_the_page_in_a_browser(can_render, repository, tmp_path, child_environment):
    if CHROMIUM is None:
        pytest.skip("no Chromium: apt-get install chromium")
    command = [sys.executable, repository / "viz" / "gallery.py", "--no-benchmarks", "-o", tmp_path / "gallery"]
    done = subprocess.run(command, env=child_environment, capture_output=True, text=True, check=True)
    page = tmp_path / "gallery" / "index.html"
    assert done.stdout == f"{page}: {15 + bool(find_spec('zarr'))} pictures\n"
    html = page.read_text(encoding="utf-8")
    outside_scene = re.sub(r'srcdoc="[^"]*"', "", html)
    assert not re.search(r"(src|href)=.(https?:|//|[\w./]+\.(png|js|css))", outside_scene)

    asked, shot = tmp_path / "asked.html", tmp_path / "page.png"
    asked.write_text(html.replace("</body>", ASK + "</body>"), encoding="utf-8")
    browser = [CHROMIUM, *FLAGS.split(), *DRAWING.split(), f"--user-data-dir={tmp_path / 'profile'}"]
    dom = subprocess.run([*browser, "--dump-dom", asked.as_uri()], capture_output=True, text=True, check=True).stdout
    images = json.loads(re.search(r'<pre id="said">(.*?)</pre>', dom)[1])
    assert [name for name, _, _ in images] == re.findall(r'<img alt="([^"]*)"', html)
    assert all(width >= 1600 and height >= 600 for _, width, height in images)
    # Scrolled to its end the page shows the scene that can be turned: it must be drawn by the browser itself.
    tall = [part if "window-size" not in part else "--window-size=1000,6000" for part in browser]
    subprocess.run([*tall, f"--screenshot={shot}", page.as_uri()], capture_output=True, check=True)
    scene = matplotlib.image.imread(shot)[-1500:, 200:800, :3]
    colourful = (scene.max(axis=-1) - scene.min(axis=-1)) > 0.3  # viridis, which no text has
    assert colourful.mean() > 0.005
