"""Let `import warpsample.rasters` give the module `warpsample.city.rasters`."""

import sys

from warpsample.city import rasters

TYPE_CHECKING = False
if TYPE_CHECKING:
    from warpsample.city.rasters import *  # noqa: F403

sys.modules[__name__] = rasters
