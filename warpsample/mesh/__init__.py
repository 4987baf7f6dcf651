"""Checked triangle meshes, their files, and points on their surfaces."""
