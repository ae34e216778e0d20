# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of `cut_into_panels.md`: a toy and a seat cut into panels, developable, and laid flat.

.venv/bin/python docs/make_cut_pictures.py
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from make_pattern_pictures import pages
from meshlab_developable import load, make_developable
from meshlab_developable.mesh_sets import open_mesh
from meshlab_developable.patterns import make_patterns
from meshlab_developable.rendering import Picture, View, render

DOCS = Path(__file__).resolve().parent
MESHES = DOCS.parent / "meshes"
PICTURES = DOCS / "pictures"
MODELS = {"toy": (View((1.0, -2.0, 0.9)), 1.2), "seat": (View((1.6, -1.6, 0.9)), 0.5)}
BACK = np.diag([-1.0, -1.0, 1.0])  # turned round by half a turn


def pictures_of(name: str, view: View, pixels: float) -> None:
    """Write a model's panels and its pattern, with so many pixels a millimetre."""
    meshes = open_mesh(MESHES / f"{name}.ply")
    meshes.apply_filter("meshing_cut_into_developable_panels")
    mesh = meshes.current_mesh()  # which dies with its set
    vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
    colours = mesh.face_color_matrix()[:, :3]
    developed = make_developable(vertices, faces)
    shapes = {"panels": vertices, "from behind": vertices @ BACK, "developable": developed.vertices}
    render(
        PICTURES / f"cut_{name}.png",
        [Picture(title, shape, faces, colours) for title, shape in shapes.items()],
        None,
        view,
    )
    with tempfile.TemporaryDirectory() as folder:
        make_patterns(developed.vertices, faces, folder=folder, name=name, unit="cm")
        (sheet,) = pages(Path(folder) / f"{name}.pdf", pixels)
        sheet.save(PICTURES / f"cut_{name}_pattern.png", optimize=True)


def main() -> None:
    """Write the pictures."""
    load()
    for name, (view, pixels) in MODELS.items():
        pictures_of(name, view, pixels)


if __name__ == "__main__":
    main()
