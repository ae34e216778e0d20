# SPDX-License-Identifier: GPL-3.0-or-later
"""Files in, files and a report out, with all that a file holds: colours, texture coordinates, quality."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from meshlab_developable import mesh_sets
from meshlab_developable.departure import departure_of
from meshlab_developable.errors import InvalidMeshError, WriteError
from meshlab_developable.filters import FLATTEN, MAPS
from meshlab_developable.flattening import FlatteningResult, flattened_layer
from meshlab_developable.material_verdict import judged
from meshlab_developable.methods import METHODS
from meshlab_developable.panels import panel_reports
from meshlab_developable.reports import Measures, OptimizationReport
from meshlab_developable.writing import written_whole


def measure_file(
    source: Path, target: Path | None = None, reference: Path | None = None, **parameters: Any
) -> Measures:
    """Measure a file's mesh; write it with the map as quality and colours when there is a target.

    Parameters are those of the filter Developability Maps. Raises InvalidMeshError, InvalidParameterError,
    FilterError, WriteError and what `load` raises.
    """
    values = MAPS.checked(parameters)
    meshes = mesh_sets.open_mesh(source)
    if reference is not None:
        values["reference"] = mesh_sets.add_layer(meshes, reference)
    result = mesh_sets.apply_filter(meshes, MAPS, values)
    if target is not None:
        save_whole(meshes, target)
    return Measures.from_values(result)


def develop_file(
    source: Path, target: Path, method: str = "global", verbose: bool = False, **parameters: Any
) -> OptimizationReport:
    """Make a file's mesh developable and write it, with the map as quality and colours.

    method: "global" or "local"; parameters are those of its filter. When verbose, the filter prints what it
    does. Raises as `measure_file` does; the target is written whole or not at all.
    """
    applied, report_type = METHODS[method]
    values = applied.checked(parameters)
    meshes = mesh_sets.open_mesh(source, verbose=verbose)
    result = mesh_sets.apply_filter(meshes, applied, values)
    meshes.set_verbosity(False)
    save_whole(meshes, target)
    mesh_after = meshes.current_mesh()
    report = report_type.from_values(result, panel_reports(mesh_after)).compared(departure_of(mesh_after))
    return judged(report, values)


def flatten_file(
    source: Path, target: Path, textured: Path | None = None, verbose: bool = False, **parameters: Any
) -> FlatteningResult:
    """Lay a file's mesh flat and write the pieces as a mesh in the plane z = 0.

    textured: where the mesh goes, with the pieces as its texture coordinates; not written when None.
    Parameters are those of the filter Flatten Patches. Raises as `measure_file` does.
    """
    values = FLATTEN.checked(parameters)
    meshes = mesh_sets.open_mesh(source, verbose=verbose)
    model = meshes.current_mesh_id()
    flat = flattened_layer(meshes, values | {"write_texture_coordinates": textured is not None})
    meshes.set_verbosity(False)
    save_whole(meshes, target)
    if textured is not None:
        meshes.set_current_mesh(model)
        save_whole(meshes, textured)
    return flat


def save_whole(meshes: Any, target: Path, scratch: Path | None = None) -> None:
    """Write the current layer so that the target is at no moment half written.

    Hosts say nothing of a disk that is full: what was written is read again, and replaces what was there when
    nothing is missing. scratch: see `written_whole`. Raises WriteError.
    """
    with written_whole(target, scratch) as path:
        try:
            mesh_sets.save(meshes, path)
            missing = mesh_sets.missing_elements(meshes, path)
        except InvalidMeshError as error:
            raise WriteError(
                f"{target} cannot be written: {str(error).replace(str(path), str(target))}"
            ) from None
        if missing:
            raise WriteError(
                f"{target} cannot be written whole: {missing} are missing when it is read again; is the disk "
                "full, or the mesh too large for the format?"
            )
