"""Parts of a scene that are placed by a matrix each."""

import numpy as np
import pytest

from warpsample.mesh.joining import joined

CORNERS, FACE = np.eye(3), np.array([[0, 1, 2]])


@pytest.mark.parametrize("scale", [1e-3, 0.5, 1.0, 30.0])
@pytest.mark.parametrize("mirrored", [False, True], ids=["as it is", "mirrored"])
def test_parts_are_turned_only_where_they_are_mirrored(scale, mirrored):
    """However small: a part of half the size has a determinant of an eighth."""
    matrix = np.diag([-scale if mirrored else scale, scale, scale, 1.0])
    matrix[3, :3] = 5.0, 6.0, 7.0
    vertices, faces = joined([(CORNERS, FACE, np.eye(4)), (CORNERS, FACE, matrix)])
    assert vertices[3:] == pytest.approx(CORNERS * np.diag(matrix)[:3] + [5.0, 6.0, 7.0])
    assert faces.tolist() == [[0, 1, 2], [5, 4, 3] if mirrored else [3, 4, 5]]
