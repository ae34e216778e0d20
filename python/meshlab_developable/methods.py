# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays in, arrays and a report out."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import numpy.typing as npt
import pymeshlab

from meshlab_developable import parameters as kinds
from meshlab_developable import plugin
from meshlab_developable.errors import FilterError, InvalidMeshError, InvalidParameterError
from meshlab_developable.reports import LocalReport, Measures, OptimizationReport

Array = npt.NDArray[np.float64]

_METHODS: dict[str, tuple[str, dict[str, kinds.Kind], type[OptimizationReport]]] = {
    "global": ("apply_coord_global_developability", kinds.GLOBAL, OptimizationReport),
    "local": ("apply_coord_local_developability", kinds.LOCAL, LocalReport),
}


@dataclasses.dataclass(frozen=True)
class Measured:
    """What `measure` returns."""

    measures: Measures
    quality: Array  # n, the chosen map


@dataclasses.dataclass(frozen=True)
class Developed:
    """What `make_developable` returns."""

    vertices: Array  # n x 3, in the order given
    quality: Array  # n, the chosen map
    report: OptimizationReport  # for the local method a LocalReport


def measure(vertices: npt.ArrayLike, faces: npt.ArrayLike, **parameters: Any) -> Measured:
    """How developable a mesh is.

    vertices: n x 3, any unit of length. faces: m x 3 indices from 0. Connected components are the patches;
    vertices that coincide are linked. Parameters are those of the filter Developability Maps:
    `angle_tolerance` (rad), `weld_distance` (a length), `map` (a name of `parameters.MAPS`).

    Raises InvalidMeshError, InvalidParameterError, FilterError and what `load` raises.
    """
    values = kinds.convert(parameters, kinds.MEASURE, "measure")
    name = "compute_scalar_by_developability_per_vertex"
    _, quality, result = _run(name, vertices, faces, values)
    return Measured(Measures.from_values(result), quality)


def make_developable(
    vertices: npt.ArrayLike, faces: npt.ArrayLike, method: str = "global", **parameters: Any
) -> Developed:
    """Move the vertices so that each patch becomes developable, or nearer to it, and little else changes.

    vertices: n x 3, any unit of length. faces: m x 3 indices from 0. Connected components are the patches;
    vertices that coincide are linked and stay together. method: "global" (Wang and Tang 2004, Section 4, and
    the constrained Newton method) or "local" (Section 5). Parameters are those of the filters Global and
    Local Developability; lengths are plain numbers in the mesh's unit. The arrays given are not changed.

    Not converging is no error: see `report.status`. Raises InvalidMeshError, InvalidParameterError,
    FilterError and what `load` raises.
    """
    if method not in _METHODS:
        raise InvalidParameterError(
            f"method is {method!r}, but must be one of {', '.join(map(repr, _METHODS))}"
        )
    name, known, report_type = _METHODS[method]
    values = kinds.convert(parameters, known, f"the {method} method")
    positions, quality, result = _run(name, vertices, faces, values)
    return Developed(positions, quality, report_type.from_values(result))


def _run(
    filter_name: str, vertices: npt.ArrayLike, faces: npt.ArrayLike, values: dict[str, Any]
) -> tuple[Array, Array, dict[str, Any]]:
    """The filter's positions, quality and returned values. Nothing of pymeshlab's outlives this call: a mesh
    dies with its set."""
    positions, triangles = _checked(vertices, faces)
    plugin.load()
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(positions, triangles))
    try:
        result = meshes.apply_filter(filter_name, **values)
    except pymeshlab.PyMeshLabException as error:
        _forget_failure()
        raise FilterError(_own_words(str(error))) from error
    mesh = meshes.current_mesh()
    return np.array(mesh.vertex_matrix()), plugin.vertex_quality(mesh), result


def _forget_failure() -> None:
    """pymeshlab writes to the log of the document whose filter failed last when it next loads a
    file, though that document is gone by then. Any filter that succeeds makes it forget."""
    pymeshlab.MeshSet().create_cube()


def _checked(vertices: npt.ArrayLike, faces: npt.ArrayLike) -> tuple[Array, npt.NDArray[np.int32]]:
    """Copies in the types that pymeshlab takes."""
    try:
        positions = np.array(vertices, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InvalidMeshError(f"vertices must be numbers, n x 3: {error}") from None
    triangles = np.asarray(faces)
    if positions.ndim != 2 or positions.shape[1] != 3:
        raise InvalidMeshError(f"vertices must be n x 3, not of shape {positions.shape}")
    if triangles.ndim != 2 or triangles.shape[1] != 3:
        raise InvalidMeshError(
            f"faces must be m x 3, not of shape {triangles.shape}; triangulate other polygons"
        )
    if not np.issubdtype(triangles.dtype, np.integer):
        raise InvalidMeshError(f"faces must be whole numbers, not {triangles.dtype}")
    outside = int(((triangles < 0) | (triangles >= len(positions))).any(axis=1).sum())
    if outside:
        raise InvalidMeshError(
            f"{outside} faces name vertices that are not there: indices must lie from 0 to "
            f"{len(positions) - 1}"
        )
    return positions, triangles.astype(np.int32)


def _own_words(text: str) -> str:
    """The filter's message without pymeshlab's frame round it."""
    return text.split("Details:", 1)[-1].strip()
