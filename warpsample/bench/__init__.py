"""Run time against error, against other tools and against what the machine can do, for `warpsample bench`."""
