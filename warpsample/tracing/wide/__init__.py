"""The 16-wide tree: its layout in memory, how it is built, and how rays traverse it."""
