"""The 16-wide tree: layout in memory, construction, and traversal by rays."""
