# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts every mesh of a folder into panels, makes them developable, lays them flat, and prints a table.

`bash bench/run.sh cut FOLDER [noise=SHARE] [name=value...]`, with parameters of the filter; those of the
material hold for all three steps. With noise, vertices are moved along their normals first, at random, by
that share of a mean edge (standard deviation). Seams and distances are shares of the diagonal D of the
input's box; distances are from the result's vertices to the input's surface. Beside it how long seams are
beside smooth curves, and the charts of xatlas with its defaults, on the same mesh: how many, and how long
their seams are.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path
from typing import Any

import meshlab_developable
import numpy as np
import trimesh
import xatlas
from common import print_head, print_row
from meshlab_developable import mesh_sets
from smooth_curves import seams_beside_smooth_curves

SUFFIXES = {".obj", ".ply", ".off", ".stl"}
OF_MATERIAL = {"allowed_stretch", "allowed_compression"}
HEAD = (
    "mesh", "triangles", "panels", "darts", "seams, D", "mean distance, %", "largest, %", "C, rad",
    "largest strain", "overlapping", "s", "seams / smooth curves", "worst", "xatlas charts",
    "xatlas seams, D",
)  # fmt: skip


def main() -> None:
    """Print the table."""
    folder, *assignments = sys.argv[1:]
    parameters = {name: float(value) for name, value in (text.split("=") for text in assignments)}
    noise = parameters.pop("noise", 0)
    print_head(HEAD)
    for path in sorted(path for path in Path(folder).iterdir() if path.suffix.lower() in SUFFIXES):
        try:
            print_row(path.stem, *measured(path, noise, parameters))
        except meshlab_developable.DevelopableError as error:
            print_row(path.stem, str(error))


def measured(path: Path, noise: float, parameters: dict[str, Any]) -> list[object]:
    """The row of a mesh, but for its name."""
    meshes = mesh_sets.open_mesh(path)  # a mesh dies with its set
    mesh = meshes.current_mesh()
    vertices, faces = np.array(mesh.vertex_matrix()), np.array(mesh.face_matrix())
    if noise > 0:
        vertices = with_noise(vertices, faces, noise)
    diagonal = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    start = time.perf_counter()
    cut = meshlab_developable.cut_into_panels(vertices, faces, **parameters)
    seconds = time.perf_counter() - start
    material = {name: value for name, value in parameters.items() if name in OF_MATERIAL}
    developed = meshlab_developable.make_developable(cut.vertices, cut.faces, **material)
    flat = meshlab_developable.flatten(developed.vertices, developed.faces, **material)
    surface = trimesh.Trimesh(vertices, faces, process=False)
    distances = trimesh.proximity.closest_point(surface, developed.vertices)[1] / diagonal
    sides = vertices[faces] - vertices[np.roll(faces, -1, axis=1)]
    smooth = seams_beside_smooth_curves(
        meshlab_developable.flatten(cut.vertices, cut.faces), float(np.linalg.norm(sides, axis=2).mean())
    )
    charts, seams = xatlas_charts(vertices, faces)
    return [
        len(faces),
        len(cut.report.panels),
        cut.report.darts,
        f"{cut.report.seam_length / diagonal:.2f}",
        f"{100 * distances.mean():.2f}",
        f"{100 * distances.max():.2f}",
        f"{developed.report.total_absolute_curvature_after:.1e}",
        f"{flat.report.max_edge_strain:.1e}",
        flat.report.overlapping_pieces,
        f"{seconds:.1f}",
        *(f"{ratio:.3f}" for ratio in smooth),
        charts,
        f"{seams / diagonal:.2f}",
    ]


def with_noise(vertices: Any, faces: Any, share_of_edge: float) -> Any:
    """The same on every run; vertices that coincide still do."""
    places, place_of_vertex = np.unique(vertices, axis=0, return_inverse=True)
    surface = trimesh.Trimesh(places, place_of_vertex.reshape(-1)[faces], process=False)
    deviation = share_of_edge * surface.edges_unique_length.mean()
    moves = np.random.default_rng(1).normal(0, deviation, len(places))
    return (places + moves[:, None] * surface.vertex_normals)[place_of_vertex.reshape(-1)]


def xatlas_charts(vertices: Any, faces: Any) -> tuple[int, float]:
    """How many charts xatlas makes, and the length of edges along which they were cut apart."""
    origins, corners, _ = xatlas.parametrize(vertices, faces)
    charts = trimesh.Trimesh(vertices[origins], corners, process=False)
    welded = trimesh.Trimesh(vertices, origins[corners].astype(int), process=False)
    parts = trimesh.graph.connected_components(charts.face_adjacency, nodes=np.arange(len(corners)))
    return len(parts), (border_length(charts) - border_length(welded)) / 2


def border_length(mesh: trimesh.Trimesh) -> float:
    """The length of edges that one face has."""
    _, first, count = np.unique(mesh.edges_sorted, axis=0, return_index=True, return_counts=True)
    ends = mesh.vertices[mesh.edges_sorted[first[count == 1]]]
    return float(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum())


if __name__ == "__main__":
    main()
