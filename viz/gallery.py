"""All pictures of the READMEs, and a page that shows the pictures: `python viz/gallery.py`."""

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
    """Picture of the gallery and the command that makes it.

    Attributes:
        name: name of the file without suffix.
        title: heading above the picture.
        text: text below the picture.
        command: arguments of `python`; FILE is replaced by the path of the picture, FOLDER by a folder for the picture.
        needs: module of an extra that the command requires. Without this module the picture is left out.
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
        "The length of each direction is the density of the cosine lobe, so correct directions form small, evenly covered "
        "spheres on the surface. Below, one cloud is enlarged in its tangent frame. The charts compare the angles of all "
        "directions with the density.",
        "viz/direction_clouds.py --screenshot FILE",
    ),
    Shot(
        "direction_clouds_wrong",
        "A wrong sampler",
        "Points in a ball in place of the sphere, compared with the cosine lobe: too many directions are near the normal.",
        "viz/direction_clouds.py --distribution offset_ball --screenshot FILE",
    ),
    Shot(
        "shirley_overlay",
        "Shirley's trick, Keinert's proof",
        "Points on a sphere plus the normal, normalised, are green, and the cosine set is red. Directions of both sets are "
        "yellow. Points in a ball in place of the sphere do not agree with the cosine set.",
        "viz/shirley_overlay.py --screenshot FILE",
    ),
    Shot(
        "offset_family",
        "The projected offset sets",
        "A circle, disk, sphere or ball about the tip of the normal is projected onto the unit circle or sphere. The charts "
        "show the angles with their densities, then spheres of other radii, and the half angle of the proof.",
        "viz/offset_family.py --screenshot FILE",
    ),
    Shot(
        "sequences",
        "Point sequences",
        "The sequences on the unit square and on the hemisphere, and the errors of means over their directions.",
        "viz/sequences.py --screenshot FILE",
    ),
    Shot(
        "own_lobes",
        "A lobe for each point",
        "Points of a surface with varying roughness and brush lines reflect the camera, each in a lobe of its own. One lobe "
        "is enlarged; the maps compare the density of its directions with the density of the lobe.",
        "viz/own_lobes.py --screenshot FILE",
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
        "Irradiation of a courtyard in a cloudless year in Athens, its irradiance in one hour of June, and the sky "
        "above the ground with the smallest sky view, with the paths of the sun.",
        "viz/sun_and_sky.py --screenshot FILE",
    ),
    Shot(
        "environment_map",
        "Rays from a picture of the sky",
        "Rays about the normal miss a small sun. Rays to bright pixels of the sky find the sun, and both together give the "
        "smallest error. Each column shows its rays and the light that they compute on the bunny.",
        "viz/environment_map.py --screenshot FILE",
    ),
    Shot(
        "view_factors",
        "View factors of a face",
        "View factors from one face of a courtyard's ground, outlined in blue, to all other faces, their standard errors, "
        "and the sky view factor of each face.",
        "viz/view_factors.py --screenshot FILE",
    ),
    Shot(
        "baked_store",
        "A store read back",
        "The sky view factors of a courtyard's vertices, baked into a Zarr store by chunks, and the chunk of each vertex. "
        "The numbers show no borders between chunks.",
        "viz/baked_store.py --screenshot FILE",
        needs="zarr",  # not available for Python 3.10
    ),
    Shot(
        "maps",
        "Maps of terrain and of a city",
        "A real hillside measured by lidar, the visible share of the sky in each cell, and the irradiation of the roofs and "
        "walls of real buildings under the weather of a cloudless year in Athens.",
        "viz/maps.py --screenshot FILE",
        needs="rasterio",
    ),
    Shot(
        "light_between",
        "Light between faces and through them",
        "Irradiation on a day in June of a courtyard with faces that reflect nothing or 40 % of the light, and of the "
        "ground below a tree whose crown transmits 20 %.",
        "viz/light_between.py --screenshot FILE",
    ),
    Shot(
        "glossy_reflection",
        "User-defined kernel: glossy reflections",
        "An environment map filtered for four roughnesses, as renderers do before lookups; below, balls with surfaces of "
        "these roughnesses.",
        "viz/glossy_reflection.py --screenshot FILE",
    ),
    Shot(
        "direct_light",
        "User-defined kernel: the light of a lamp",
        "The same number of rays, with directions of the cosine lobe at the left and directions to the lamp at the right. "
        "The errors differ by a factor of ninety.",
        "viz/direct_light.py --screenshot FILE",
    ),
    Shot(
        "bench_error",
        "Error by run time",
        "Root mean square error of means over the cosine lobe by run time, for each point sequence.",
        "-m warpsample.cli bench error --plot FOLDER",
    ),
    Shot(
        "bench_rays",
        "Rays",
        "Speed of rays of warpsample, Embree, Open3D and wp.Mesh.",
        "-m warpsample.cli bench rays --plot FOLDER",
    ),
    Shot(
        "bench_visibility",
        "Time to an error",
        "Time per point to reach an error of ambient occlusion, of warpsample and other tools.",
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
Below each picture is the command that makes it.</p>
$figures
<h2>The clouds as a scene: turn it with the mouse</h2>
<figure><iframe title="clouds on the bunny" srcdoc="$scene"></iframe>
<figcaption><code>python $scene_command</code></figcaption></figure>
<footer>$machine</footer>
</body></html>
""")
_FIGURE = Template("""<h2>$title</h2>
<figure><img alt="$title" src="data:image/png;base64,$data">
<figcaption><p>$text</p><p>$summary</p><code>python $command</code></figcaption></figure>""")


def make(command: str, file: Path) -> str:
    """Make one picture of the gallery: run its command in the root of the checkout, which writes the picture to `file`.

    Returns:
        the command's line about the picture.

    Raises:
        RuntimeError: the command failed; the message ends with the last line of its stderr.
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
        Path, typer.Option("--output", "-o", help="Folder for the pictures and index.html. A missing folder is created.")
    ] = Path("gallery"),
    benchmarks: Annotated[
        bool, typer.Option(help="Run the benchmarks for their pictures, which takes eleven minutes.")
    ] = True,
) -> None:
    """Make all pictures of the READMEs, and a page that shows the pictures and needs no other file."""
    check_output_folder(output, "--output")
    rendering.check_rendering()
    output.mkdir(parents=True, exist_ok=True)
    figures = []
    shots = [shot for shot in SHOTS if find_spec(shot.needs) and (benchmarks or "FOLDER" not in shot.command)]
    for shot in with_progress(shots, len(shots), "drawing"):
        file = output / f"{shot.name}.png"
        summary = make(shot.command, file)
        data = base64.b64encode(file.read_bytes()).decode()
        command = shot.command.replace("FILE", file.name).replace("FOLDER", ".")
        figures.append(
            _FIGURE.substitute(title=shot.title, text=shot.text, summary=escape(summary), command=command, data=data)
        )
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
