"""What every call needs on this side of a kernel: arguments, arrays, threads, locks, files."""
