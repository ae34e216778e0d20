# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the models in this folder, in the manner of the three examples of Wang and Tang (2004), Section 6.

    python make_models.py [FOLDER]

| file             | what                                                                             |
|------------------|----------------------------------------------------------------------------------|
| sheet_bent.obj   | a sheet bent about parallel rulings: developable, the shell before it is dented  |
| dented_shell.obj | Example I: the same sheet, vertex by vertex, dented by a smooth bump             |
| shoe_upper.obj   | Example II: the upper of a shoe, one layer, open at the sole, the top, the heel   |
| short_pants.obj  | Example III: short pants, four panels whose seams coincide, one T-junction       |

One unit is a centimetre. Needs NumPy only. The same bytes come out of every run.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from bent_sheet import dented_shell, sheet_bent
from shapes import Panels
from shoe_upper import shoe_upper
from short_pants import short_pants

MODELS = {
    "sheet_bent": sheet_bent,
    "dented_shell": dented_shell,
    "shoe_upper": shoe_upper,
    "short_pants": short_pants,
}


def obj_text(panels: Panels) -> str:
    """A Wavefront OBJ: each panel an object with vertices of its own."""
    lines, first = [], 1
    for name, (positions, triangles) in panels.items():
        lines.append(f"o {name}")
        rounded = np.round(positions, 8) + 0.0  # no minus zero
        lines += [f"v {x:.8f} {y:.8f} {z:.8f}" for x, y, z in rounded]
        lines += [f"f {a} {b} {c}" for a, b, c in triangles + first]
        first += len(positions)
    return "\n".join(lines) + "\n"


def main() -> None:
    """Write every model to the folder given on the command line, or to this one."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in MODELS.items():
        (folder / f"{name}.obj").write_text(obj_text(make()), encoding="ascii", newline="\n")


if __name__ == "__main__":
    main()
