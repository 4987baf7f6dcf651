"""Tracing of rays against a mesh: ray origins on surfaces, and two ray tracers.

`rays` reads the user's rays and writes the hits. In between is a *query*, a `wp.func` that traces one ray in the scene's
float32 coordinates. `wide` has the queries of a 16-wide tree (`build` splits it, `boxes` fills it); `builtin` has those of
wp.Mesh. `starts` computes where the rays of surface points start. `scene` holds a mesh's search structures, and `trace` is
the public call.
"""
