"""Light reflected diffusely between the faces of a mesh, any number of times."""
