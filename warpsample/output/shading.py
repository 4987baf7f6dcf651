"""`warpsample shading`: write the sunlit fraction of groups of faces for each hour, as EnergyPlus reads it."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from warpsample.host.arguments import check_file, check_integer, check_seed, quote
from warpsample.host.engine import check_workers
from warpsample.host.files import check_output, complete_or_absent
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.gltf import describe_invisible
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.points.sampling import sample_surface
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.sky.patches import sky_patches
from warpsample.radiation.sun.direct_sun import direct_sun
from warpsample.radiation.weather.epw import YEAR
from warpsample.radiation.weather.light import sun_directions
from warpsample.radiation.weather.weather import read_weather

_MOST_POINTS = 2**20  # of a group, whose suns stand in memory: four gigabytes


@dataclass(frozen=True)
class Shading:
    """Arguments of a `warpsample shading` command.

    Attributes:
        mesh: Path of the mesh.
        groups: Path of a text file with a line for each triangle: the name of the surface that contains the triangle.
        output: Path of the .csv to write.
        weather: Path of an EPW file, for the place and the hours.
        samples: Number of points per group, uniform by area.
        up: Direction of the zenith.
        north: Direction of north.
        seed: Random seed of the points.
    """

    mesh: Path
    groups: Path
    output: Path
    weather: Path
    samples: int
    up: tuple[float, float, float]
    north: tuple[float, float, float]
    seed: int


def write_shading(run: Shading, workers: int | None = None) -> str:
    """Write the .csv of sunlit fractions: a row for each hour of the year, named by its end, and a column per surface.

    A value is the fraction of a surface's area that sees the centre of the sun in the middle of the hour. The value is 0 at
    night and on surfaces that face away from the sun. N random points give a standard error of at most 0.5 / sqrt(N).

    Returns:
        a report in one sentence.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used, before anything is computed.
        WriteError: the file cannot be written.
    """
    if run.output.suffix != ".csv":
        raise ValueError(f"--output: got {str(run.output)!r}, want a file that ends in .csv")
    check_output(run.output, "--output", run.mesh, run.groups, run.weather)
    check_integer(run.samples, "--samples", 1, _MOST_POINTS)
    check_seed(run.seed)
    check_workers(workers)
    axes = sky_patches(up=run.up, north=run.north).frame
    mesh = load_mesh(run.mesh)
    names, group = _groups(run.groups, mesh)
    weather = read_weather(run.weather)
    rows = np.flatnonzero(weather.sun_altitude > 0.0)
    suns = sun_directions(weather.chosen(rows), axes)
    shares = np.zeros((len(YEAR), len(names)))
    for column in range(len(names)):
        points = _points_of(mesh, np.flatnonzero(group == column), run.samples, run.seed, column * run.samples)
        shares[rows, column] = direct_sun(mesh, points, suns, workers=workers).mean(axis=0, dtype=np.float64)
    invisible = describe_invisible(run.mesh)
    with complete_or_absent(run.output) as file:
        file.write(f"Surface Name,{','.join(names)}\n".encode())
        for (month, day, hour), row in zip(YEAR, shares.tolist(), strict=True):
            file.write(f"{month:02}/{day:02} {hour:02}:00,{','.join(f'{share:.6f}' for share in row)}\n".encode())
    error = np.sqrt(np.mean(shares[rows] * (1.0 - shares[rows])) / run.samples)
    report = (
        f"{len(names):,} surfaces, {len(YEAR):,} hours; standard error {error:.2g} while the sun is up, root mean square"
    )
    return "; ".join([report, *invisible])


def _groups(path: Path, mesh: Mesh) -> tuple[list[str], np.ndarray]:
    """Return the names of the groups, in the order of the file, and the (F,) index of the group of each face.

    Raises:
        ValueError: a wrong number of lines, or a name that is empty or that a .csv cannot hold.
    """
    wants = f"{len(mesh.faces):,} lines, each with the name of its triangle's surface"
    found = check_file(path, "groups", f"a text file of {wants}").read_bytes()
    try:
        lines = [line.strip() for line in found.decode("utf-8-sig").splitlines()]
    except UnicodeDecodeError:
        raise ValueError(f"groups: got {str(path)!r}, which is not UTF-8, want {wants}") from None
    if len(lines) != len(mesh.faces):
        raise ValueError(f"groups: got {str(path)!r} of {len(lines):,} lines, want {wants}")
    names = list(dict.fromkeys(lines))
    for name in names:
        if not name or set(name) & set(',"'):
            raise ValueError(f"groups: got {str(path)!r} with the name {quote(name)}, want names without commas and quotes")
    number = {name: i for i, name in enumerate(names)}
    group = np.array([number[line] for line in lines])
    empty = np.flatnonzero(np.bincount(group, mesh.face_areas, len(names)) <= 0.0)
    if len(empty):
        raise ValueError(
            f"groups: got {str(path)!r} with the surface {quote(names[empty[0]])}, whose triangles have no area, want "
            "an area above 0"
        )
    return names, group


def _points_of(mesh: Mesh, faces: np.ndarray, count: int, seed: int, first_point: int) -> SurfacePoints:
    """Return points on some faces, uniform by area; points of different groups are independent."""
    points = sample_surface(Mesh(mesh.vertices, mesh.faces[faces]), count, seed=seed, first_point=first_point)
    return SurfacePoints(points.position, points.normal, faces[points.face].astype(np.int32))
