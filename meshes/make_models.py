# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the models in this folder, in the manner of the three examples of Wang and Tang (2004), Section 6.

    python make_models.py [FOLDER]

| model        | what                                                                            |
|--------------|---------------------------------------------------------------------------------|
| sheet_bent   | a sheet bent about parallel rulings: developable, the shell before it is dented |
| dented_shell | Example I: the same sheet, vertex by vertex, dented by a smooth bump            |
| shoe_upper   | Example II: the upper of a shoe, one layer, open at the sole, the top, the heel |
| short_pants  | Example III: short pants, four panels whose seams coincide, one T-junction      |
| hull_panel   | not in the paper: a panel of a dinghy, from the side of Wigley's hull           |
| toy          | to be cut into panels: a stuffed bear, one closed surface                       |
| seat         | to be cut into panels: a car seat, one closed surface                           |

Each comes as OBJ, with the panels' names, and as PLY: MeshLab 2020.09 as Debian builds it stops at every OBJ.
One unit is a centimetre. Needs NumPy only. The same bytes come out of every run.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from bent_sheet import dented_shell, sheet_bent
from hull_panel import hull_panel
from seat import seat
from shapes import Panels
from shoe_upper import shoe_upper
from short_pants import short_pants
from toy import toy

MODELS = {
    "sheet_bent": sheet_bent,
    "dented_shell": dented_shell,
    "shoe_upper": shoe_upper,
    "short_pants": short_pants,
    "hull_panel": hull_panel,
    "toy": toy,
    "seat": seat,
}


def vertex_rows(positions: np.ndarray) -> list[str]:
    """Coordinates as they are written, in both formats."""
    rounded = np.round(positions, 8) + 0.0  # no minus zero
    return [f"{x:.8f} {y:.8f} {z:.8f}" for x, y, z in rounded]


def obj_text(panels: Panels) -> str:
    """A Wavefront OBJ: each panel an object with vertices of its own."""
    lines, first = [], 1
    for name, (positions, triangles) in panels.items():
        lines.append(f"o {name}")
        lines += [f"v {row}" for row in vertex_rows(positions)]
        lines += [f"f {a} {b} {c}" for a, b, c in triangles + first]
        first += len(positions)
    return "\n".join(lines) + "\n"


def ply_text(panels: Panels) -> str:
    """The same vertices and triangles as a PLY in ASCII, without the panels' names."""
    vertices, faces = [], []
    for positions, triangles in panels.values():
        faces += [f"3 {a} {b} {c}" for a, b, c in triangles + len(vertices)]
        vertices += vertex_rows(positions)
    header = [
        *("ply", "format ascii 1.0"),
        *(f"element vertex {len(vertices)}", "property double x", "property double y", "property double z"),
        *(f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"),
    ]
    return "\n".join([*header, *vertices, *faces]) + "\n"


def main() -> None:
    """Write every model to the folder given on the command line, or to this one."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in MODELS.items():
        panels = make()
        for ending, text in (("obj", obj_text(panels)), ("ply", ply_text(panels))):
            (folder / f"{name}.{ending}").write_text(text, encoding="ascii", newline="\n")


if __name__ == "__main__":
    main()
