"""Direct sunlight: the sun positions that each surface point sees."""
