"""Numbers for each point, from rays that never reach memory: `estimate` has the calls."""
