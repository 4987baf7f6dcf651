"""What radiation people call: sun, sky patches, weather, view factors."""
