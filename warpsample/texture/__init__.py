"""Texture baking: texels as points on a mesh, images of computed values, and glTF files that show the images."""
