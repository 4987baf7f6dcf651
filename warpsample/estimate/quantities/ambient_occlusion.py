"""Record of ambient occlusion, for the command line, files and stores."""

from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import Share
from warpsample.estimate.visibility import ambient_occlusion

_ON_RASTERS = (
    "cosine-weighted share of the directions about the middle of each cell along which nothing is met: 1/pi times the "
    "integral of max(n.w, 0) over them, n {normal}"
)

RECORD = Quantity(
    name="ao",
    call=ambient_occlusion,
    title="ambient occlusion",
    value="1 where it is open, 0 where it is closed in",
    result=Share,
    on_rasters={"horizontal": _ON_RASTERS, "surface": _ON_RASTERS},
)
