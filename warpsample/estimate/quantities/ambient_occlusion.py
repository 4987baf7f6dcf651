"""Description of the quantity ambient occlusion, from which its command-line options and files follow."""

from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import OpenShare
from warpsample.estimate.visibility import ambient_occlusion

_ON_RASTERS = (
    "cosine-weighted share of the directions w from the centre of each cell in which a ray hits nothing: 1/pi times the "
    "integral of max(n.w, 0) over these directions; the normal n is {normal}"
)

RECORD = Quantity(
    name="ao",
    call=ambient_occlusion,
    title="ambient occlusion",
    value="1 in the open, 0 where all directions are occluded",
    result=OpenShare,
    on_rasters={"horizontal": _ON_RASTERS, "surface": _ON_RASTERS},
)
