"""Every picture of the READMEs, and a page that shows them: `python viz/gallery.py`."""

import base64
import subprocess
import sys
from dataclasses import dataclass
from html import escape
from importlib.util import find_spec
from pathlib import Path
from string import Template
from tempfile import TemporaryDirectory
from typing import Annotated

import typer

from warpsample.bench.running.machine import describe_machine
from warpsample.cli.terminal import fail_plainly, with_progress
from warpsample.host.files import check_output_folder, write_bytes
from warpsample.plotting import rendering

HERE = Path(__file__).parent


@dataclass(frozen=True)
class Shot:
    """A picture.

    Attributes:
        name: the name of its file, without suffix.
        title: stands above it on the page.
        text: stands below it.
        command: makes it, after `python`; FILE stands for the picture, FOLDER for a folder for it.
        needs: a module of an extra; without it there is no picture.
    """

    name: str
    title: str
    text: str
    command: str
    needs: str = "warpsample"


SHOTS = (
    Shot(
        "direction_clouds",
        "The viewer",
        "Each direction is drawn as long as the cosine lobe's density, so correct samples form small, evenly covered "
        "spheres that rest on the surface. Below, one cloud is enlarged in its tangent frame; at the right, the angles of "
        "all directions are compared with the density.",
        "viz/direction_clouds.py --screenshot FILE",
    ),
    Shot(
        "direction_clouds_wrong",
        "A wrong sampler",
        "A ball in place of the sphere, compared with the cosine lobe, has too many directions near the normal.",
        "viz/direction_clouds.py --distribution offset_ball --density cosine_hemisphere --screenshot FILE",
    ),
    Shot(
        "shirley_overlay",
        "Shirley's trick, Keinert's proof",
        "A sphere's points plus the normal, normalised, are green, and the cosine set is red. Where both are, the light "
        "is yellow. A ball in place of the sphere does not agree.",
        "viz/shirley_overlay.py --screenshot FILE",
    ),
    Shot(
        "offset_family",
        "The projected offset sets",
        "A circle, disk, sphere or ball about the tip of the normal is projected onto the unit circle or sphere; the "
        "angles follow the densities below. Then spheres of other radii, and the half angle of the proof.",
        "viz/offset_family.py --screenshot FILE",
    ),
    Shot(
        "sequences",
        "Where the points come from",
        "The sequences on the square and on the hemisphere, and the errors of means over their directions.",
        "viz/sequences.py --screenshot FILE",
    ),
    Shot(
        "occlusion",
        "Ambient occlusion",
        "Ambient occlusion at the bunny's vertices, its standard error, and the number of rays that were cast.",
        "viz/occlusion.py --screenshot FILE",
    ),
    Shot(
        "baked_texture",
        "Ambient occlusion in a texture",
        "The bunny before and after its ambient occlusion is baked into a texture with new coordinates, and the standard "
        "errors of its texels.",
        "viz/baked_texture.py --screenshot FILE",
        needs="xatlas",
    ),
    Shot(
        "sun_and_sky",
        "Sun and sky",
        "What a cloudless year in Athens brings to a courtyard's faces, what an hour of June does, and the sky above the "
        "ground that sees least of it, with the sun's paths.",
        "viz/sun_and_sky.py --screenshot FILE",
    ),
    Shot(
        "view_factors",
        "View factors of a face",
        "What a face of a courtyard's ground, outlined in blue, sees of the others, the standard errors, "
        "and what each face sees of the sky.",
        "viz/view_factors.py --screenshot FILE",
    ),
    Shot(
        "baked_store",
        "A store read back",
        "The sky view of a courtyard's vertices, baked into a Zarr store by chunks, and the chunk that each vertex is in: "
        "nothing of them is seen in the numbers.",
        "viz/baked_store.py --screenshot FILE",
        needs="zarr",  # there is none for Python 3.10
    ),
    Shot(
        "maps",
        "Maps of terrain and of a city",
        "A real hillside by lidar, the share of the sky that each of its cells sees, and what a cloudless year in Athens "
        "would bring to the roofs and walls of real buildings.",
        "viz/maps.py --screenshot FILE",
        needs="rasterio",
    ),
    Shot(
        "light_between",
        "Light between faces and through them",
        "A day in June in a courtyard of black faces and of ones that send back 0.4 of what they receive, and in the shade "
        "of a tree whose crown lets 0.2 through.",
        "viz/light_between.py --screenshot FILE",
    ),
    Shot(
        "glossy_reflection",
        "A kernel of one's own: glossy reflections",
        "An environment map filtered for surfaces of growing roughness, as renderers do before they look it up; below, a "
        "ball that reflects it.",
        "viz/glossy_reflection.py --screenshot FILE",
    ),
    Shot(
        "direct_light",
        "A kernel of one's own: the light of a lamp",
        "The same number of rays, by the cosine lobe at the left and to the lamp alone at the right: where rays are sent "
        "matters more than how many there are.",
        "viz/direct_light.py --screenshot FILE",
    ),
    Shot(
        "bench_error",
        "Which sequence",
        "Root mean square error against run time.",
        "-m warpsample.cli bench error --plot FOLDER",
    ),
    Shot(
        "bench_rays",
        "Rays",
        "The speed of rays beside Embree, Open3D and wp.Mesh.",
        "-m warpsample.cli bench rays --plot FOLDER",
    ),
    Shot(
        "bench_visibility",
        "Time to an error",
        "The time in which ambient occlusion reaches an error, beside other tools.",
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
<p>Directions around the normals of a mesh, sampled by NVIDIA Warp kernels on the CPU.
Below each picture stands the command that makes it.</p>
$figures
<h2>The clouds, to turn by the mouse</h2>
<figure><iframe title="clouds on the bunny" srcdoc="$scene"></iframe>
<figcaption><code>python $scene_command</code></figcaption></figure>
<footer>$machine</footer>
</body></html>
""")
_FIGURE = Template("""<h2>$title</h2>
<figure><img alt="$title" src="data:image/png;base64,$data">
<figcaption><p>$text</p><p>$said</p><code>python $command</code></figcaption></figure>""")


def make(command: str, file: Path) -> str:
    """Runs a Shot's command in the folder above this one, and puts its picture into `file`.

    Returns:
        What the command printed about the picture.

    Raises:
        RuntimeError: it failed; the message ends with its last line on stderr.
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
    return "The tables are in warpsample/bench/README.md."


@fail_plainly()
def main(
    output: Annotated[
        Path, typer.Option("--output", "-o", help="The folder for the pictures and index.html; it is made if it is missing.")
    ] = Path("gallery"),
    benchmarks: Annotated[bool, typer.Option(help="With the benchmarks' pictures, which take eleven minutes.")] = True,
) -> None:
    """Make every picture of the READMEs, and a page that shows them and needs no other file."""
    check_output_folder(output, "--output")
    rendering.check_rendering()
    output.mkdir(parents=True, exist_ok=True)
    figures = []
    shots = [shot for shot in SHOTS if find_spec(shot.needs) and (benchmarks or "FOLDER" not in shot.command)]
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
        machine=escape(str(describe_machine())),
    )
    write_bytes(output / "index.html", page.encode())
    print(f"{output / 'index.html'}: {len(shots)} pictures")


if __name__ == "__main__":
    typer.run(main)
