"""Float32 building blocks that the compiler vectorises: nothing but `wp.func`s."""
