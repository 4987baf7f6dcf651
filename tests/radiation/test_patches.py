"""The patches of the sky: their number, order, size and place, against a program of the tests' own."""

import numpy as np
import pytest
from sky_cases import edges, local_directions

import warpsample as ws

SETS = {"tregenza": (1, 145, 3.15880), "reinhart2": (2, 577, 3.14620), "reinhart4": (4, 2305, 3.14279)}


@pytest.mark.parametrize("name", SETS)
def test_the_patches_are_those_of_radiance(name):
    multiple, number, along_up = SETS[name]
    patches, expected = ws.sky_patches(name), edges(multiple)
    assert len(patches) == number
    assert np.abs(np.radians(np.hstack([patches.altitudes, patches.azimuths])) - expected).max() <= 1e-12
    assert abs(patches.solid_angles.sum() - 2.0 * np.pi) <= 1e-12
    assert abs(patches.solid_angles @ patches.directions[:, 2] - along_up) <= 5e-6
    assert np.abs(np.linalg.norm(patches.directions, axis=1) - 1.0).max() <= 1e-15
    assert (np.diff(patches.rows) >= 0).all()
    assert patches.rows.max() == 7 * multiple
    for k in (0, 1, number // 2, number - 2, number - 1):
        w = local_directions(expected[k], 64, 64)
        mean = w.mean(axis=0) / np.linalg.norm(w.mean(axis=0))
        assert np.abs(mean - patches.directions[k]).max() <= 0.01


def test_the_first_patch_straddles_north_and_the_second_is_east_of_it():
    """Neither mirrored, nor turned by half a patch, nor with the ground in front."""
    patches = ws.sky_patches("tregenza")
    assert patches.directions[0] @ [0, 1, 0] == pytest.approx(np.cos(np.radians(6.0)), abs=1e-12)
    assert patches.directions[0, 0] == 0.0
    assert patches.directions[1, 0] == pytest.approx(np.cos(np.radians(6.0)) * np.sin(np.radians(12.0)), abs=1e-12)
    assert patches.azimuths[0].tolist() == [-6.0, 6.0]
    assert patches.directions[-1].tolist() == [0.0, 0.0, 1.0]
    assert (patches.directions[:, 2] > 0.0).all()


def test_rows_of_different_sets_do_not_nest():
    coarse, fine = (np.unique(ws.sky_patches(name).altitudes) for name in ("tregenza", "reinhart2"))
    assert np.abs(coarse[1:-1, None] - fine[None, :]).min() > 0.2


def test_up_and_north_turn_the_patches():
    plain = ws.sky_patches("tregenza")
    turned = ws.sky_patches("tregenza", up=(2.0, 0.0, 0.0), north=(5.0, 0.0, -3.0))  # north is -z, and east -y
    assert turned.north == (0.0, 0.0, -1.0)
    there = plain.directions @ np.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])
    assert np.abs(turned.directions - there).max() <= 1e-15
    assert np.array_equal(turned.solid_angles, plain.solid_angles)
    assert np.abs(turned.directions @ turned.frame.T - plain.directions).max() <= 1e-15


@pytest.mark.parametrize("north", [(0, 0, 1), (0, 0, -3.0), (0.0, 1e-12, 1.0)])
def test_a_north_along_up_is_refused(north):
    with pytest.raises(ValueError, match=r"^north: got .*, which is along up, want a direction not parallel to up"):
        ws.sky_patches("tregenza", north=north)


def test_the_arrays_cannot_be_changed():
    patches = ws.sky_patches("tregenza")
    for array in (patches.directions, patches.solid_angles, patches.rows, patches.altitudes, patches.azimuths):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
