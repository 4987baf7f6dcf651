"""Python side of every call: checks of arguments, arrays, threads, locks and files."""
