# SPDX-License-Identifier: GPL-3.0-or-later
"""Every kind of mesh by every filter and its main variants: refused in a sentence with the mesh untouched to
the last bit, or done with numbers that hold when they are worked out anew."""

import hostile_calls
import hostile_meshes
import pytest

# What runs always; the rest is for `pytest -m hostile`.
CORE = {
    ("hill", "newton"),
    ("hill", "newton, near"),
    ("two hills", "newton"),
    ("Möbius band", "newton"),
    ("Möbius band", "local"),
    ("octahedron", "newton"),
    ("octahedron", "maps"),
    ("book", "newton, fair"),
    ("slit cone", "newton"),
    ("handle", "flatten"),
    ("mixed sides", "local, descent"),
    ("hub", "maps, curvature"),
    ("bow tie", "conjugate gradient"),
    ("annulus", "flatten, cloth"),
    ("one triangle", "maps, energy"),
    ("one triangle", "leather"),
    ("saddle", "leather"),
    ("saddle", "cut, labels"),
    ("tunnel", "local, together"),
    ("crumpled", "local, uncut"),
    ("thin", "newton"),
    ("cylinder", "triangulate"),
}


CASES = [
    pytest.param(kind, variant, marks=() if (kind, variant) in CORE else pytest.mark.hostile)
    for kind in hostile_meshes.KINDS
    for variant in hostile_calls.VARIANTS
]


@pytest.mark.parametrize(("kind", "variant"), CASES)
def test_an_answer_holds(kind, variant):
    mesh = hostile_meshes.KINDS[kind]()
    answer = hostile_calls.answer_to(mesh, variant)
    assert hostile_calls.faults(answer, variant, kind in hostile_meshes.SIMPLE) == []


@pytest.mark.hostile
@pytest.mark.parametrize("variant", hostile_calls.VARIANTS)
@pytest.mark.parametrize("kind", hostile_meshes.KINDS)
def test_an_answer_holds_below_another_sheet(kind, variant):
    mesh = hostile_meshes.leaf_above(hostile_meshes.KINDS[kind]())
    answer = hostile_calls.answer_to(mesh, variant)
    assert hostile_calls.faults(answer, variant, kind in hostile_meshes.SIMPLE) == []


@pytest.mark.hostile
@pytest.mark.parametrize("variant", ["newton", "newton, fair", "flatten", "maps"])
@pytest.mark.parametrize("size", [45, 60, 75, 95])
@pytest.mark.parametrize("kind", ["hill", "saddle", "tunnel", "rough"])
def test_an_answer_holds_on_several_levels(kind, size, variant):
    """2000 to 9000 vertices, which are solved from coarse to fine."""
    mesh = {
        "hill": hostile_meshes.bump,
        "saddle": hostile_meshes.saddle,
        "tunnel": hostile_meshes.tunnel,
        "rough": hostile_meshes.rough,
    }[kind](size, size)
    answer = hostile_calls.answer_to(mesh, variant)
    assert hostile_calls.faults(answer, variant, simple=True) == []


def test_what_is_wrong_is_found():
    """The checks themselves can fail."""
    mesh = hostile_meshes.bump()
    answer = hostile_calls.answer_to(mesh, "newton")
    assert hostile_calls.faults(answer, "newton", simple=True) == []
    answer.numbers["max_displacement"] *= 1.1
    answer.numbers["total_absolute_curvature_after"] += 1e-3
    answer.numbers["seconds"] = float("nan")
    assert len(hostile_calls.faults(answer, "newton", simple=True)) == 1
    answer.numbers["seconds"] = 0.0
    assert len(hostile_calls.faults(answer, "newton", simple=True)) == 2
    folded = mesh[0].copy()
    folded[60] += (0.3, 0.3, 0)
    assert hostile_calls.count_flips(mesh[0], folded, mesh[1]) > 0
