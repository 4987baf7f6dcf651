"""The viewer: choice (what is asked for), lobes and clouds (what is drawn), controls (the knobs), window (where)."""
