# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a shape lies, how large it is and how its vertices and faces are numbered changes neither the verdict
nor how far vertices move; nor does the number of threads change a bit."""

import hostile_calls
import hostile_meshes
import numpy as np
import pytest
from mesh_sets import Length

SCALES = [1e-160, 1e-100, 1e-30, 1e-6, 1e6, 1e30, 1e80]
TURN = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
TURN *= np.linalg.det(TURN)


def shuffled_vertices(positions, triangles):
    order = np.random.default_rng(2).permutation(len(positions))
    return positions[order], np.argsort(order)[triangles]


def shuffled_faces(positions, triangles):
    order = np.random.default_rng(3).permutation(len(triangles))
    return positions, np.array([np.roll(t, i % 3) for i, t in enumerate(triangles[order])])


CHANGES = {
    "shifted": lambda p, t: (p + np.array([100, -200, 50]), t),
    "turned": lambda p, t: (p @ TURN.T, t),
    "mirrored": lambda p, t: (p * (-1, 1, 1), t[:, ::-1]),
    "inside out": lambda p, t: (p, t[:, ::-1]),
    "vertices in another order": shuffled_vertices,
    "faces in another order": shuffled_faces,
}
# What of the numbers has to stay, and within what share of itself: the local method hangs on the last bits.
# A saddle has several equally near developable shapes, and last bits decide: over 40 meshes that differ from
# it by them alone the mean move is 7 % less to 12 % more than the saddle's own.
TIES = {"saddle"}
NUMBERS = {
    "newton": {"mean_displacement": 0.05, "total_absolute_curvature_before": 1e-6},
    "conjugate gradient": {"mean_displacement": 0.02, "total_absolute_curvature_after": 0.02},
    "leather": {"mean_displacement": 0.15},
    "maps": {"total_absolute_curvature": 1e-6, "max_angle_defect": 1e-6},
    "flatten": {"max_edge_strain": 0.01, "mean_edge_strain": 0.01},
    "local": {"detect_function_before": 1e-6},
    "cut": {},
}
CORE = {"newton", "maps", "flatten"}


def verdict(answer, variant):
    """What has to be the same: refused or not, and how it ended."""
    if answer.refusal:
        return answer.refusal.split(":")[-1].split(" See ")[0]
    if variant == "local":  # its end hangs on the last bits: see docs/examples.md
        return answer.numbers["detect_function_after"] < 0.5 * answer.numbers["detect_function_before"]
    return answer.numbers.get("status"), answer.numbers.get("panels_converged"), answer.numbers.get("pieces")


def assert_alike(one, other, variant, scale=1.0, tie=False):
    assert verdict(one, variant) == verdict(other, variant)
    assert hostile_calls.faults(other, variant, simple=False) == [] or scale != 1.0
    if one.refusal:
        return
    for name, share in NUMBERS[variant].items():
        power = 1 if "displacement" in name else 0
        allowed = 0.2 if tie and power else share
        assert other.numbers[name] / scale**power == pytest.approx(
            one.numbers[name], rel=allowed, abs=1e-12
        ), name


def chosen(variants, core=CORE):
    return [pytest.param(v, marks=() if v in core else pytest.mark.hostile) for v in variants]


def kinds(core):
    return [
        pytest.param(kind, marks=() if kind in core else pytest.mark.hostile)
        for kind in (
            "hill",
            "saddle",
            "tunnel",
            "two hills",
            "annulus",
            "slit cone",
            "Möbius band",
            "octahedron",
        )
    ]


@pytest.mark.parametrize("variant", chosen(NUMBERS))
@pytest.mark.parametrize("kind", kinds({"saddle", "two hills"}))
def test_place_and_numbering_do_not_matter(kind, variant):
    mesh = hostile_meshes.KINDS[kind]()
    before = hostile_calls.answer_to(mesh, variant)
    for name, change in CHANGES.items():
        if kind == "Möbius band" and name == "inside out":
            continue
        answer = hostile_calls.answer_to(change(*mesh), variant)
        assert_alike(before, answer, variant, tie=kind in TIES)


@pytest.mark.parametrize("variant", chosen(NUMBERS))
@pytest.mark.parametrize("kind", kinds({"tunnel"}))
def test_size_does_not_matter(kind, variant):
    positions, triangles = hostile_meshes.KINDS[kind]()
    before = hostile_calls.answer_to((positions, triangles), variant)
    for scale in SCALES:
        answer = hostile_calls.answer_to((positions * scale, triangles), variant)
        if not answer.refusal:
            assert all(np.isfinite(value) for value in answer.numbers.values()), (scale, answer.numbers)
            assert np.isfinite(answer.positions).all()
            assert np.isfinite(answer.quality).all()
            assert answer.pattern is None or np.isfinite(answer.pattern).all()
        assert_alike(before, answer, variant, scale, kind in TIES)


# Hosts keep lengths in single precision; what digits were typed is guessed, and not the same at all sizes.
WITHOUT_LENGTHS = {
    name: (function, parameters)
    for name, (function, parameters) in hostile_calls.VARIANTS.items()
    if not any(isinstance(value, Length) for value in parameters.values())
}


@pytest.mark.parametrize("variant", chosen(WITHOUT_LENGTHS, CORE | {"cut"}))
@pytest.mark.parametrize("kind", kinds({"saddle"}))
def test_a_power_of_four_times_the_size_changes_no_bit(kind, variant):
    """Digits are the same, and those of square roots of lengths: no constant has a length in it."""
    positions, triangles = hostile_meshes.KINDS[kind]()
    first = hostile_calls.answer_to((positions, triangles), variant)
    for scale in (2.0**-300, 2.0**-80, 2.0**-6, 2.0**40, 2.0**80, 2.0**300):
        answer = hostile_calls.answer_to((positions * scale, triangles), variant)
        assert verdict(answer, variant) == verdict(first, variant), scale
        assert np.array_equal(answer.positions, first.positions * scale), scale
        assert np.array_equal(answer.triangles, first.triangles), scale
        if answer.pattern is not None:
            assert np.array_equal(answer.pattern, first.pattern * scale), scale


@pytest.mark.parametrize(
    "variant", [*chosen(NUMBERS), pytest.param("local, uncut", marks=pytest.mark.hostile)]
)
@pytest.mark.parametrize("scale", [1e-200, 1e-165, 1e155, 1e300])
def test_what_is_too_large_or_too_small_is_refused(variant, scale):
    positions, triangles = hostile_meshes.saddle()
    answer = hostile_calls.answer_to((positions * scale, triangles), variant)
    assert answer.refusal.endswith("scale it down." if scale > 1 else "scale it up.")
    assert answer.untouched


@pytest.mark.parametrize("variant", ["newton", "conjugate gradient", "local"])
@pytest.mark.parametrize("scale", [1e-160, 1.0, 1e80])
def test_any_limit_of_steps_comes_to_an_end(variant, scale):
    positions, triangles = hostile_meshes.tunnel()
    function, parameters = hostile_calls.VARIANTS[variant]
    limit = "max_operations" if variant == "local" else "max_iterations"
    answer = hostile_calls.in_child(
        hostile_calls.call, (positions * scale, triangles), function, {**parameters, limit: 2147483647}
    )
    assert answer.numbers["status"] in (0, 1)


@pytest.mark.parametrize("variant", ["newton", "leather", "flatten"])
def test_the_number_of_threads_changes_no_bit(variant):
    one, two = hostile_meshes.two_bumps(), hostile_meshes.tunnel()
    mesh = np.vstack([one[0], two[0] + (5, 0, 0)]), np.vstack([one[1], two[1] + len(one[0])])
    answers = []
    for threads in (1, 2):
        with hostile_calls.on_threads(threads):
            answers.append(hostile_calls.answer_to(mesh, variant))
    assert not answers[0].refusal
    assert np.array_equal(answers[0].positions, answers[1].positions)
    for name, value in answers[0].numbers.items():
        assert name == "seconds" or value == answers[1].numbers[name], name
