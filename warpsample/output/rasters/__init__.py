"""Values in the cells of rasters of heights: `warpsample bake dsm.tif`."""
