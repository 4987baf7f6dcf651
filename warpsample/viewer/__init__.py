"""Viewer of directions on a mesh: settings, lobes, clouds, knobs and window; and the PyVista accessor `mesh.warpsample`."""
