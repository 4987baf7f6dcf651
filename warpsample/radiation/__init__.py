"""Radiation on a mesh: direct sun, sky patches, weather files, reflections and view factors."""
