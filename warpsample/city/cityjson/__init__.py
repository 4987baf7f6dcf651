"""CityJSON: its surfaces as a mesh, and numbers of them written back into the file."""
