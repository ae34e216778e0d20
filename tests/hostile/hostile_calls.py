# SPDX-License-Identifier: GPL-3.0-or-later
"""Filters with their main variants, called in forked children, and what every answer has to be."""

from __future__ import annotations

import contextlib
import dataclasses
import os
import pickle
import signal
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import plugin_build
import pymeshlab
from measures import edges_of
from mesh_sets import GLOBAL, LOCAL, MAPS, Length, mesh_set, state_of
from reference_measures import angle_defects
from shapes import Mesh

FLATTEN, CUT = "generate_flat_patches", "meshing_cut_into_developable_panels"
TRIANGULATE = "meshing_polygons_to_constrained_delaunay"
CONVERGED, NOTHING_TO_DO = 0, 5
SECONDS = 120  # that a call may take

VARIANTS: dict[str, tuple[str, dict[str, Any]]] = {
    "newton": (GLOBAL, {}),
    "newton, fair": (GLOBAL, {"fairness": 0.3}),
    "newton, near": (GLOBAL, {"max_displacement": Length(0.01)}),
    "newton, borders held": (GLOBAL, {"fix_boundary": True}),
    "newton, smooth": (GLOBAL, {"smoothness": 1e-3, "max_iterations": 20}),
    "conjugate gradient": (GLOBAL, {"solver": "Conjugate gradient", "angle_tolerance": 0.01}),
    "leather": (GLOBAL, {"material": "Leather", "max_iterations": 30}),
    "bounds": (
        GLOBAL,
        {"allowed_stretch": 1.0, "allowed_compression": 3.0, "thickness": Length(0.01), "max_iterations": 30},
    ),
    "local": (LOCAL, {"max_operations": 5000}),
    "local, descent": (LOCAL, {"descent": True, "smoothing": 0.1, "max_operations": 5000}),
    "local, together": (LOCAL, {"assembling_vertices": "Move together", "max_operations": 5000}),
    "local, uncut": (LOCAL, {"avoid_self_intersections": True, "max_operations": 2000}),
    "maps": (MAPS, {}),
    "maps, curvature": (MAPS, {"map": "Maximum curvature"}),
    "maps, energy": (MAPS, {"map": "Elastic energy"}),
    "flatten": (FLATTEN, {}),
    "flatten, cloth": (FLATTEN, {"material": "Woven cloth", "grain": "X axis", "map": "Stretch"}),
    "cut": (CUT, {}),
    "cut, labels": (CUT, {"cut": False, "darts": False, "max_panels": 3}),
    "triangulate": (TRIANGULATE, {}),
}
MOVING = {name for name, (function, _) in VARIANTS.items() if function in (GLOBAL, LOCAL)}
NEWTON = {name for name in VARIANTS if name.startswith("newton")}


@dataclasses.dataclass
class Answer:
    """What a call came to, and what it was asked."""

    mesh: Mesh
    refusal: str = ""  # its sentence; empty when the filter has done its work
    untouched: bool = False  # the mesh is as before to the last bit
    numbers: dict[str, Any] = dataclasses.field(default_factory=dict)
    positions: np.ndarray | None = None  # after
    triangles: np.ndarray | None = None
    quality: np.ndarray | None = None
    pattern: np.ndarray | None = None  # positions of the layer that was added


def in_child(function: Callable[..., Any], *arguments: Any, seconds: int = SECONDS) -> Any:
    """What the function returns in a process of its own. Raises RuntimeError when that dies."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        code = 1
        try:
            os.close(read)
            signal.alarm(seconds)
            with os.fdopen(write, "wb") as pipe:
                pickle.dump(function(*arguments), pipe)
            code = 0
        finally:
            os._exit(code)
    os.close(write)
    with os.fdopen(read, "rb") as pipe:
        content = pipe.read()
    _, status = os.waitpid(child, 0)
    if status != 0:
        code = os.waitstatus_to_exitcode(status)
        raise RuntimeError(
            f"the child ended by {signal.Signals(-code).name}" if code < 0 else f"the child failed ({code})"
        )
    return pickle.loads(content)


def call(mesh: Mesh, function: str, parameters: dict[str, Any]) -> Answer:
    """The filter's answer."""
    plugin_build.load_plugin()
    meshes = mesh_set(mesh)
    before = state_of(meshes)
    answer = Answer(mesh)
    try:
        answer.numbers = meshes.apply_filter(function, **parameters)
    except pymeshlab.PyMeshLabException as error:
        answer.refusal = str(error).split("Details: ")[-1]
    answer.untouched = state_of(meshes) == before
    if meshes.mesh_number() > 1:
        answer.pattern = meshes.current_mesh().vertex_matrix()
        meshes.set_current_mesh(0)
    now = meshes.current_mesh()
    answer.positions, answer.triangles = now.vertex_matrix(), now.face_matrix()
    answer.quality = now.vertex_scalar_array()
    return answer


def answer_to(mesh: Mesh, variant: str) -> Answer:
    """The answer of a variant, from a child."""
    function, parameters = VARIANTS[variant]
    answer = in_child(call, mesh, function, parameters)
    assert isinstance(answer, Answer)
    return answer


def faults(answer: Answer, variant: str, simple: bool) -> list[str]:
    """What is wrong with an answer, in words. simple: every vertex is one copy."""
    if answer.refusal:
        return list(_faults_of_refusal(answer))
    found = list(_faults_of_numbers(answer, variant))
    if variant in MOVING and not found:
        found += _faults_of_moves(answer, variant)
        if simple:
            found += _faults_of_curvature(answer, variant)
    return found


def _faults_of_refusal(answer: Answer) -> Iterator[str]:
    if not answer.untouched:
        yield "a refused mesh has changed"
    if not answer.refusal.strip().endswith(".") or len(answer.refusal) < 30:
        yield f"no sentence: {answer.refusal!r}"
    if "nan" in answer.refusal.lower().split() or "inf" in answer.refusal.lower().split():
        yield f"a sentence with what is no number: {answer.refusal!r}"


def _faults_of_numbers(answer: Answer, variant: str) -> Iterator[str]:
    positions, triangles = answer.mesh
    for name, value in answer.numbers.items():
        if not np.isfinite(value):
            yield f"{name} is {value}"
    for name in ("positions", "quality", "pattern"):
        values = getattr(answer, name)
        if values is not None and not np.isfinite(values).all():
            yield f"{name} that are not finite"
    assert answer.positions is not None
    if not variant.startswith("cut"):
        if not np.array_equal(answer.triangles, triangles):
            yield "other faces"
        if variant not in MOVING and not np.array_equal(answer.positions, positions):
            yield "vertices have moved"
    elif not np.array_equal(answer.positions[: len(positions)], positions):
        yield "vertices have moved"


def _faults_of_moves(answer: Answer, variant: str) -> Iterator[str]:
    positions, triangles = answer.mesh
    numbers, after = answer.numbers, answer.positions
    moved = np.linalg.norm(after - positions, axis=1)
    if abs(moved.max() - numbers["max_displacement"]) > 1e-9 * (1 + moved.max()):
        yield f"a vertex moved by {moved.max()}, reported as {numbers['max_displacement']}"
    if variant == "newton, near" and moved.max() > 0.01 * (1 + 1e-12):
        yield f"a vertex moved by {moved.max()}"
    bounded = variant in ("leather", "bounds")
    if not bounded and numbers["detect_function_after"] > numbers["detect_function_before"] * (1 + 1e-9):
        yield "G has risen"
    if numbers["converged"] != (numbers["status"] in (CONVERGED, NOTHING_TO_DO)):
        yield "converged, and not so by its status"
    if numbers["status"] == NOTHING_TO_DO and moved.max() > 0:
        yield "moved though there was nothing to do"
    if variant in NEWTON:
        turned = count_flips(positions, after, triangles)
        if turned:
            yield f"{turned} flipped pairs of faces"


def _faults_of_curvature(answer: Answer, variant: str) -> Iterator[str]:
    positions, triangles = answer.mesh
    numbers = answer.numbers
    for shape, when in ((positions, "before"), (answer.positions, "after")):
        defects = angle_defects(shape, triangles)
        own = {
            "total_absolute_curvature": np.abs(defects).sum(),
            "max_angle_defect": np.abs(defects).max(),
            "detect_function": (defects**2).sum(),
        }
        for name, value in own.items():
            if abs(value - numbers[f"{name}_{when}"]) > 1e-6 * (1 + value):
                yield f"{name}_{when} is {value}, reported as {numbers[f'{name}_{when}']}"
    if variant in NEWTON and numbers["converged"]:
        panels = numbers["panels_converged"]
        if panels != numbers["patches"] or numbers["panels_need_cut"] != 0:
            yield f"converged with {panels} of {numbers['patches']} panels"
        if np.abs(defects).max() > 1.01e-4 or np.abs(defects).sum() > 1.01e-4 * numbers["patches"]:
            yield f"converged with {np.abs(defects).sum()} rad left"


def count_flips(before: np.ndarray, after: np.ndarray, triangles: np.ndarray) -> int:
    """Pairs of faces at an edge whose normals made less than 90 degrees and now make more than 120."""

    def normals(positions: np.ndarray) -> np.ndarray:
        a, b, c = (positions[triangles[:, i]] for i in range(3))
        normal = np.cross(b - a, c - a)
        return normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]

    start, end = normals(before), normals(after)
    directed = {(int(t[i]), int(t[(i + 1) % 3])): n for n, t in enumerate(triangles) for i in range(3)}
    flips = 0
    for (a, b), faces in edges_of(triangles).items():
        if len(faces) != 2:
            continue
        # Neighbours that are turned alike run along their edge in opposite directions.
        sign = 1 if (a, b) in directed and (b, a) in directed else -1
        one, other = faces
        # Steps may end at 120 degrees to the last bit.
        flips += sign * start[one] @ start[other] > 1e-6 and sign * end[one] @ end[other] < -0.5 - 1e-12
    return flips


@contextlib.contextmanager
def on_threads(number: int) -> Iterator[None]:
    """What children are told of the number of threads."""
    before = os.environ.get("OMP_NUM_THREADS")
    os.environ["OMP_NUM_THREADS"] = str(number)
    try:
        yield
    finally:
        if before is None:
            del os.environ["OMP_NUM_THREADS"]
        else:
            os.environ["OMP_NUM_THREADS"] = before
