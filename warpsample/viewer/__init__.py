"""The viewer: lobes (what is seen), window (where), controls (by which knobs)."""
