"""Types of `warpsample.city.rasters`, of which this is another name."""

from warpsample.city.rasters import *
