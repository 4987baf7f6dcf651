"""Values at the texels of meshes: `warpsample bake --texture`."""
