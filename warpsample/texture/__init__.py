"""Textures: texels as points on a mesh, images of numbers at them, and the .glb that carries them."""
