"""Mathematical `wp.func`s, mostly float32, that the compiler turns into vector instructions."""
