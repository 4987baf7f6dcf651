"""Record of the sky view factor, for the command line, files and stores."""

from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.visibility import SkyView, sky_view_factor

RECORD = Quantity(
    name="sky",
    call=sky_view_factor,
    title="sky view factor",
    value="the share of the sky that it sees; the share of the lobe below the horizon is separate",
    result=SkyView,
)
