# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of the pages on filters: dialogs in MeshLab's own window, maps, and what parameters do.

.venv/bin/python docs/make_pictures.py [NAME...]   (all pictures, those of examples.md too; or those so named)
"""

from __future__ import annotations

import dataclasses
import functools
import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import make_examples
import numpy as np
import pymeshlab
from make_examples import DOCS, MESHES, keep_picture
from meshlab_developable import load
from meshlab_developable.plugin import vertex_quality
from meshlab_developable.rendering import ColourScale, Picture, View, render, robust_scale

ROOT = DOCS.parent
GLOBAL, LOCAL = "apply_coord_global_developability", "apply_coord_local_developability"
MAPS, FLATTEN = "compute_scalar_by_developability_per_vertex", "generate_flat_patches"
ABOVE = View((0.0, 0.0, 1.0), (0.0, 1.0, 0.0))
VIEWS = {
    "dented_shell": View((0.9, -1.6, 1.3)),
    "hull_panel": View((0.5, -1.6, 0.9)),
    "shoe_upper": View((1.0, -1.6, 0.8)),
    "short_pants": View((0.8, -2.0, 0.5)),
}
PAPER = 0.01  # the paper's angle tolerance, rad
SQUARES, FINENESS = 24, 16
PALE, DARK, MARKED = (0.9, 0.9, 0.86), (0.25, 0.4, 0.55), (0.84, 0.37, 0.0)

Prepare = Callable[[Any], None]
Values = Mapping[str, Any]


@dataclasses.dataclass(frozen=True)
class Row:
    """The same mesh under several settings, side by side in one scale."""

    model: str
    filter: str
    settings: Mapping[str, Values]  # parameters by title
    map: str  # what is shown of the results
    label: str  # of the scale
    signed: bool = False
    before: bool = False  # the mesh as it came is the first picture
    prepare: Prepare = lambda meshes: None


def by_value(name: str, values: Sequence[float], also: str = "", **others: Any) -> dict[str, Values]:
    """Settings that differ in the value of one parameter; titles may name another one also."""
    return {f"{also}{name} {value:g}": {**others, name: value} for value in values}


def by_switch(name: str, **others: Any) -> dict[str, Values]:
    """Settings with a parameter off and on."""
    return {"off": others, name: {**others, name: True}}


def select(condition: str, faces: bool) -> Prepare:
    """Selects what meets a condition on coordinates."""
    if faces:
        return lambda meshes: meshes.apply_filter(
            "compute_selection_by_condition_per_face", condselect=condition
        )
    return lambda meshes: meshes.apply_filter(
        "compute_selection_by_condition_per_vertex", condselect=condition
    )


def two_colours(meshes: Any) -> None:
    """One half of the faces is painted."""
    meshes.apply_filter("compute_color_by_function_per_face", r="(x0+x1+x2 > 0) * 255", g="90", b="90")


def apart(meshes: Any) -> None:
    """The seam between left and right is open by 0.01 cm."""
    positions, faces = meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()
    left = np.unique(faces[positions[faces].mean(axis=1)[:, 0] < 0])
    positions[left, 0] -= 0.01
    meshes.clear()
    meshes.add_mesh(pymeshlab.Mesh(positions, faces))


DEFECT = ("Angle defect", "angle defect g, rad", True)
MOVED = ("Displacement", "distance moved, cm", False)
STRAIN = ("Edge strain", "edge strain", False)
CONJUGATE = {"solver": "Conjugate gradient", "angle_tolerance": PAPER}
DESCENT = {"angle_tolerance": PAPER, "descent": True}

ROWS = {
    "hull_panel": Row(
        "hull_panel",
        GLOBAL,
        {"Global": {}, "Global, conjugate gradient": {"solver": "Conjugate gradient"}},
        *DEFECT,
        before=True,
    ),
    "hull_panel_moved": Row("hull_panel", GLOBAL, {"Global": {}}, *MOVED),
    "global_fix_boundary": Row("dented_shell", GLOBAL, by_switch("fix_boundary"), *DEFECT, before=True),
    "global_smoothness": Row("shoe_upper", GLOBAL, by_value("smoothness", (3e-7, 3e-6, 3e-5)), *MOVED),
    "global_max_iterations": Row("dented_shell", GLOBAL, by_value("max_iterations", (2, 5, 200)), *DEFECT),
    "global_relative_change": Row(
        "short_pants", GLOBAL, by_value("relative_change", (0.1, 1e-2, 1e-4), **CONJUGATE), *DEFECT
    ),
    "global_curvature_tolerance": Row(
        "dented_shell",
        GLOBAL,
        {
            f"both tolerances {value:g}": {"curvature_tolerance": value, "angle_tolerance": value}
            for value in (1.0, 0.1, 1e-4)
        },
        *DEFECT,
    ),
    "global_only_selected": Row(
        "short_pants",
        GLOBAL,
        by_switch("only_selected"),
        *MOVED,
        prepare=select("(x0+x1+x2 > 0) && (y0+y1+y2 < 0)", faces=True),
    ),
    "global_fix_selected": Row(
        "dented_shell", GLOBAL, by_switch("fix_selected"), *MOVED, prepare=select("y < 5", faces=False)
    ),
    "global_patches": Row(
        "dented_shell",
        GLOBAL,
        {"Connected components": {}, "Face colour": {"patches": "Face colour"}},
        *MOVED,
        prepare=two_colours,
    ),
    "global_weld_distance": Row(
        "short_pants",
        GLOBAL,
        {"weld_distance 0": {}, "weld_distance 0.05": {"weld_distance": pymeshlab.PureValue(0.05)}},
        *MOVED,
        prepare=apart,
    ),
    "local_descent": Row(
        "shoe_upper", LOCAL, by_switch("descent", angle_tolerance=PAPER), *DEFECT, before=True
    ),
    "local_smoothing": Row(
        "shoe_upper",
        LOCAL,
        by_value("smoothing", (0.0, 0.01, 0.1), "descent, ", **DESCENT),
        *DEFECT,
    ),
    "local_max_operations": Row(
        "shoe_upper", LOCAL, by_value("max_operations", (300, 3000, 500000), **DESCENT), *DEFECT
    ),
    "local_angle_tolerance": Row(
        "dented_shell", LOCAL, by_value("angle_tolerance", (0.03, 0.01, 1e-4), **DESCENT), *DEFECT
    ),
    "local_assembling_vertices": Row(
        "short_pants",
        LOCAL,
        {choice: {**DESCENT, "assembling_vertices": choice} for choice in ("Fixed", "Move together")},
        *MOVED,
    ),
    "flatten_gap": Row(
        "short_pants",
        FLATTEN,
        {f"gap {gap:g}": {"gap": pymeshlab.PureValue(gap)} for gap in (0.5, 10.0)},
        *STRAIN,
    ),
    "flatten_hull_panel": Row("hull_panel", FLATTEN, {"laid flat": {}}, *STRAIN),
}
ALL_MAPS = {
    "Gaussian map": ("g², rad²", False),
    "Angle defect": ("g, rad", True),
    "Gaussian curvature": ("κ, 1/cm²", True),
    "Minimum curvature": ("|κ_min|, 1/cm", False),
    "Maximum curvature": ("|κ_max|, 1/cm", False),
    "Distance": ("distance, cm", False),
    "Displacement": ("displacement, cm", False),
    "Elastic energy": ("elastic energy, cm²", False),
}


def opened(model: str, prepare: Prepare = lambda meshes: None) -> Any:
    """A mesh set with the model in it."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(MESHES / f"{model}.obj"))
    prepare(meshes)
    return meshes


def picture(meshes: Any, title: str) -> Picture:
    """The current mesh in the colours of its quality."""
    mesh = meshes.current_mesh()
    return Picture(title, mesh.vertex_matrix(), mesh.face_matrix(), vertex_quality(mesh))


def mapped(meshes: Any, kind: str, title: str) -> Picture:
    """The current mesh in a map."""
    meshes.apply_filter(MAPS, map=kind)
    return picture(meshes, title)


def draw_row(name: str, row: Row, folder: Path) -> None:
    """All settings of a row, and the mesh as it came."""
    pictures = []
    if row.before:
        pictures.append(mapped(opened(row.model, row.prepare), row.map, "before"))
    for title, values in row.settings.items():
        meshes = opened(row.model, row.prepare)
        returned = meshes.apply_filter(row.filter, **values)
        print(f"{name}, {title}: C {returned.get('total_absolute_curvature_after', '')}", flush=True)
        # A pattern has its own map already.
        pictures.append(picture(meshes, title) if row.filter == FLATTEN else mapped(meshes, row.map, title))
    compared = [pictures[0].values] if row.before else [shown.values for shown in pictures]
    view = ABOVE if row.filter == FLATTEN else VIEWS[row.model]
    write(name, pictures, robust_scale(row.label, compared, row.signed), view, folder)


def write(
    name: str, pictures: Sequence[Picture], scale: ColourScale | None, view: View, folder: Path
) -> None:
    """Draw pictures side by side into the documentation's, by way of the folder."""
    file = folder / f"{name}.png"
    render(file, pictures, scale, view)
    keep_picture(file, file.name, len(pictures))


def draw_maps(folder: Path) -> None:
    """Each map of a shoe upper that the local method has worked on."""
    for title, (label, signed) in ALL_MAPS.items():
        meshes = opened("shoe_upper")
        meshes.apply_filter(LOCAL, **DESCENT)
        shown = mapped(meshes, title, title)
        name = f"map_{title.lower().replace(' ', '_')}"
        write(name, [shown], robust_scale(label, [shown.values], signed), VIEWS["shoe_upper"], folder)


def chequered(title: str, vertices: np.ndarray, faces: np.ndarray, coordinates: np.ndarray) -> Picture:
    """A mesh in squares by texture coordinates (m x 3 x 2), SQUARES of them across the unit square.

    Each triangle is drawn as FINENESS² small ones, each in one colour.
    """
    steps = range(FINENESS)
    upright = [((i, j), (i + 1, j), (i, j + 1)) for i in steps for j in steps if i + j < FINENESS]
    turned = [((i + 1, j), (i + 1, j + 1), (i, j + 1)) for i in steps for j in steps if i + j < FINENESS - 1]
    at = np.array(upright + turned) / FINENESS
    weights = np.concatenate([1 - at.sum(axis=2, keepdims=True), at], axis=2)  # small x corner x corner

    def finer(corners: np.ndarray) -> np.ndarray:
        return np.einsum("scb,fbx->fscx", weights, corners).reshape(-1, 3, corners.shape[2])

    places = finer(vertices[faces]).reshape(-1, 3)
    squares = np.floor(SQUARES * finer(coordinates).mean(axis=1)).sum(axis=1) % 2 == 1
    # What coincides is one vertex again, so that only the mesh's own borders are borders.
    _, first, corners = np.unique(places.round(9), axis=0, return_index=True, return_inverse=True)
    return Picture(title, places[first], corners.reshape(-1, 3), np.where(squares[:, None], DARK, PALE))


def draw_texture_coordinates(folder: Path) -> None:
    """A shoe upper and its pattern, which faces the eye, in squares by the texture coordinates written."""
    view = VIEWS["shoe_upper"]
    meshes = opened("shoe_upper")
    meshes.apply_filter(FLATTEN, write_texture_coordinates=True)
    flat = meshes.current_mesh().vertex_matrix()[:, :2]
    meshes.set_current_mesh(0)
    model = meshes.current_mesh()
    coordinates = model.wedge_tex_coord_matrix().reshape(-1, 3, 2)
    eye = np.array(view.eye) / np.linalg.norm(view.eye)
    right = np.cross(view.up, eye) / np.linalg.norm(np.cross(view.up, eye))
    facing = (flat - middle(flat)) @ [right, np.cross(eye, right)] + middle(model.vertex_matrix())
    pictures = [
        chequered("the model", model.vertex_matrix(), model.face_matrix(), coordinates),
        chequered("its pattern", facing, meshes.mesh(1).face_matrix(), coordinates),
    ]
    write("flatten_write_texture_coordinates", pictures, None, view, folder)


def middle(points: np.ndarray) -> np.ndarray:
    """Of the points' box."""
    return (points.min(axis=0) + points.max(axis=0)) / 2


def draw_self_intersections(folder: Path) -> None:
    """A crumpled sheet above a flat one, and which of their faces cut others."""
    sys.path.insert(0, str(ROOT / "tests" / "support"))
    from shapes import crumpled_above_flat

    pictures = []
    for title, values in {"before": None, **by_switch("avoid_self_intersections")}.items():
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(*crumpled_above_flat()))
        if values is not None:
            meshes.apply_filter(LOCAL, **values)
        meshes.apply_filter("compute_selection_by_self_intersections_per_face")
        mesh = meshes.current_mesh()
        cut = mesh.face_selection_array()[:, None]
        print(f"self-intersections, {title}: {cut.sum()} faces", flush=True)
        pictures.append(Picture(title, mesh.vertex_matrix(), mesh.face_matrix(), np.where(cut, MARKED, PALE)))
    write("local_avoid_self_intersections", pictures, None, View((0.5, -1.2, 1.6)), folder)


DIALOGS = (
    "Global Developability",
    "Local Developability",
    "Developability Maps",
    "Flatten Patches",
    "Cut into Developable Panels",
)


def draw_dialogs(folder: Path) -> None:
    """MeshLab's dialog of each filter that has one."""
    sys.path.insert(0, str(ROOT / "tests" / "support"))
    from desktop import Desktop, MeshLab, keep, stage

    program = stage(ROOT)
    for name in DIALOGS:
        home = folder / name
        home.mkdir()
        with Desktop(home) as desktop:
            dialog = MeshLab(desktop, program, MESHES / "dented_shell.ply").open(name)
            keep(dialog.picture(), DOCS / "pictures" / f"dialog_{name.lower().replace(' ', '_')}.png")


def main(names: list[str]) -> None:
    """Draw what is named, or everything."""
    load()
    drawings: dict[str, Callable[[Path], None]] = {
        name: functools.partial(draw_row, name, row) for name, row in ROWS.items()
    }
    drawings |= {
        "local_avoid_self_intersections": draw_self_intersections,
        "flatten_write_texture_coordinates": draw_texture_coordinates,
        "maps": draw_maps,
        "dialogs": draw_dialogs,
    }
    with tempfile.TemporaryDirectory() as folder:
        for name, draw in drawings.items():
            if not names or name in names:
                draw(Path(folder))
    if not names or "examples" in names:
        make_examples.main()


if __name__ == "__main__":
    main(sys.argv[1:])
