"""What the library tells of its work, under the name `warpsample` of Python's `logging`: nobody hears it by default.

`logging.basicConfig(level="INFO")` shows which kernels are compiled, which counts a tolerance came to, and the tiles.
"""

import logging

log: logging.Logger = logging.getLogger("warpsample")
log.addHandler(logging.NullHandler())
