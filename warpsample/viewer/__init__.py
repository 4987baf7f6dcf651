"""Interactive viewer of sampled directions on a mesh, and the PyVista accessor `mesh.warpsample`."""
