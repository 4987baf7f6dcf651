"""Tables, pictures and pages of benchmark results."""
