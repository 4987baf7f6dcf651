"""Sky patches, the sky matrix, and irradiance from distant light."""
