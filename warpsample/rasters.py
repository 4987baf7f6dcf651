"""Let `import warpsample.rasters` give the module `warpsample.city.rasters`."""

import sys

from warpsample.city import rasters

sys.modules[__name__] = rasters
