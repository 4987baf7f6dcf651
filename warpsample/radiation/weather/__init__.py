"""Weather files, radiance of the sky, and irradiation of a year."""
