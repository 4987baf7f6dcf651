"""Quantities that `warpsample bake` computes from rays about the normal, such as ambient occlusion; one file each."""
