"""The level at which statistical tests reject: a correct suite fails by chance on one machine in 10^4."""

STATISTICAL_TESTS = 500  # more than the suite makes; conftest.py counts them
ALPHA = 1e-4 / STATISTICAL_TESTS
