"""Weather files, the sky's radiance and a year's irradiation."""
