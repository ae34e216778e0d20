# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of the pages on filters: dialogs in MeshLab's own window, maps, and what parameters do.

.venv/bin/python docs/make_pictures.py [NAME...]   (all pictures, those of examples.md too; or those so named)
"""

from __future__ import annotations

import dataclasses
import sys
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import make_examples
import numpy as np
import pymeshlab
from make_examples import DOCS, MESHES, keep_picture
from meshlab_developable import load
from meshlab_developable.plugin import vertex_quality
from meshlab_developable.rendering import Picture, View, render, robust_scale

ROOT = DOCS.parent
GLOBAL, LOCAL = "apply_coord_global_developability", "apply_coord_local_developability"
MAPS, FLATTEN = "compute_scalar_by_developability_per_vertex", "generate_flat_patches"
FRONT, ABOVE = View((0.9, -1.6, 1.3)), View((0.0, 0.0, 1.0), (0.0, 1.0, 0.0))
SHOE, PANTS, SIDE = View((1.0, -1.6, 0.8)), View((0.8, -2.0, 0.5)), View((0.5, -1.6, 0.9))
PAPER = 0.01  # the paper's angle tolerance, rad

Prepare = Callable[[Any], None]
Values = Mapping[str, Any]


@dataclasses.dataclass(frozen=True)
class Row:
    """The same mesh under several settings, side by side in one scale."""

    model: str
    view: View
    filter: str
    settings: Mapping[str, Values]  # parameters by title
    map: str  # what is shown of the results
    label: str  # of the scale
    signed: bool = False
    before: bool = True  # the mesh as it came is the first picture
    prepare: Prepare = lambda meshes: None
    map_parameters: Values = dataclasses.field(default_factory=dict)


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

ROWS = {
    "hull_panel": Row(
        "hull_panel",
        SIDE,
        GLOBAL,
        {"Global": {}, "Global, conjugate gradient": {"solver": "Conjugate gradient"}},
        *DEFECT,
    ),
    "hull_panel_moved": Row("hull_panel", SIDE, GLOBAL, {"Global": {}}, *MOVED, before=False),
    "global_fix_boundary": Row(
        "dented_shell", FRONT, GLOBAL, {"off": {}, "fix_boundary": {"fix_boundary": True}}, *DEFECT
    ),
    "global_smoothness": Row(
        "shoe_upper",
        SHOE,
        GLOBAL,
        {f"smoothness {value:g}": {"smoothness": value} for value in (3e-7, 3e-6, 3e-5)},
        *MOVED,
        before=False,
    ),
    "global_max_iterations": Row(
        "dented_shell",
        FRONT,
        GLOBAL,
        {f"max_iterations {count}": {"max_iterations": count} for count in (2, 5, 200)},
        *DEFECT,
        before=False,
    ),
    "global_relative_change": Row(
        "short_pants",
        PANTS,
        GLOBAL,
        {f"relative_change {eta:g}": CONJUGATE | {"relative_change": eta} for eta in (0.1, 1e-2, 1e-4)},
        *DEFECT,
        before=False,
    ),
    "global_curvature_tolerance": Row(
        "dented_shell",
        FRONT,
        GLOBAL,
        {
            f"both tolerances {value:g}": {"curvature_tolerance": value, "angle_tolerance": value}
            for value in (1.0, 0.1, 1e-4)
        },
        *DEFECT,
        before=False,
    ),
    "global_only_selected": Row(
        "short_pants",
        PANTS,
        GLOBAL,
        {"off": {}, "only_selected": {"only_selected": True}},
        *MOVED,
        before=False,
        prepare=select("(x0+x1+x2 > 0) && (y0+y1+y2 < 0)", faces=True),
    ),
    "global_fix_selected": Row(
        "dented_shell",
        FRONT,
        GLOBAL,
        {"off": {}, "fix_selected": {"fix_selected": True}},
        *MOVED,
        before=False,
        prepare=select("y < 5", faces=False),
    ),
    "global_patches": Row(
        "dented_shell",
        FRONT,
        GLOBAL,
        {"Connected components": {}, "Face colour": {"patches": "Face colour"}},
        *MOVED,
        before=False,
        prepare=two_colours,
    ),
    "global_weld_distance": Row(
        "short_pants",
        PANTS,
        GLOBAL,
        {"weld_distance 0": {}, "weld_distance 0.05": {"weld_distance": pymeshlab.PureValue(0.05)}},
        *MOVED,
        before=False,
        prepare=apart,
    ),
    "local_descent": Row(
        "shoe_upper",
        SHOE,
        LOCAL,
        {"off": {"angle_tolerance": PAPER}, "descent": {"angle_tolerance": PAPER, "descent": True}},
        *DEFECT,
    ),
    "local_smoothing": Row(
        "shoe_upper",
        SHOE,
        LOCAL,
        {
            f"descent, smoothing {value:g}": {
                "angle_tolerance": PAPER,
                "descent": True,
                "smoothing": value,
            }
            for value in (0.0, 0.01, 0.1)
        },
        *DEFECT,
        before=False,
    ),
    "local_max_operations": Row(
        "shoe_upper",
        SHOE,
        LOCAL,
        {
            f"max_operations {count}": {"angle_tolerance": PAPER, "descent": True, "max_operations": count}
            for count in (300, 3000, 500000)
        },
        *DEFECT,
        before=False,
    ),
    "local_angle_tolerance": Row(
        "dented_shell",
        FRONT,
        LOCAL,
        {
            f"angle_tolerance {value:g}": {"angle_tolerance": value, "descent": True}
            for value in (0.03, 0.01, 1e-4)
        },
        *DEFECT,
        before=False,
    ),
    "local_assembling_vertices": Row(
        "short_pants",
        PANTS,
        LOCAL,
        {
            choice: {"angle_tolerance": PAPER, "descent": True, "assembling_vertices": choice}
            for choice in ("Fixed", "Move together")
        },
        *MOVED,
        before=False,
    ),
    "flatten_gap": Row(
        "short_pants",
        ABOVE,
        FLATTEN,
        {f"gap {gap:g}": {"gap": pymeshlab.PureValue(gap)} for gap in (0.5, 10.0)},
        *STRAIN,
        before=False,
    ),
    "flatten_hull_panel": Row("hull_panel", ABOVE, FLATTEN, {"laid flat": {}}, *STRAIN, before=False),
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


def picture(meshes: Any, row: Row, title: str) -> Picture:
    """The current mesh in the row's map; a pattern has its own already."""
    if row.filter != FLATTEN:
        meshes.apply_filter(MAPS, map=row.map, **row.map_parameters)
    mesh = meshes.current_mesh()
    return Picture(title, mesh.vertex_matrix(), mesh.face_matrix(), vertex_quality(mesh))


def draw_row(name: str, row: Row, folder: Path) -> None:
    """All settings of a row, and the mesh as it came."""
    pictures = []
    if row.before:
        pictures.append(picture(opened(row.model, row.prepare), row, "before"))
    for title, values in row.settings.items():
        meshes = opened(row.model, row.prepare)
        returned = meshes.apply_filter(row.filter, **values)
        print(f"{name}, {title}: C {returned.get('total_absolute_curvature_after', '')}", flush=True)
        pictures.append(picture(meshes, row, title))
    compared = [pictures[0].values] if row.before else [shown.values for shown in pictures]
    render(folder / f"{name}.png", pictures, robust_scale(row.label, compared, row.signed), row.view)
    keep_picture(folder / f"{name}.png", f"{name}.png", len(pictures))


def draw_maps(folder: Path) -> None:
    """Each map of a shoe upper that the local method has worked on."""
    for title, (label, signed) in ALL_MAPS.items():
        meshes = opened("shoe_upper")
        meshes.apply_filter(LOCAL, angle_tolerance=PAPER, descent=True)
        row = Row("shoe_upper", SHOE, LOCAL, {}, title, label, signed)
        shown = picture(meshes, row, title)
        name = f"map_{title.lower().replace(' ', '_')}.png"
        render(folder / name, [shown], robust_scale(label, [shown.values], signed), SHOE)
        keep_picture(folder / name, name, 1)


def draw_dialogs(folder: Path) -> None:
    """MeshLab's dialog of each filter that has one."""
    sys.path.insert(0, str(ROOT / "tests" / "support"))
    from desktop import Desktop, MeshLab, keep, stage

    program = stage(ROOT)
    for name in ("Global Developability", "Local Developability", "Developability Maps", "Flatten Patches"):
        home = folder / name
        home.mkdir()
        with Desktop(home) as desktop:
            dialog = MeshLab(desktop, program, MESHES / "dented_shell.ply").open(name)
            keep(dialog.picture(), DOCS / "pictures" / f"dialog_{name.lower().replace(' ', '_')}.png")


def main(names: list[str]) -> None:
    """Draw what is named, or everything."""
    load()
    with tempfile.TemporaryDirectory() as folder:
        for name, row in ROWS.items():
            if not names or name in names:
                draw_row(name, row, Path(folder))
        if not names or "maps" in names:
            draw_maps(Path(folder))
        if not names or "dialogs" in names:
            draw_dialogs(Path(folder))
    if not names or "examples" in names:
        make_examples.main()


if __name__ == "__main__":
    main(sys.argv[1:])
