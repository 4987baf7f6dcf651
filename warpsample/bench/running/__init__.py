"""Timing of benchmarks: interleaved runs, one process per tool, and a description of the machine."""
