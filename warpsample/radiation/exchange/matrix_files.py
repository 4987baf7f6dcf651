"""Reader and writer of Radiance's matrix files: a text header, an empty line, and float32 numbers row by row."""

from typing import BinaryIO

import numpy as np

from warpsample.host.arguments import quote

_BLOCK = 1 << 22  # numbers that are written at a time
_COLOURS = 3
_LONGEST = 1 << 16  # longest header in bytes
_WANTS = "a Radiance matrix with NROWS, NCOLS, NCOMP, FORMAT=float and an empty line before its numbers"


def write_matrix(stream: BinaryIO, matrix: np.ndarray, factor: float = 1.0, ground: bool = True) -> None:
    """Write factor * matrix (P, K) in Radiance's matrix format, which `dctimestep` and `rmtxop` read.

    The numbers are grey, in three colours. With `ground`, a column of zeros for the ground is written first.
    """
    rows, columns = matrix.shape
    total = columns + ground
    stream.write(f"#?RADIANCE\nNROWS={rows}\nNCOLS={total}\nNCOMP={_COLOURS}\nBigEndian=0\nFORMAT=float\n\n".encode("ascii"))
    block = max(1, _BLOCK // (_COLOURS * total))
    for first in range(0, rows, block):
        part = matrix[first : first + block]
        colours = np.zeros((len(part), total, _COLOURS), "<f4")
        colours[:, int(ground) :] = (factor * part.astype(np.float64))[:, :, None]
        stream.write(colours.tobytes())


def read_matrix(content: bytes, argument: str = "matrix") -> np.ndarray:
    """Read a Radiance matrix of float32; return the (NROWS, NCOLS, NCOMP) float32 array.

    Raises:
        ValueError: not such a matrix, or the number of values differs from the header.
    """
    head, empty, _ = content[:_LONGEST].partition(b"\n\n")
    fields = dict(line.split("=", 1) for line in head.decode("latin-1").splitlines() if "=" in line)
    fields = {key.strip(): text.strip() for key, text in fields.items()}
    shape = tuple(int(fields[key]) if fields.get(key, "").isdecimal() else 0 for key in ("NROWS", "NCOLS", "NCOMP"))
    if not empty or fields.get("FORMAT") != "float" or min(shape) < 1:
        raise ValueError(f"{argument}: got {quote(head)}, want {_WANTS}")
    numbers = len(content) - len(head) - len(empty)
    if numbers != 4 * shape[0] * shape[1] * shape[2]:
        raise ValueError(f"{argument}: got {numbers:,} bytes of numbers, want 4 x {' x '.join(map(str, shape))}")
    kind = ">f4" if fields.get("BigEndian") == "1" else "<f4"
    return np.frombuffer(content, kind, offset=len(head) + len(empty)).astype(np.float32).reshape(shape)
