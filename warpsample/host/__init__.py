"""The host side of every call: arguments, arrays, threads, locks, files."""
