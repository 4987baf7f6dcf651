"""Description of the quantity bent normals, from which its command-line options and files follow."""

from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.visibility import bent_normals

RECORD = Quantity(
    name="bent-normals",
    call=bent_normals,
    title="bent normals",
    value="mean of the directions that are not occluded",
    channels="xyz",
    black=-1.0,
)
