"""The laws, twins and defects that judge a sampler and its judges; used by `warpsample verify`, the tests and the viewer."""
