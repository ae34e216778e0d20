# SPDX-License-Identifier: GPL-3.0-or-later
"""What the page's own viewer (`view.js`) draws: shapes in the colours of a map, as text in a page."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
import numpy.typing as npt

from meshlab_developable.colours import colour_range, map_colours
from meshlab_developable.demo.study import Study

MAP = "Angle defect"


def view(study: Study) -> dict[str, Any]:
    """The mesh before and after each method, all coloured by angle defect at the scale of the first."""
    defects = study.maps[MAP]
    high = colour_range(defects)
    shapes = [("before", study.vertices, defects)]
    shapes += [(f"after: {o.method.title}", o.vertices, o.maps[MAP]) for o in study.outcomes]
    return {
        "faces": _text(study.faces, np.uint32),
        "turn": _first_turn(study).ravel().tolist(),
        "range": high,
        "shapes": [
            {
                "title": title,
                "positions": _text(vertices, np.float32),
                "colours": _text(map_colours(values / high, signed=True), np.uint8),
            }
            for title, vertices, values in shapes
        ],
    }


def _text(values: npt.NDArray[Any], kind: npt.DTypeLike) -> str:
    """Base 64 of the values in little-endian order."""
    little = np.ascontiguousarray(values).astype(np.dtype(kind).newbyteorder("<"))
    return base64.b64encode(little.tobytes()).decode("ascii")


def _first_turn(study: Study) -> npt.NDArray[np.float64]:
    """The rotation that looks from where the pictures do: its rows are right, up and to the eye."""
    eye = np.array(study.source.view.eye) / np.linalg.norm(study.source.view.eye)
    right = np.cross(study.source.view.up, eye)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(eye, right), eye])
