"""Record of the sky view factor, for the command line, files and stores."""

from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.visibility import SkyView, sky_view_factor

_ON_RASTERS = (
    "cosine-weighted share of the sky that is seen from the middle of each cell: 1/pi times the integral of max(n.w, 0) "
    "over the directions w above the horizon along which nothing is met, n {normal}"
)

RECORD = Quantity(
    name="sky",
    call=sky_view_factor,
    title="sky view factor",
    value="the share of the sky that it sees; the share of the lobe below the horizon is separate",
    result=SkyView,
    on_rasters={
        "horizontal": _ON_RASTERS + "; with a horizon h to each azimuth the mean of cos(h)^2",
        "surface": _ON_RASTERS,
    },
)
