"""The statistics that judge a sampler; used by the tests and the viewer."""
