"""What a point sees: the one way by which estimates, sky, suns and faces ask the tree.

A kernel makes a `ShadingPoint` (`point`), opens the tree around it (`frontier`), asks what is in shafts of directions before
it casts rays (`shafts`, `search`, `cover`), and traces those that are left, a chunk at a time (`rays`), together where any
hit will do (`packets`).
"""
