"""`python -m warpsample`."""

from warpsample.cli import main

main()
