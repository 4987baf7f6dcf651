"""The shafts about patches and groups of them hold all of them, and little else."""

from itertools import pairwise

import numpy as np
import pytest

import warpsample as ws
from warpsample.radiation.sky.shafts import groups_of, shafts_of
from warpsample.tracing.sight.shafts import CORNERS, PLANES


def rims(patches, starts):
    """(G, n, 3) directions on the rim of each group of patches, the cap's all around its lower edge."""
    share, found = np.linspace(0.0, 1.0, 33), []
    for begin, end in pairwise(starts):
        low, high = np.radians(patches.altitudes[begin])
        first, last = np.radians(patches.azimuths[begin, 0]), np.radians(patches.azimuths[end - 1, 1])
        across, up = first + (last - first) * share, low + (high - low) * share
        azimuth = np.concatenate([across, across, 0.0 * up + first, 0.0 * up + last])
        altitude = np.concatenate([0.0 * across + low, 0.0 * across + high, up, up])
        along = np.cos(altitude)
        found.append(np.stack([along * np.sin(azimuth), along * np.cos(azimuth), np.sin(altitude)], axis=1) @ patches.frame)
    return np.array(found)


@pytest.mark.parametrize("grouped", [False, True], ids=["patches", "groups"])
@pytest.mark.parametrize("name", ["tregenza", "reinhart2", "reinhart4"])
def test_shafts_hold_their_patches_and_touch_them(name, grouped):
    """Each plane has the patches on its inner side and touches them; so do those through neighbouring corners."""
    patches = ws.sky_patches(name, up=(0.2, -0.3, 1.0), north=(1.0, 2.0, 0.0))
    starts = groups_of(patches) if grouped else np.arange(len(patches) + 1)
    shafts = np.swapaxes(shafts_of(patches, starts).astype(np.float64), 1, 2)
    rim = rims(patches, starts)
    inside = np.einsum("gpc,gnc->gpn", shafts[:, 1:PLANES], rim)
    assert inside.min() >= -2e-7  # of float32
    assert inside.min(axis=2).max() <= 1e-6
    corners = shafts[:, PLANES : PLANES + CORNERS]
    sides = corners[:, [1, 3, 2, 0]]  # around; those of the cap are in order
    sides[-1] = corners[-1]
    walls = np.cross(sides, np.roll(sides, -1, axis=1))
    walls /= np.linalg.norm(walls, axis=2, keepdims=True)
    walls *= np.sign(np.einsum("gkc,gc->gk", walls, rim.mean(axis=1)))[:, :, None]
    inside = np.einsum("gpc,gnc->gpn", walls, rim)
    assert inside.min() >= -2e-7
    assert inside.min(axis=2).max() <= 1e-6
