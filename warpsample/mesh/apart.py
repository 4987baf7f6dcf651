"""Libraries that may end the process that they are in, and so get one of their own."""

import subprocess
import sys

REFUSED = 3
"""What such a process ends with where it gives a reason in place of what it was asked for."""


def answer_of(program: str, given: bytes = b"") -> tuple[int, bytes]:
    """The status and the output of Python that runs a program and reads what is given; it ends with an interrupt."""
    with subprocess.Popen(
        [sys.executable, "-c", program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
    ) as child:
        try:
            found = child.communicate(given)[0]
        finally:
            child.kill()
    return child.returncode, found
