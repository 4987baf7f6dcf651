"""CityJSON: surfaces as a mesh, and results written back into the file."""
