"""Record of ambient occlusion, for the command line, files and stores."""

from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import Share
from warpsample.estimate.visibility import ambient_occlusion

RECORD = Quantity(
    name="ao",
    call=ambient_occlusion,
    title="ambient occlusion",
    value="1 where it is open, 0 where it is closed in",
    result=Share,
)
