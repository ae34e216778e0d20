# SPDX-License-Identifier: GPL-3.0-or-later
"""Flatten Patches beside libigl's LSCM, ARAP and SLIM and pymeshlab's parameterisations, on the same panels.

.venv/bin/python -m pip install -r bench/requirements-flatten.txt
.venv/bin/python bench/flatten.py [MESH...]

Without a mesh: those of `meshes/`, shapes over grids, and a grid of 200 000 triangles for the time. Panels
are the connected components of a mesh that are disks. LSCM and the harmonic map, which know no scale, are
scaled by the factor that makes their own mean edge strain least.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import igl
import numpy as np
import pymeshlab
from common import print_head, print_row
from meshlab_developable import flatten
from meshlab_developable.sewing import boundary_loops
from models import grid

MODELS = Path(__file__).resolve().parent.parent / "meshes"
ITERATIONS = 100  # of ARAP and SLIM

Array = np.ndarray
Method = Callable[[Array, Array], Array]  # vertices and faces to positions in the plane


def ours(vertices: Array, faces: Array) -> Array:
    """The filter, its vertices in the order of the mesh's."""
    flat = flatten(vertices, faces)
    positions = np.empty((len(vertices), 2))
    positions[faces] = flat.vertices[flat.faces]
    return positions


def lscm(vertices: Array, faces: Array) -> Array:
    """libigl's least-squares conformal map, with two vertices of the boundary pinned."""
    loop = igl.boundary_loop(faces.astype(np.int64))
    pins = loop[[0, len(loop) // 2]]
    apart = np.linalg.norm(vertices[pins[0]] - vertices[pins[1]])
    positions, _ = igl.lscm(vertices, faces.astype(np.int64), pins, np.array([(0.0, 0.0), (apart, 0.0)]))
    return scaled(vertices, faces, np.ascontiguousarray(positions))


def arap(vertices: Array, faces: Array) -> Array:
    """libigl's as-rigid-as-possible parameterisation, from LSCM."""
    data = igl.ARAPData()
    data.max_iter = ITERATIONS
    start = np.ascontiguousarray(lscm(vertices, faces))
    pin = np.zeros(1, np.int32)  # one vertex has to stay somewhere
    igl.arap_precomputation(vertices, faces.astype(np.int64), 2, pin, data)
    return np.array(igl.arap_solve(start[pin], data, start))


def slim(energy: object) -> Method:
    """libigl's SLIM from a harmonic map to a disk."""

    def run(vertices: Array, faces: Array) -> Array:
        loop = igl.boundary_loop(faces.astype(np.int64))
        circle = igl.map_vertices_to_circle(np.asfortranarray(vertices), loop.astype(np.int32))
        start = igl.harmonic(vertices, faces.astype(np.int64), loop, np.ascontiguousarray(circle), 1)
        a, b, c = (vertices[faces[:, i]] for i in range(3))
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
        data = igl.slim_precompute(
            np.asfortranarray(vertices),
            np.asfortranarray(faces.astype(np.int32)),
            np.asfortranarray(start * np.sqrt(area / np.pi)),
            energy,
            np.zeros(0, np.int32),
            np.asfortranarray(np.zeros((0, 2))),
            0.0,
        )
        return np.array(igl.slim_solve(data, ITERATIONS))[:, :2]

    return run


def pymeshlabs(filter_name: str) -> Method:
    """A parameterisation of pymeshlab's own."""

    def run(vertices: Array, faces: Array) -> Array:
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(vertices, faces))
        meshes.apply_filter(filter_name)
        return scaled(vertices, faces, np.array(meshes.current_mesh().vertex_tex_coord_matrix()))

    return run


METHODS: dict[str, Method] = {
    "Flatten Patches": ours,
    "libigl ARAP": arap,
    "libigl SLIM (symmetric Dirichlet)": slim(igl.MappingEnergyType.SYMMETRIC_DIRICHLET),
    "libigl SLIM (ARAP)": slim(igl.MappingEnergyType.ARAP),
    "libigl LSCM, scaled": lscm,
    "pymeshlab LSCM, scaled": pymeshlabs("compute_texcoord_parametrization_least_squares_conformal_maps"),
    "pymeshlab harmonic, scaled": pymeshlabs("compute_texcoord_parametrization_harmonic"),
}


def edges_of(faces: Array) -> Array:
    """Every edge once."""
    return np.unique(np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)


def lengths(positions: Array, edges: Array) -> Array:
    """Lengths of edges."""
    return np.linalg.norm(positions[edges[:, 0]] - positions[edges[:, 1]], axis=1)


def strains(vertices: Array, faces: Array, flat: Array) -> Array:
    """Edge strains."""
    edges = edges_of(faces)
    expected = lengths(vertices, edges)
    return abs(lengths(flat, edges) - expected) / expected


def scaled(vertices: Array, faces: Array, flat: Array) -> Array:
    """With the least mean edge strain that a factor can give: a weighted median of length ratios."""
    edges = edges_of(faces)
    ratios = lengths(flat, edges) / lengths(vertices, edges)
    order = np.argsort(1 / ratios)
    weights = np.cumsum(ratios[order])
    return flat / ratios[order][np.searchsorted(weights, weights[-1] / 2)]


def flipped(faces: Array, flat: Array) -> int:
    """Triangles that lie the other way round than most."""
    a, b, c = (flat[faces[:, i]] for i in range(3))
    signs = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0] > 0
    return int(min(signs.sum(), (~signs).sum()))


def bump(u: Array, v: Array) -> Array:
    """A hill."""
    return 0.15 * np.exp(-12 * ((u - 0.45) ** 2 + (v - 0.5) ** 2))


SHAPES: dict[str, Callable[[Array, Array], Array]] = {
    "cap": lambda u, v: np.sqrt(1.2 - (u - 0.5) ** 2 - (v - 0.5) ** 2),
    "saddle": lambda u, v: 0.6 * ((u - 0.5) ** 2 - (v - 0.5) ** 2),
    "bump": bump,
    "wave": lambda u, v: 0.05 * np.sin(7 * u) * np.sin(5 * v),
}


def panels(paths: list[Path]) -> Iterator[tuple[str, Array, Array]]:
    """The panels of files, and without files those of the models and the grids."""
    for path in paths or sorted(MODELS.glob("*.obj")):
        meshes = pymeshlab.MeshSet()
        meshes.load_new_mesh(str(path))
        meshes.apply_filter("generate_splitting_by_connected_components", delete_source_mesh=True)
        for number, mesh in enumerate(meshes):
            name = path.stem if len(meshes) == 1 else f"{path.stem} {number + 1}"
            vertices, faces = np.array(mesh.vertex_matrix()), np.array(mesh.face_matrix())
            if len(boundary_loops(faces)) == 1:
                yield name, vertices, faces
    if not paths:
        for name, surface in SHAPES.items():
            yield name, *grid(41, surface)


def row(name: str, vertices: Array, faces: Array) -> list[str]:
    """What each method makes of a panel: mean edge strain, the greatest, flipped triangles if any."""
    cells = []
    for method in METHODS.values():
        try:
            flat = method(vertices, faces)
        except (RuntimeError, pymeshlab.PyMeshLabException) as error:
            cells.append(f"failed: {str(error).splitlines()[0]}")
            continue
        found = 100 * strains(vertices, faces, flat)
        flips = flipped(faces, flat)
        cells.append(f"{found.mean():.4g} ({found.max():.3g})" + (f", {flips} flipped" if flips else ""))
    return [name, *cells]


def times(columns: int) -> None:
    """How long the filter takes, and libigl's LSCM with ARAP."""
    vertices, faces = grid(columns, bump)
    print(f"\n{len(faces)} triangles (a hill):")
    for name in ("Flatten Patches", "libigl ARAP"):
        start = time.perf_counter()
        flat = METHODS[name](vertices, faces)
        seconds = time.perf_counter() - start
        found = 100 * strains(vertices, faces, flat).mean()
        print(f"- {name}: {seconds:.1f} s, mean edge strain {found:.4g} %")


def main() -> None:
    """Print the tables."""
    paths = [Path(argument) for argument in sys.argv[1:]]
    print(f"Mean edge strain, % (in parentheses the greatest); {ITERATIONS} iterations of ARAP and SLIM.\n")
    print_head(("panel", *METHODS))
    for panel in panels(paths):
        print_row(*row(*panel))
    if not paths:
        times(317)


if __name__ == "__main__":
    main()
