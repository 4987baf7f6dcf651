"""Every picture of the README, and a page that shows them: `python viz/gallery.py`."""

import base64
import subprocess
import sys
from dataclasses import dataclass
from html import escape
from pathlib import Path
from string import Template
from tempfile import TemporaryDirectory
from typing import Annotated

import typer

from warpsample.bench.machine import this_machine
from warpsample.cli.terminal import fail_plainly, with_progress
from warpsample.host.files import check_output_folder, write_bytes
from warpsample.plotting import rendering

HERE = Path(__file__).parent


@dataclass(frozen=True)
class Shot:
    """A picture.

    Attributes:
        name: of its file, without suffix.
        title: on the page.
        text: under it.
        command: what makes it, after `python`; FILE is the picture, FOLDER a folder for it.
    """

    name: str
    title: str
    text: str
    command: str


SHOTS = (
    Shot(
        "direction_clouds",
        "The viewer",
        "Clouds of directions around the normals, as long as their density: for the cosine lobe little spheres that rest "
        "on the surface. One cloud enlarged in its tangent frame; the angles of all against the density.",
        "viz/direction_clouds.py --screenshot FILE",
    ),
    Shot(
        "direction_clouds_wrong",
        "A wrong one",
        "A ball in place of the sphere, held against the cosine lobe: too many directions near the normal.",
        "viz/direction_clouds.py --distribution offset_ball --density cosine_hemisphere --screenshot FILE",
    ),
    Shot(
        "shirley_overlay",
        "Shirley's trick, Keinert's proof",
        "A sphere's points plus the normal, normalised, in green; the cosine set in red; as light, both are yellow.",
        "viz/shirley_overlay.py --screenshot FILE",
    ),
    Shot(
        "offset_family",
        "The projected offset sets",
        "A circle, disk, sphere or ball about the tip of the normal, projected onto the unit circle or sphere, and what "
        "becomes of the angle; spheres of other radii; and the half angle of the proof.",
        "viz/offset_family.py --screenshot FILE",
    ),
    Shot(
        "sequences",
        "Where the points come from",
        "The sequences on the square, on the hemisphere, and the error of means over their directions.",
        "viz/sequences.py --screenshot FILE",
    ),
    Shot(
        "occlusion",
        "Ambient occlusion",
        "Of the bunny's vertices, its standard error, and the rays it took.",
        "viz/occlusion.py --screenshot FILE",
    ),
    Shot("bench_error", "Which sequence", "RMSE against run time.", "-m warpsample.cli bench error --plot FOLDER"),
    Shot("bench_rays", "Rays", "Against Embree, Open3D and wp.Mesh.", "-m warpsample.cli bench rays --plot FOLDER"),
    Shot(
        "bench_visibility",
        "Time to an error",
        "Of ambient occlusion, against other tools.",
        "-m warpsample.cli bench visibility --plot FOLDER",
    ),
)
SCENE = "viz/direction_clouds.py --points 60 --samples 500 --screenshot FILE"

_PAGE = Template("""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>warpsample</title>
<style>
body { font: 17px/1.5 sans-serif; color: #333; max-width: 72rem; margin: 2rem auto; padding: 0 1rem; }
figure { margin: 0 0 3rem; } img, iframe { width: 100%; border: 1px solid #ddd; } iframe { height: 40rem; }
code { background: #f2f0ec; padding: 0.15rem 0.4rem; overflow-wrap: anywhere; } footer { color: #777; }
</style></head><body>
<h1>warpsample</h1>
<p>Directions around the normals of a mesh, sampled by NVIDIA Warp kernels on the CPU. Each picture with what makes it.</p>
$figures
<h2>The clouds, to turn</h2>
<figure><iframe title="clouds on the bunny" srcdoc="$scene"></iframe>
<figcaption><code>python $scene_command</code></figcaption></figure>
<footer>$machine</footer>
</body></html>
""")
_FIGURE = Template("""<h2>$title</h2>
<figure><img alt="$title" src="data:image/png;base64,$data">
<figcaption><p>$text</p><p>$said</p><code>python $command</code></figcaption></figure>""")


def make(command: str, file: Path) -> str:
    """Runs a command of a Shot in the folder above this one, and puts its picture into `file`; what it said of it.

    Raises:
        RuntimeError: it failed; with its last line.
    """
    with TemporaryDirectory() as folder:
        words = command.replace("FILE", str(file.resolve())).replace("FOLDER", folder).split()
        done = subprocess.run([sys.executable, *words], cwd=HERE.parent, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"python {command}: {(done.stderr.strip().splitlines() or ['failed'])[-1]}")
        if "FOLDER" not in command:
            return done.stdout.strip().partition(": ")[2]
        (made,) = Path(folder).glob("*.png")
        write_bytes(file, made.read_bytes())
    return "the tables are in the README"


@fail_plainly()
def main(
    output: Annotated[
        Path, typer.Option("--output", "-o", help="The folder for the pictures and index.html; made if need be.")
    ] = Path("gallery"),
    benchmarks: Annotated[bool, typer.Option(help="With the benchmarks' pictures; they take eleven minutes.")] = True,
) -> None:
    """Make every picture of the README, and a page that shows them and needs no other file."""
    check_output_folder(output, "--output")
    rendering.check_rendering()
    output.mkdir(parents=True, exist_ok=True)
    figures = []
    shots = [shot for shot in SHOTS if benchmarks or "FOLDER" not in shot.command]
    for shot in with_progress(shots, len(shots), "drawing"):
        file = output / f"{shot.name}.png"
        said = make(shot.command, file)
        data = base64.b64encode(file.read_bytes()).decode()
        command = shot.command.replace("FILE", file.name).replace("FOLDER", ".")
        figures.append(_FIGURE.substitute(title=shot.title, text=shot.text, said=escape(said), command=command, data=data))
    with TemporaryDirectory() as folder:
        scene = Path(folder) / "scene.html"
        make(SCENE, scene)
        text = escape(scene.read_text(encoding="utf-8"))
    page = _PAGE.substitute(
        figures="\n".join(figures),
        scene=text,
        scene_command=SCENE.replace("FILE", "scene.html"),
        machine=escape(str(this_machine())),
    )
    write_bytes(output / "index.html", page.encode())
    print(f"{output / 'index.html'}: {len(shots)} pictures")


if __name__ == "__main__":
    typer.run(main)
