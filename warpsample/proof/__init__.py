"""Statistical and numerical tests of samplers, second implementations to compare with, and tests of these tests."""
