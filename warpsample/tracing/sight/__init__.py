"""Visibility from one point, by searches and rays; used for estimates, sky, sun and view factors.

A kernel makes a `ShadingPoint` (`point`) and opens the tree around the point (`frontier`). It searches shafts, which are
pyramids of directions, before it casts rays (`shafts`, `search`, `cover`). It traces the remaining rays one chunk at a time
(`rays`), as one packet where any hit is enough (`packets`).
"""
