"""Points on meshes and above them: at random, apart from each other, and on grids."""
