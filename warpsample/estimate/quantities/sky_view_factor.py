"""Description of the quantity sky view factor, from which its command-line options and files follow."""

from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.visibility import SkyView, sky_view_factor

_ON_RASTERS = (
    "cosine-weighted share of the sky that is visible from the centre of each cell: 1/pi times the integral of max(n.w, 0) "
    "over the directions w above the horizon in which a ray hits nothing; the normal n is {normal}"
)

RECORD = Quantity(
    name="sky",
    call=sky_view_factor,
    title="sky view factor",
    value="share of the sky that is visible, weighted by the cosine of the angle to the normal",
    result=SkyView,
    on_rasters={
        "horizontal": _ON_RASTERS + "; if each azimuth has one horizon h, the mean of cos(h)^2",
        "surface": _ON_RASTERS,
    },
)
