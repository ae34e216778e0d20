# SPDX-License-Identifier: GPL-3.0-or-later
# Generated from the built plugin by: .venv/bin/python python/generate_filters.py

"""The filters of the plugin, the statuses and the reasons, as the plugin describes them."""

from __future__ import annotations

import enum

from meshlab_developable.parameters import (
    Boolean,
    Choice,
    Filter,
    Grain,
    Layer,
    Length,
    Material,
    Number,
    Parameter,
    Whole,
)

GLOBAL = Filter(
    "global",
    "Global Developability",
    "apply_coord_global_developability",
    (
        Parameter(
            "solver",
            Choice(("Constrained Newton", "Conjugate gradient")),
            "Constrained Newton",
            "",
            "How the shape is found: by Newton steps all the way to developable, or as in the paper.",
        ),
        Parameter(
            "patches",
            Choice(("Connected components", "Face colour", "Texture islands", "Face quality")),
            "Connected components",
            "",
            "What separates the patches: nothing but gaps, or also edges between faces of different colour, texture island or quality.",
        ),
        Parameter(
            "weld_distance",
            Length(),
            0.0,
            "length",
            "Vertices at most this far apart are linked and move as one; 0 links only those with equal coordinates.",
        ),
        Parameter(
            "only_selected",
            Boolean(),
            False,
            "",
            "Work on the patches that have a selected face; the others hold still.",
        ),
        Parameter(
            "fix_boundary", Boolean(), False, "", "Vertices on the boundary of a patch stay where they are."
        ),
        Parameter("fix_selected", Boolean(), False, "", "Selected vertices stay where they are."),
        Parameter(
            "angle_tolerance",
            Number(positive_for_solver="Constrained Newton"),
            0.0001,
            "rad",
            "A vertex whose angle defect is no larger than this counts as a developable point.",
        ),
        Parameter(
            "curvature_tolerance",
            Number(minimum_excluded=True),
            0.0001,
            "rad",
            "Constrained Newton only: a patch is developable when its absolute angle defects add up to no more than this.",
        ),
        Parameter("max_iterations", Whole(), 200, "", "The run ends after so many steps at the latest."),
        Parameter(
            "relative_change",
            Number(),
            0.0001,
            "",
            "Conjugate gradient only: the run ends when a step changes G by less than this share of its first value.",
        ),
        Parameter(
            "smoothness",
            Number(minimum_excluded=True, maximum=1),
            3e-06,
            "",
            "Constrained Newton only: how much weight bending has against distance; larger values give fewer wrinkles.",
        ),
        Parameter(
            "fairness",
            Number(maximum=1),
            0.0,
            "",
            "Constrained Newton only: how much detail is smoothed away: bumps shorter than this share of the size of their part.",
        ),
        Parameter(
            "max_displacement",
            Length(automatic=True),
            -1.0,
            "length",
            "Constrained Newton only: no vertex ends farther than this from where it was; -1 means 15 % of its part's diagonal.",
        ),
        Parameter(
            "material",
            Material(
                (
                    "Custom",
                    "Sheet steel",
                    "Sheet aluminium",
                    "Plywood",
                    "Leather",
                    "Woven cloth",
                    "Knit",
                    "Paper",
                )
            ),
            "Custom",
            "",
            "Constrained Newton only: What the panels are made of, which says how far they may be stretched and compressed.",
        ),
        Parameter(
            "allowed_stretch",
            Number(minimum=-1, maximum=1000),
            -1.0,
            "%",
            "Constrained Newton only: How much longer the material may be on the shape than in the pattern; -1 is what it bears.",
        ),
        Parameter(
            "allowed_compression",
            Number(minimum=-1, maximum=100),
            -1.0,
            "%",
            "Constrained Newton only: How much shorter the material may be on the shape than in the pattern; -1 is what it bears.",
        ),
        Parameter(
            "grain",
            Grain(("Longest seam", "X axis", "Y axis", "Z axis")),
            "Longest seam",
            "",
            "Constrained Newton only: Which way the grain, the warp of a cloth, runs in every panel.",
        ),
        Parameter(
            "thickness",
            Length(),
            0.0,
            "length",
            "Constrained Newton only: How thick the material is, in the mesh's unit; 0 means that bending is not judged.",
        ),
        Parameter(
            "map",
            Choice(
                (
                    "Gaussian map",
                    "Angle defect",
                    "Gaussian curvature",
                    "Minimum curvature",
                    "Maximum curvature",
                    "Distance",
                    "Displacement",
                )
            ),
            "Displacement",
            "",
            "What is written to the vertex quality.",
        ),
        Parameter(
            "colorize",
            Boolean(),
            True,
            "",
            "Colour the vertices by the map, in place of the colours that they have.",
        ),
    ),
)

LOCAL = Filter(
    "local",
    "Local Developability",
    "apply_coord_local_developability",
    (
        Parameter(
            "patches",
            Choice(("Connected components", "Face colour", "Texture islands", "Face quality")),
            "Connected components",
            "",
            "What separates the patches: nothing but gaps, or also edges between faces of different colour, texture island or quality.",
        ),
        Parameter(
            "weld_distance",
            Length(),
            0.0,
            "length",
            "Vertices at most this far apart are linked and move as one; 0 links only those with equal coordinates.",
        ),
        Parameter(
            "only_selected",
            Boolean(),
            False,
            "",
            "Work on the patches that have a selected face; the others hold still.",
        ),
        Parameter("fix_selected", Boolean(), False, "", "Selected vertices stay where they are."),
        Parameter(
            "angle_tolerance",
            Number(),
            0.0001,
            "rad",
            "A vertex whose angle defect is no larger than this counts as a developable point.",
        ),
        Parameter(
            "max_displacement",
            Length(automatic=True),
            -1.0,
            "length",
            "How far a vertex may move along its original normal; -1 means the mean edge length.",
        ),
        Parameter(
            "max_operations",
            Whole(),
            500000,
            "",
            "The run ends after so many visits to a vertex at the latest.",
        ),
        Parameter(
            "descent",
            Boolean(),
            False,
            "",
            "Halve each move until the vertex and its neighbours come nearer to developable, and set it aside if none does.",
        ),
        Parameter(
            "smoothing",
            Number(),
            0.0,
            "rad²",
            "How strongly the moves of neighbours are kept alike, against wrinkles; try 0.01 to 0.1.",
        ),
        Parameter(
            "assembling_vertices",
            Choice(("Fixed", "Move together")),
            "Fixed",
            "",
            "Whether vertices on seams stay fixed, or move together with all panels that meet there.",
        ),
        Parameter(
            "avoid_self_intersections",
            Boolean(),
            False,
            "",
            "Shorten or refuse moves that would make the surface cut itself.",
        ),
        Parameter(
            "map",
            Choice(
                (
                    "Gaussian map",
                    "Angle defect",
                    "Gaussian curvature",
                    "Minimum curvature",
                    "Maximum curvature",
                    "Distance",
                    "Displacement",
                )
            ),
            "Displacement",
            "",
            "What is written to the vertex quality.",
        ),
        Parameter(
            "colorize",
            Boolean(),
            True,
            "",
            "Colour the vertices by the map, in place of the colours that they have.",
        ),
    ),
)

MAPS = Filter(
    "maps",
    "Developability Maps",
    "compute_scalar_by_developability_per_vertex",
    (
        Parameter(
            "patches",
            Choice(("Connected components", "Face colour", "Texture islands", "Face quality")),
            "Connected components",
            "",
            "What separates the patches: nothing but gaps, or also edges between faces of different colour, texture island or quality.",
        ),
        Parameter(
            "weld_distance",
            Length(),
            0.0,
            "length",
            "Vertices at most this far apart are linked and move as one; 0 links only those with equal coordinates.",
        ),
        Parameter(
            "angle_tolerance",
            Number(),
            0.0001,
            "rad",
            "A vertex whose angle defect is no larger than this counts as a developable point.",
        ),
        Parameter(
            "map",
            Choice(
                (
                    "Gaussian map",
                    "Angle defect",
                    "Gaussian curvature",
                    "Minimum curvature",
                    "Maximum curvature",
                    "Distance",
                    "Displacement",
                    "Elastic energy",
                    "Bending radius",
                )
            ),
            "Gaussian map",
            "",
            "What is written to the vertex quality.",
        ),
        Parameter(
            "reference",
            Layer(),
            0,
            "",
            "The layer that the maps Distance and Displacement are measured from.",
        ),
        Parameter(
            "colorize",
            Boolean(),
            True,
            "",
            "Colour the vertices by the map, in place of the colours that they have.",
        ),
    ),
)

FLATTEN = Filter(
    "flatten",
    "Flatten Patches",
    "generate_flat_patches",
    (
        Parameter(
            "patches",
            Choice(("Connected components", "Face colour", "Texture islands", "Face quality")),
            "Connected components",
            "",
            "What separates the patches: nothing but gaps, or also edges between faces of different colour, texture island or quality.",
        ),
        Parameter(
            "weld_distance",
            Length(),
            0.0,
            "length",
            "Vertices at most this far apart are linked and move as one; 0 links only those with equal coordinates.",
        ),
        Parameter(
            "only_selected",
            Boolean(),
            False,
            "",
            "Work on the patches that have a selected face; the others hold still.",
        ),
        Parameter(
            "material",
            Material(
                (
                    "Custom",
                    "Sheet steel",
                    "Sheet aluminium",
                    "Plywood",
                    "Leather",
                    "Woven cloth",
                    "Knit",
                    "Paper",
                )
            ),
            "Custom",
            "",
            "What the panels are made of, which says how far they may be stretched and compressed.",
        ),
        Parameter(
            "allowed_stretch",
            Number(minimum=-1, maximum=1000),
            -1.0,
            "%",
            "How much longer the material may be on the shape than in the pattern; -1 is what it bears.",
        ),
        Parameter(
            "allowed_compression",
            Number(minimum=-1, maximum=100),
            -1.0,
            "%",
            "How much shorter the material may be on the shape than in the pattern; -1 is what it bears.",
        ),
        Parameter(
            "grain",
            Grain(("Longest seam", "X axis", "Y axis", "Z axis")),
            "Longest seam",
            "",
            "Which way the grain, the warp of a cloth, runs in every panel.",
        ),
        Parameter(
            "gap",
            Length(automatic=True),
            -1.0,
            "length",
            "How far apart the pieces lie; -1 means 2 % of the diagonal of the largest piece's box.",
        ),
        Parameter(
            "map",
            Choice(("Edge strain", "Elastic energy", "Stretch", "Compression")),
            "Edge strain",
            "",
            "What is written to the vertex quality of the model and of the patterns.",
        ),
        Parameter(
            "write_texture_coordinates",
            Boolean(),
            False,
            "",
            "Write the patterns to the model too, as texture coordinates of its face corners, scaled to fit the unit square.",
        ),
        Parameter(
            "colorize",
            Boolean(),
            True,
            "",
            "Colour the vertices by the map, in place of the colours that they have.",
        ),
    ),
)

CUT = Filter(
    "cut",
    "Cut into Developable Panels",
    "meshing_cut_into_developable_panels",
    (
        Parameter(
            "patches",
            Choice(("Connected components", "Face colour", "Texture islands", "Face quality")),
            "Connected components",
            "",
            "What separates the patches: nothing but gaps, or also edges between faces of different colour, texture island or quality.",
        ),
        Parameter(
            "weld_distance",
            Length(),
            0.0,
            "length",
            "Vertices at most this far apart are linked and move as one; 0 links only those with equal coordinates.",
        ),
        Parameter(
            "only_selected",
            Boolean(),
            False,
            "",
            "Work on the patches that have a selected face; the others hold still.",
        ),
        Parameter(
            "keep_selected_whole", Boolean(), False, "", "No seam and no dart crosses a selected face."
        ),
        Parameter(
            "max_displacement",
            Length(automatic=True),
            -1.0,
            "length",
            "How far a vertex may move when the panels are made developable; -1 means 2 % of the diagonal of each part.",
        ),
        Parameter(
            "material",
            Material(
                (
                    "Custom",
                    "Sheet steel",
                    "Sheet aluminium",
                    "Plywood",
                    "Leather",
                    "Woven cloth",
                    "Knit",
                    "Paper",
                )
            ),
            "Custom",
            "",
            "What the panels are made of, which says how far they may be stretched and compressed.",
        ),
        Parameter(
            "allowed_stretch",
            Number(minimum=-1, maximum=1000),
            -1.0,
            "%",
            "How much longer the material may be on the shape than in the pattern; -1 is what it bears.",
        ),
        Parameter(
            "allowed_compression",
            Number(minimum=-1, maximum=100),
            -1.0,
            "%",
            "How much shorter the material may be on the shape than in the pattern; -1 is what it bears.",
        ),
        Parameter(
            "grain",
            Grain(("Longest seam", "X axis", "Y axis", "Z axis")),
            "Longest seam",
            "",
            "Which way the grain, the warp of a cloth, runs in every panel.",
        ),
        Parameter(
            "max_panels",
            Whole(),
            0,
            "",
            "So many panels at most, even if some then can't be made developable within the largest displacement; 0 means as many as it takes.",
        ),
        Parameter(
            "darts",
            Boolean(),
            True,
            "",
            "Where a cut from the border is enough a panel stays whole and gets a dart.",
        ),
        Parameter(
            "crease_angle",
            Number(maximum=180),
            40.0,
            "°",
            "Seams like to lie on edges whose faces make a sharper turn than this.",
        ),
        Parameter(
            "symmetric",
            Boolean(),
            False,
            "",
            "Left and right panels of a surface that is its own mirror image mirror each other, and have no darts.",
        ),
        Parameter(
            "cut",
            Boolean(),
            True,
            "",
            "Double the vertices along seams and darts, and split faces where seams cross them; else faces are only labelled.",
        ),
        Parameter("colorize", Boolean(), True, "", "Colour the faces by panel."),
    ),
)

RESTORE = Filter(
    "restore",
    "Restore Original Shape",
    "apply_coord_restore_original_shape",
    (),
)

TRIANGULATE = Filter(
    "triangulate",
    "Triangulate Polygons (Constrained Delaunay)",
    "meshing_polygons_to_constrained_delaunay",
    (),
)

FILTERS = (GLOBAL, LOCAL, MAPS, FLATTEN, CUT, RESTORE, TRIANGULATE)


class Status(enum.IntEnum):
    """Why an optimisation ended; `text` says it in the words of the filters' log."""

    CONVERGED = 0
    STALLED = 1
    LIMIT_REACHED = 2
    NEEDS_CUT = 3
    STOPPED = 4
    NOTHING_TO_DO = 5

    @property
    def text(self) -> str:
        """In words."""
        return _STATUS_TEXTS[self]


_STATUS_TEXTS = {
    Status.CONVERGED: "converged",
    Status.STALLED: "stalled: further steps would change next to nothing",
    Status.LIMIT_REACHED: "stopped at the limit of iterations or operations",
    Status.NEEDS_CUT: "no developable shape near this one: it needs a cut",
    Status.STOPPED: "stopped by the user: nothing was changed",
    Status.NOTHING_TO_DO: "nothing to do: developable from the start",
}


class Reason(enum.IntEnum):
    """What there is to say of a status beyond its own text; {names} stand for results of the filter."""

    AS_STATUS = 0
    NOT_LOWERED = 1
    NOTHING_MOVES = 2
    NEEDS_CUT = 3
    UNSOLVABLE = 4
    TOO_FAR = 5
    NEARLY_THERE = 6
    BEYOND_BOUNDS = 7
    WITHIN_BOUNDS = 8
    BORDER_OVERLAPS = 9
    SEAM_TOO_FAR = 10
    SEAM_OVERLAPS = 11
    SEAM_NO_SHEET = 12
    SEAM_BEYOND_BOUNDS = 13
    SEAM_SEWN = 14
    SEAM_STILL = 15
    SEAM_CRUMPLES = 16

    @property
    def text(self) -> str:
        """In words."""
        return _REASON_TEXTS[self]


_REASON_TEXTS = {
    Reason.AS_STATUS: "",
    Reason.NOT_LOWERED: "stalled: the last 20 operations a movable vertex have not lowered G",
    Reason.NOTHING_MOVES: "stalled: within the tolerance nothing can move any more",
    Reason.NEEDS_CUT: "no developable shape near this one: it needs a cut in {patches_needing_cut} of {patches} patches, first of all at ({worst_x}, {worst_y}, {worst_z}); next, cut it: 'developable cut' on the command line, the filter Cut into Developable Panels in MeshLab",
    Reason.UNSOLVABLE: "stalled: a linear system of this shape has no solution in double precision; the best shape so far is kept",
    Reason.TOO_FAR: "no developable shape near this one: it needs a cut in {patches_needing_cut} of {patches} patches, first of all at ({worst_x}, {worst_y}, {worst_z}); the nearest developable one found moves a vertex by {nearest_developable}, farther than max_displacement allows",
    Reason.NEARLY_THERE: "no developable shape near this one: it needs a cut in {patches_needing_cut} of {patches} patches, first of all at ({worst_x}, {worst_y}, {worst_z}); but it is nearly there: laid flat as it is, no edge changes its length by more than {edge_strain_left} %",
    Reason.BEYOND_BOUNDS: "no shape near this one has a pattern within the allowed strain: it needs a cut in {patches_needing_cut} of {patches} patches, first of all at ({worst_x}, {worst_y}, {worst_z})",
    Reason.WITHIN_BOUNDS: "every panel has a pattern within the allowed strain",
    Reason.BORDER_OVERLAPS: "the curvature is gone, but the angles of a panel's faces add up to more than a full turn at border vertices ({border_overlaps} in number), first of all at ({worst_x}, {worst_y}, {worst_z}): laid flat it overlaps itself there; a cut that ends there would do, or more room to move (max_displacement, fewer vertices held still)",
    Reason.SEAM_TOO_FAR: "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), has to be: without it a vertex would have to move farther than max_displacement allows",
    Reason.SEAM_OVERLAPS: "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), has to be: without it the panel would overlap itself when laid flat",
    Reason.SEAM_NO_SHEET: "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), has to be: without it the panel would close round on itself, as a ring, a tube or a ball, and not be one sheet",
    Reason.SEAM_BEYOND_BOUNDS: "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), has to be: without it the panel would be strained by more than the material bears",
    Reason.SEAM_SEWN: "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), was found to help: without it the panel would do by itself, but hardly with smooth seams and sewn to the others",
    Reason.SEAM_STILL: "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), spares all movement: without it the panel would do, but not as it is",
    Reason.SEAM_CRUMPLES: "its longest seam, beside panel {neighbour} at ({seam_x}, {seam_y}, {seam_z}), has to be: without it the panel would crumple",
}


# Follows a reason's text that lacks it, where {edge_strain_left} comes of curvature left.
STRAIN_LEFT = "; laid flat as it is, no edge changes its length by more than {edge_strain_left} %"


# Of an optimisation, by a key of its results: above which value, and what to say.
WARNINGS = (
    (
        "max_displacement_per_cent",
        5.0,
        "far from its input: a vertex moved by {max_displacement} units of the mesh, {max_displacement_per_cent} % of its part's diagonal",
    ),
    ("folded_faces", 0.0, "{folded_faces} faces are folded over their neighbours"),
    ("shrunken_patches", 0.0, "{shrunken_patches} of {patches} patches lost more than half of their area"),
    (
        "collapsed_faces",
        0.0,
        "laid flat as it is, {collapsed_faces} faces collapse, thinner than a tenth: their stretch counts as 900 %",
    ),
)
