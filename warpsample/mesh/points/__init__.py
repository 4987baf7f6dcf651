"""Sample points on and above meshes: random points, Poisson-disk points, and grids."""
