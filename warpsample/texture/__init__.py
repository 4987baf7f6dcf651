"""Texture baking: quantities computed at the texels of a mesh, as images and in glTF files."""
