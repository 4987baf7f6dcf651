"""Reading of CityJSON files as meshes, and writing of results back into the files."""
