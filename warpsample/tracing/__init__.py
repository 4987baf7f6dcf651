"""Rays against a mesh: where they come from, and two tracers that answer them.

`rays` reads a user's rays and writes the answers; what stands between is a *query*, a `wp.func` that takes a ray in the
scene's own float32 coordinates. `wide` has those of a 16-wide tree (`build` splits it, `boxes` fills it), `builtin` those
of wp.Mesh; `starts` says where the rays of points on the surface start; `scene` holds what either needs of a mesh, and
`trace` is the call.
"""
