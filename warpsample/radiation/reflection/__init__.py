"""Diffuse reflections between the faces of a mesh, in all orders."""
