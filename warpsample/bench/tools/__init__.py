"""What other tools and ours do at the tasks of the benchmarks, each as its own documentation would write it."""
