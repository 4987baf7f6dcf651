"""Irradiance as a quantity of the command line and of stores."""

from typing import Any

from warpsample.estimate.quantities.record import Numbers, Quantity
from warpsample.host.picture import read_picture
from warpsample.mesh.mesh import Mesh
from warpsample.radiation.sky.irradiance import Irradiance, irradiance


def _prepare(mesh: Mesh, _total: int, *, radiance: Any, **options: Any) -> Numbers:
    """Read the picture of the light, and return a function that computes the irradiance of surface points."""
    picture = read_picture(radiance)
    return lambda points, first: irradiance(mesh, points, picture, first_point=first, **options)


RECORD = Quantity(
    name="irradiance",
    call=irradiance,
    title="irradiance",
    value="light of an equirectangular picture, an .hdr or .npy file, or of a `wp.func` of the direction",
    result=Irradiance,
    files={"environment": "a picture of the light, .hdr or .npy"},
    prepare=_prepare,
    example="radiance=np.ones((2, 4))",
)
