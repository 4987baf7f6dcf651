"""Python side of all calls: checks of arguments, conversion of arrays, threads, devices and files."""
