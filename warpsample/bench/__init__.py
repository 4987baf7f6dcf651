"""Run time against what the machine can do, for `warpsample bench`."""
