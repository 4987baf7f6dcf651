"""The 16-wide tree: how it lies in memory, is built and is asked."""
