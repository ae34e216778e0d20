# SPDX-License-Identifier: GPL-3.0-or-later
"""No triangle turns over in what constrained Newton makes of rough bands with one side, and of sheets with a
hole; faces are compared across their edges, so that it does not matter whether a patch has two sides."""

import hostile_calls
import hostile_meshes
import numpy as np
import pytest


def roughened(mesh, share, seed):
    """The mesh with noise whose standard deviation is a share of the mean edge length."""
    positions, triangles = mesh
    edges = positions[triangles] - positions[np.roll(triangles, 1, axis=1)]
    noise = np.random.default_rng(seed).normal(size=positions.shape)
    return positions + share * np.linalg.norm(edges, axis=2).mean() * noise, triangles


BANDS = [(1, 16, 2), (1, 20, 3), (1, 26, 4), (3, 32, 5)]  # half turns, faces around, faces across
NOISE = [0.1, 0.2, 0.3]
SEEDS = range(10)


@pytest.mark.parametrize(
    "seed", [pytest.param(seed, marks=() if seed < 3 else pytest.mark.hostile) for seed in SEEDS]
)
@pytest.mark.parametrize("noise", NOISE)
@pytest.mark.parametrize("band", BANDS)
def test_rough_bands_with_one_side_do_not_turn_over(band, noise, seed):
    mesh = roughened(hostile_meshes.band(*band), noise, seed)
    answer = hostile_calls.answer_to(mesh, "newton")
    assert answer.numbers["status"] != hostile_calls.NOTHING_TO_DO
    assert hostile_calls.faults(answer, "newton", simple=False) == []


@pytest.mark.parametrize(
    "seed", [pytest.param(seed, marks=() if seed < 2 else pytest.mark.hostile) for seed in range(20)]
)
@pytest.mark.parametrize("noise", [0.05, 0.1, 0.2, 0.3])
def test_rough_sheets_with_a_hole_do_not_turn_over(noise, seed):
    answer = hostile_calls.answer_to(roughened(hostile_meshes.annulus(), noise, seed), "newton")
    assert answer.numbers["status"] != hostile_calls.NOTHING_TO_DO
    assert hostile_calls.faults(answer, "newton", simple=True) == []
