# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes as pymeshlab takes them: from arrays, from files, and from what trimesh and meshio hold."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Protocol, TypeAlias, runtime_checkable

import numpy as np
import numpy.typing as npt
import pymeshlab

from meshlab_developable import materials, plugin
from meshlab_developable.declared_counts import declared_faces
from meshlab_developable.errors import (
    DevelopableError,
    FilterError,
    InvalidMeshError,
    InvalidParameterError,
    LostFacesWarning,
)
from meshlab_developable.filters import Filter
from meshlab_developable.names import printable
from meshlab_developable.parameters import Length, per_cent

Array: TypeAlias = npt.NDArray[np.float64]
IndexArray: TypeAlias = npt.NDArray[np.int32]

_POINT_FORMATS = (".e57", ".xyz")  # without faces, of those that pymeshlab writes
_ROOM = 1 << 16  # bytes; more than a block of any disk

_LEAST_LENGTH, _GREATEST_LENGTH = 1e-37, 1e38  # of those that parameters have, in single precision

# A length given as a plain number; pymeshlab 2022.2 has it under the second name.
_PlainLength = getattr(pymeshlab, "PureValue", None) or pymeshlab.AbsoluteValue
_Share = getattr(pymeshlab, "PercentageValue", None) or pymeshlab.Percentage


@runtime_checkable
class TrimeshMesh(Protocol):
    """What is asked of an object of trimesh."""

    vertices: Any  # n x 3
    faces: Any  # m x 3


@runtime_checkable
class MeshioMesh(Protocol):
    """What is asked of an object of meshio."""

    points: Any  # n x 3
    cells_dict: Any  # arrays of vertex indices, by the kind of cell


Source: TypeAlias = npt.ArrayLike | str | os.PathLike[str] | TrimeshMesh | MeshioMesh


def open_mesh(source: Source, faces: npt.ArrayLike | None = None, verbose: bool = False) -> pymeshlab.MeshSet:
    """A set with the mesh as its current layer.

    source: vertices (n x 3) beside faces (m x 3 indices from 0); or, without faces, a file that pymeshlab,
    trimesh or meshio reads, or an object of trimesh or meshio. Of a file that pymeshlab reads itself colours,
    texture coordinates, quality and selection come along, of an object its texture coordinates.
    A verbose set prints what filters say while they run.

    Raises InvalidMeshError.
    """
    if faces is not None:
        return _from_arrays(source, faces)
    if isinstance(source, (str, os.PathLike)):
        meshes = _read_file(Path(source))
        meshes.set_verbosity(verbose)
        return meshes
    if isinstance(source, TrimeshMesh):
        return _from_arrays(source.vertices, source.faces, _texture_coordinates(source))
    if isinstance(source, MeshioMesh):
        return _from_arrays(source.points, _triangles(source))
    raise InvalidMeshError(
        f"a mesh is two arrays, vertices and faces, or a file, or an object of trimesh or meshio; "
        f"this is only {type(source).__name__}"
    )


def apply_filter(meshes: Any, applied: Filter, values: Mapping[str, Any]) -> dict[str, Any]:
    """Apply a filter of the plugin to the current layer; the values are checked ones. Returns its numbers.

    Raises FilterError in the filter's own words, and InvalidParameterError for lengths that pymeshlab would
    take for nothing or for infinite.
    """
    plugin.load()
    converted = {
        name: _length(meshes, name, value) if isinstance(applied.parameter(name).kind, Length) else value
        for name, value in values.items()
    }
    try:
        with materials.handed_over(converted) as plain:
            result: dict[str, Any] = meshes.apply_filter(applied.function, **plain)
    except pymeshlab.PyMeshLabException as error:
        forget_failure()
        raise told(error, FilterError) from error
    return result


def _length(meshes: Any, name: str, value: float | str) -> Any:
    """As pymeshlab takes lengths: in the mesh's unit, or as a share of the diagonal of the mesh's box."""
    if isinstance(value, str):
        share = per_cent(value)
        length = share / 100 * float(meshes.current_mesh().bounding_box().diagonal())
        kept = _Share(share)
    else:
        length = float(value)
        kept = _PlainLength(length)
    if length and not _LEAST_LENGTH <= abs(length) <= _GREATEST_LENGTH:
        raise InvalidParameterError(
            f"{name} is a length of {length:.3g}, and pymeshlab keeps lengths from {_LEAST_LENGTH:g} to "
            f"{_GREATEST_LENGTH:g}: scale the mesh to an ordinary size"
        )
    return kept


def save(meshes: Any, path: Path) -> None:
    """Write the current layer with its quality and colours.

    Raises InvalidMeshError in the writer's own words. A full disk is no error to many a writer.
    """
    if path.suffix.lower() == ".u3d":  # it ends without the file, but with one beside some folder above
        raise InvalidMeshError("pymeshlab's writer of U3D does not work: choose another format")
    try:
        meshes.save_current_mesh(_name(path))
    except pymeshlab.PyMeshLabException as error:
        forget_failure()
        raise told(error, InvalidMeshError) from None


def missing_elements(meshes: Any, path: Path) -> str:
    """What of the current layer is not in the file that it was written to, in words; empty when nothing is.

    Of formats that pymeshlab writes but does not read it is only seen that they are not empty, and that there
    is still room beside them. Raises InvalidMeshError when the file cannot be read again, and OSError.
    """
    again = _load(path)
    if again is None:
        path.with_name("room").write_bytes(bytes(_ROOM))
        return "" if path.stat().st_size else "all faces"
    written, found = meshes.current_mesh(), again.current_mesh()
    if path.suffix.lower() in _POINT_FORMATS:
        missing, elements = written.vertex_number() - found.vertex_number(), "vertices"
    else:
        missing, elements = written.face_number() - found.face_number(), "faces"
    return f"{missing} {elements}" if missing > 0 else ""


def add_layer(meshes: Any, source: Source, faces: npt.ArrayLike | None = None) -> int:
    """Add a mesh behind the current layer, which stays the current one; the new one's number."""
    current = meshes.current_mesh_id()
    others = open_mesh(source, faces)  # a mesh dies with its set
    meshes.add_mesh(others.current_mesh(), "reference")
    number: int = meshes.current_mesh_id()
    meshes.set_current_mesh(current)
    return number


def select_faces(meshes: Any, chosen: npt.ArrayLike) -> None:
    """Select the faces of the current layer for which a mask is True."""
    mesh = meshes.current_mesh()
    mask = _mask(chosen, mesh.face_number(), "only_selected", "faces")
    mesh.add_face_custom_scalar_attribute(mask, "chosen_face")
    meshes.apply_filter("compute_selection_by_condition_per_face", condselect="chosen_face > 0")


def select_vertices(meshes: Any, chosen: npt.ArrayLike) -> None:
    """Select the vertices of the current layer for which a mask is True."""
    mesh = meshes.current_mesh()
    mask = _mask(chosen, mesh.vertex_number(), "fix_selected", "vertices")
    mesh.add_vertex_custom_scalar_attribute(mask, "chosen_vertex")
    meshes.apply_filter("compute_selection_by_condition_per_vertex", condselect="chosen_vertex > 0")


def rebuilt(meshes: Any, face_labels: npt.ArrayLike | None, corners: npt.ArrayLike | None) -> Any:
    """The current layer's triangles in a set of their own, with labels as face quality and texture
    coordinates at the faces' corners."""
    mesh = meshes.current_mesh()
    extras: dict[str, Any] = {}
    if face_labels is not None:
        extras["f_scalar_array"] = _labels(face_labels, mesh.face_number())
    if corners is not None:
        extras["w_tex_coords_matrix"] = _corners(corners, mesh.face_matrix(), mesh.vertex_number())
    made = pymeshlab.MeshSet()
    made.add_mesh(pymeshlab.Mesh(mesh.vertex_matrix(), mesh.face_matrix(), **extras))
    return made


def forget_failure() -> None:
    """pymeshlab writes to the log of the document whose filter failed last when it next loads a
    file, though that document is gone by then. Any filter that succeeds makes it forget."""
    pymeshlab.MeshSet().create_cube()


def told(error: Exception, kind: type[DevelopableError]) -> Exception:
    """What pymeshlab raised, in the raiser's own words; MemoryError where memory was short."""
    text = own_words(str(error))
    return MemoryError(text) if "bad_alloc" in text else kind(text)


def own_words(text: str) -> str:
    """A message without pymeshlab's frame round it."""
    return text.split("Error details:", 1)[-1].split("Details:", 1)[-1].strip()


def _read_file(path: Path) -> pymeshlab.MeshSet:
    if not path.is_file():
        raise InvalidMeshError(f"there is no file {path}")
    try:
        declared = declared_faces(path)
        meshes = _load(path)
    except InvalidMeshError as error:
        raise InvalidMeshError(f"{path} cannot be read: {error}") from None
    if meshes is None:
        return _read_otherwise(path)
    found = meshes.current_mesh().face_number()
    if found == 0:
        raise InvalidMeshError(
            f"{path} has no faces{f' that can be read, of {declared}' if declared else ''}"
        )
    if declared is not None and found < declared:
        warnings.warn(
            f"{declared - found} of the {declared} faces in {path} were left out when it was read: they name "
            "vertices that are not there, have no number as a coordinate, or name a vertex twice",
            LostFacesWarning,
            stacklevel=4,
        )
    return meshes


def _load(path: Path) -> pymeshlab.MeshSet | None:
    """What pymeshlab reads in a file; None when it does not know the format.

    Raises InvalidMeshError in the reader's own words, and MemoryError.
    """
    meshes = pymeshlab.MeshSet()
    try:
        meshes.load_new_mesh(_name(path))
    except pymeshlab.PyMeshLabException as error:
        if "Unknown format" in str(error):
            return None
        forget_failure()
        raise told(error, InvalidMeshError) from None
    except MemoryError:
        raise MemoryError(f"{path} needs more memory than there is; is its header right?") from None
    except (ValueError, RuntimeError) as error:  # of the libraries below the readers
        raise InvalidMeshError(f"malformed file ({error})") from None
    return meshes


def _name(path: Path) -> str:
    """The path as pymeshlab takes it, which is as text."""
    name = str(path)
    if name != printable(name):
        raise InvalidMeshError("its path is not UTF-8; rename it")
    return name


def _from_arrays(vertices: Any, faces: Any, corners: Array | None = None) -> pymeshlab.MeshSet:
    extras = {} if corners is None else {"w_tex_coords_matrix": corners}
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*_checked(vertices, faces), **extras))
    return meshes


def _read_otherwise(path: Path) -> pymeshlab.MeshSet:
    """Through meshio or trimesh, whichever knows the format."""
    import meshio
    import trimesh

    try:
        if path.suffix.lower() in meshio.extension_to_filetypes:
            return open_mesh(meshio.read(path))
        return open_mesh(trimesh.load_mesh(path, process=False))
    except InvalidMeshError:
        raise
    except (Exception, SystemExit) as error:
        # meshio ends the program, with a number, where it finds no sense in a file
        why = "malformed file" if isinstance(error, SystemExit) else str(error) or type(error).__name__
        raise InvalidMeshError(f"{path} cannot be read: {why}") from None


def _texture_coordinates(mesh: Any) -> Array | None:
    coordinates = getattr(getattr(mesh, "visual", None), "uv", None)
    if coordinates is None:
        return None
    corners: Array = np.asarray(coordinates, dtype=np.float64)[np.asarray(mesh.faces).ravel()]
    return corners


def _triangles(mesh: Any) -> npt.NDArray[Any]:
    kinds = mesh.cells_dict
    others = sorted(set(kinds) - {"triangle", "line", "vertex"})
    if others:
        raise InvalidMeshError(f"the mesh has cells of kind {', '.join(others)}; triangulate them first")
    if "triangle" not in kinds:
        raise InvalidMeshError("the mesh has no triangles")
    return np.asarray(kinds["triangle"])


def _checked(vertices: Any, faces: Any) -> tuple[Array, IndexArray]:
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
    if not len(positions) or not len(triangles):
        raise InvalidMeshError(
            f"a mesh needs vertices and faces; this has {len(positions)} vertices and {len(triangles)} faces"
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


def _mask(chosen: npt.ArrayLike, count: int, name: str, elements: str) -> Array:
    mask = np.asarray(chosen)
    if mask.shape != (count,) or mask.dtype != np.bool_:
        raise InvalidMeshError(
            f"{name} must have True or False for each of the {count} {elements}, "
            f"not {mask.dtype} of shape {mask.shape}"
        )
    return mask.astype(np.float64)


def _labels(face_labels: npt.ArrayLike, count: int) -> Array:
    labels = np.asarray(face_labels)
    if labels.shape != (count,):
        raise InvalidMeshError(f"face_labels must have one for each of the {count} faces, not {labels.shape}")
    unknown = np.flatnonzero(labels != labels)  # NaN only is not itself, in arrays of objects as well
    if len(unknown):
        raise InvalidMeshError(
            f"{len(unknown)} of the {count} face_labels are no numbers, the first that of face {unknown[0]}: "
            "give each face a label"
        )
    return np.unique(labels, return_inverse=True)[1].astype(np.float64)


def _corners(coordinates: npt.ArrayLike, faces: IndexArray, vertex_count: int) -> Array:
    """At each corner of each face, one below the other."""
    given = np.asarray(coordinates, dtype=np.float64)
    if given.shape == (vertex_count, 2):
        return given[faces.ravel()]
    if given.shape == (len(faces), 3, 2):
        return given.reshape(-1, 2)
    raise InvalidMeshError(
        f"texture_coordinates must be {vertex_count} x 2, of the vertices, or {len(faces)} x 3 x 2, of the "
        f"faces' corners, not of shape {given.shape}"
    )
