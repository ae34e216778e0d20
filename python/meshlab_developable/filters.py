# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin's filters and their parameters, in the filters' own order."""

from __future__ import annotations

import dataclasses
import difflib
from collections.abc import Callable, Mapping
from typing import Any

from meshlab_developable.errors import InvalidParameterError
from meshlab_developable.parameters import Boolean, Choice, Layer, Length, Number, Parameter, Whole


@dataclasses.dataclass(frozen=True)
class Filter:
    """A filter of the plugin."""

    name: str  # on the command line
    title: str  # in menus and .mlx scripts
    function: str  # in pymeshlab
    parameters: tuple[Parameter, ...]

    def parameter(self, name: str) -> Parameter:
        """The parameter of that name. Raises InvalidParameterError, with the nearest name."""
        for parameter in self.parameters:
            if parameter.name == name:
                return parameter
        names = [parameter.name for parameter in self.parameters]
        near = difflib.get_close_matches(name, names, n=1)
        hint = f"did you mean {near[0]!r}?" if near else f"it has {', '.join(names) or 'none'}."
        raise InvalidParameterError(f"{self.title} has no parameter {name!r}; {hint}")

    def checked(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """The values as plain Python values.

        Raises InvalidParameterError for a name that the filter has not, naming the nearest, and for a value
        that it does not take, saying what would do.
        """
        return {
            name: _convert(name, value, self.parameter(name).kind.check) for name, value in values.items()
        }

    def parsed(self, texts: Mapping[str, str]) -> dict[str, Any]:
        """The values that texts stand for. Raises as `checked` does."""
        return {name: _convert(name, text, self.parameter(name).kind.parse) for name, text in texts.items()}


def _convert(name: str, value: Any, conversion: Callable[[Any], Any]) -> Any:
    try:
        return conversion(value)
    except ValueError as error:
        raise InvalidParameterError(f"{name} is {value!r}, but {error}") from None


SEAMS = ("Connected components", "Face colour", "Texture islands", "Face quality")
MAPS = (
    "Gaussian map",
    "Angle defect",
    "Gaussian curvature",
    "Minimum curvature",
    "Maximum curvature",
    "Distance",
    "Displacement",
)

_PATCHES = Parameter(
    "patches",
    Choice(SEAMS),
    "Connected components",
    "What separates patches: gaps, or also edges between faces that differ in colour, island or quality.",
)
_WELD_DISTANCE = Parameter(
    "weld_distance", Length(), 0.0, "Vertices at most this far apart are linked and move as one (length)."
)
_ONLY_SELECTED = Parameter(
    "only_selected", Boolean(), False, "Work on the patches that have a selected face; the others hold still."
)
_FIX_BOUNDARY = Parameter("fix_boundary", Boolean(), False, "Vertices on the boundary of a patch stay.")
_FIX_SELECTED = Parameter("fix_selected", Boolean(), False, "Selected vertices stay.")
_ANGLE_TOLERANCE = Parameter(
    "angle_tolerance", Number(), 1e-4, "A vertex with a smaller angle defect counts as developable (rad)."
)
_MAP = Parameter("map", Choice(MAPS), "Gaussian map", "What is written to the vertex quality.")
_COLORIZE = Parameter("colorize", Boolean(), True, "Colour the vertices by the map.")

GLOBAL = Filter(
    "global",
    "Global Developability",
    "apply_coord_global_developability",
    (
        Parameter(
            "solver",
            Choice(("Constrained Newton", "Conjugate gradient")),
            "Constrained Newton",
            "How the shape is found: all the way to developable, or as in the paper.",
        ),
        _PATCHES,
        _WELD_DISTANCE,
        _ONLY_SELECTED,
        _FIX_BOUNDARY,
        _FIX_SELECTED,
        _ANGLE_TOLERANCE,
        Parameter(
            "curvature_tolerance",
            Number(),
            1e-4,
            "Constrained Newton: the most total absolute curvature of a patch that is developable (rad).",
        ),
        Parameter("max_iterations", Whole(), 200, "The run ends after so many steps at the latest."),
        Parameter(
            "relative_change",
            Number(),
            1e-4,
            "Conjugate gradient: the run ends when a step changes G by less than this share of its start.",
        ),
        Parameter(
            "smoothness",
            Number(),
            3e-6,
            "Constrained Newton: how much weight bending has against distance; larger values wrinkle less.",
        ),
        _MAP,
        _COLORIZE,
    ),
)

LOCAL = Filter(
    "local",
    "Local Developability",
    "apply_coord_local_developability",
    (
        _PATCHES,
        _WELD_DISTANCE,
        _ONLY_SELECTED,
        _FIX_SELECTED,
        _ANGLE_TOLERANCE,
        Parameter(
            "max_displacement",
            Length(automatic=True),
            -1.0,
            "How far a vertex may move along its normal (length); -1 is the mean edge length.",
        ),
        Parameter("max_operations", Whole(), 500_000, "The run ends after so many visits to a vertex."),
        Parameter("descent", Boolean(), False, "Halve each move until it gets nearer to developable."),
        Parameter("smoothing", Number(), 0.0, "How strongly moves of neighbours are kept alike; try 0.01."),
        Parameter(
            "assembling_vertices",
            Choice(("Fixed", "Move together")),
            "Fixed",
            "Whether vertices on seams stay, or move together with all the panels that meet there.",
        ),
        Parameter(
            "avoid_self_intersections",
            Boolean(),
            False,
            "Shorten or refuse moves that would make the surface cut itself.",
        ),
        _MAP,
        _COLORIZE,
    ),
)

MEASURE = Filter(
    "maps",
    "Developability Maps",
    "compute_scalar_by_developability_per_vertex",
    (
        _PATCHES,
        _WELD_DISTANCE,
        _ANGLE_TOLERANCE,
        dataclasses.replace(_MAP, kind=Choice((*MAPS, "Elastic energy"))),
        Parameter("reference", Layer(), 0, "The layer that Distance and Displacement are measured to."),
        _COLORIZE,
    ),
)

FLATTEN = Filter(
    "flatten",
    "Flatten Patches",
    "generate_flat_patches",
    (
        _PATCHES,
        _WELD_DISTANCE,
        _ONLY_SELECTED,
        Parameter(
            "gap",
            Length(automatic=True),
            -1.0,
            "How far apart the pieces lie (length); -1 is 2 % of the largest piece's box.",
        ),
        Parameter(
            "map",
            Choice(("Edge strain", "Elastic energy")),
            "Edge strain",
            "What is written to the vertex quality.",
        ),
        Parameter(
            "write_texture_coordinates",
            Boolean(),
            False,
            "Write the patterns to the model too, as texture coordinates.",
        ),
        _COLORIZE,
    ),
)

TRIANGULATE = Filter(
    "triangulate",
    "Triangulate Polygons (Constrained Delaunay)",
    "meshing_polygons_to_constrained_delaunay",
    (),
)

FILTERS = (GLOBAL, LOCAL, MEASURE, FLATTEN, TRIANGULATE)


def find_filter(name: str) -> Filter:
    """The filter with that name: on the command line, in menus, or in pymeshlab.

    Raises InvalidParameterError with the names there are.
    """
    for known in FILTERS:
        if name.strip().lower() in (known.name, known.title.lower(), known.function):
            return known
    names = ", ".join(known.name for known in FILTERS)
    raise InvalidParameterError(f"there is no filter {name!r}; the filters are {names}")
