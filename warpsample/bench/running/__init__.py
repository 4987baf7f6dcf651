"""How work is run to be timed: in turns, in processes of its own, on a machine that is told."""
