"""Charts: groups of faces connected by corners with equal texture coordinates."""

import numpy as np

from warpsample.host.locks import imported


def label_charts(corners: np.ndarray) -> np.ndarray:
    """Return the (F,) int32 chart number of each face, counted from 0.

    Faces without coordinates get arbitrary numbers.

    Args:
        corners: (F, 3, k) float64, the values compared at each corner: texture coordinates, or coordinates and positions.
    """
    width = corners.shape[-1]
    flat = np.ascontiguousarray(np.nan_to_num(corners.reshape(-1, width)) + 0.0)  # + 0.0 turns -0 into 0
    _, corner = np.unique(flat.view(f"V{8 * width}").ravel(), return_inverse=True)
    a, b, c = corner.reshape(-1, 3).T
    sparse = imported("scipy.sparse")
    count = int(corner.max()) + 1
    links = sparse.coo_array((np.ones(2 * len(a), np.bool_), (np.r_[a, b], np.r_[b, c])), (count, count))
    _, chart = imported("scipy.sparse.csgraph").connected_components(links, directed=False)
    return chart[a].astype(np.int32)
