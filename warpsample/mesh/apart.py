"""Runs libraries that may crash in a separate Python process."""

import subprocess
import sys

REFUSED = 3
"""Exit status of a program that writes the reason of an error in place of a result."""


def answer_of(program: str, given: bytes = b"") -> tuple[int, bytes]:
    """Run a Python program in a new process with `given` as its standard input; return the exit status and standard output.

    An interrupt of this process ends the new process.
    """
    with subprocess.Popen(
        [sys.executable, "-c", program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
    ) as child:
        try:
            found = child.communicate(given)[0]
        finally:
            child.kill()
    return child.returncode, found
