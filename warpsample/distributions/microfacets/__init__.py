"""Distributions of microfacet normals, isotropic and anisotropic; each is defined in a file of its own."""
