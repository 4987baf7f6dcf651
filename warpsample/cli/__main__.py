"""`python -m warpsample.cli`."""

from warpsample.cli import main

main()
