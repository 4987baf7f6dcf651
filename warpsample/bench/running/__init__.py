"""Timing of work: interleaved runs, processes for single tools, and a description of the machine."""
