# SPDX-License-Identifier: GPL-3.0-or-later
# Generated from the built plugin by: .venv/bin/python python/generate_filters.py

"""The functions that take the parameters of filters, each parameter by its name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal

import numpy.typing as npt

from meshlab_developable import cutting, flattening, methods
from meshlab_developable.cutting import CutPanels
from meshlab_developable.declarations import implemented_by
from meshlab_developable.flattening import FlatteningResult
from meshlab_developable.mesh_sets import Source
from meshlab_developable.methods import Developed, Measured


@implemented_by(methods.measure)
def measure(
    vertices: Source,
    faces: npt.ArrayLike | None = None,
    *,
    face_labels: npt.ArrayLike | None = None,
    texture_coordinates: npt.ArrayLike | None = None,
    reference: Source | tuple[npt.ArrayLike, npt.ArrayLike] | None = None,
    patches: Literal[
        "Connected components", "Face colour", "Texture islands", "Face quality"
    ] = "Connected components",
    weld_distance: float | str = 0.0,
    angle_tolerance: float = 0.0001,
    map: Literal[
        "Gaussian map",
        "Angle defect",
        "Gaussian curvature",
        "Minimum curvature",
        "Maximum curvature",
        "Distance",
        "Displacement",
        "Elastic energy",
        "Bending radius",
    ] = "Gaussian map",
    colorize: bool = True,
) -> Measured:
    """How developable a mesh is.

    vertices: n x 3, any unit of length. faces: m x 3 indices from 0. Or, in place of the two, a file that
    pymeshlab, trimesh or meshio reads, or an object of trimesh or meshio. Connected components are the
    patches, unless there are labels or texture coordinates, or `patches` says otherwise; vertices that
    coincide are linked.

    face_labels: m of any kind; patches meet where labels differ. texture_coordinates: n x 2, or m x 3 x 2 at
    the faces' corners; patches are the texture islands. reference: the mesh, as a source or as a pair of
    vertices and faces, that the maps Distance and Displacement are measured to. Other parameters are those of
    the filter Developability Maps; lengths are plain numbers in the mesh's unit.

    Raises InvalidMeshError, InvalidParameterError, FilterError and what `load` raises.

    Parameters of the filter:
        patches: What separates the patches: nothing but gaps, or also edges between faces of different
            colour, texture island or quality.
        weld_distance (length): Vertices at most this far apart are linked and move as one; 0 links only
            those with equal coordinates.
        angle_tolerance (rad): A vertex whose angle defect is no larger than this counts as a developable
            point.
        map: What is written to the vertex quality.
        colorize: Colour the vertices by the map, in place of the colours that they have.
    """
    raise NotImplementedError


@implemented_by(methods.make_developable)
def make_developable(
    vertices: Source,
    faces: npt.ArrayLike | None = None,
    method: Literal["global", "local"] = "global",
    *,
    only_selected: npt.ArrayLike = False,
    fix_selected: npt.ArrayLike = False,
    face_labels: npt.ArrayLike | None = None,
    texture_coordinates: npt.ArrayLike | None = None,
    solver: Literal["Constrained Newton", "Conjugate gradient"] = "Constrained Newton",
    patches: Literal[
        "Connected components", "Face colour", "Texture islands", "Face quality"
    ] = "Connected components",
    weld_distance: float | str = 0.0,
    fix_boundary: bool = False,
    angle_tolerance: float = 0.0001,
    curvature_tolerance: float = 0.0001,
    max_iterations: int = 200,
    relative_change: float = 0.0001,
    smoothness: float = 3e-06,
    fairness: float = 0.0,
    max_displacement: float | str = -1.0,
    material: Literal[
        "Custom", "Sheet steel", "Sheet aluminium", "Plywood", "Leather", "Woven cloth", "Knit", "Paper"
    ]
    | str
    | Mapping[str, Any] = "Custom",
    allowed_stretch: float = -1.0,
    allowed_compression: float = -1.0,
    grain: Literal["Longest seam", "X axis", "Y axis", "Z axis"] | Sequence[float] = "Longest seam",
    thickness: float | str = 0.0,
    map: Literal[
        "Gaussian map",
        "Angle defect",
        "Gaussian curvature",
        "Minimum curvature",
        "Maximum curvature",
        "Distance",
        "Displacement",
    ] = "Displacement",
    colorize: bool = True,
    max_operations: int = 500000,
    descent: bool = False,
    smoothing: float = 0.0,
    assembling_vertices: Literal["Fixed", "Move together"] = "Fixed",
    avoid_self_intersections: bool = False,
) -> Developed:
    """Move the vertices so that each patch becomes developable, or nearer to it, and little else changes.

    vertices: n x 3, any unit of length. faces: m x 3 indices from 0. Or, in place of the two, a file that
    pymeshlab, trimesh or meshio reads, or an object of trimesh or meshio. Connected components are the
    patches, unless there are labels or texture coordinates, or `patches` says otherwise; vertices that
    coincide are linked and stay together. The arrays given are not changed.

    method: "global" (Wang and Tang 2004, Section 4, or constrained Newton) or "local" (Section 5).
    only_selected: m of bool; only the patches with such a face are worked on, the others hold still.
    fix_selected: n of bool; these vertices stay. (True alone means the selection that a file brings.)
    face_labels: m of any kind; patches meet where labels differ. texture_coordinates: n x 2, or m x 3 x 2
    at the faces' corners; patches are the texture islands. Other parameters are those of the filters Global
    and Local Developability; lengths are plain numbers in the mesh's unit.

    Not converging is no error: see `report.status`. Raises InvalidMeshError, InvalidParameterError,
    FilterError and what `load` raises.

    Parameters of the filters:
        solver (only for 'global'): How the shape is found: by Newton steps all the way to developable, or
            as in the paper.
        patches: What separates the patches: nothing but gaps, or also edges between faces of different
            colour, texture island or quality.
        weld_distance (length): Vertices at most this far apart are linked and move as one; 0 links only
            those with equal coordinates.
        fix_boundary (only for 'global'): Vertices on the boundary of a patch stay where they are.
        angle_tolerance (rad): A vertex whose angle defect is no larger than this counts as a developable
            point.
        curvature_tolerance (rad; > 0; only for 'global'): Constrained Newton only: a patch is developable
            when its absolute angle defects add up to no more than this.
        max_iterations (only for 'global'): The run ends after so many steps at the latest.
        relative_change (only for 'global'): Conjugate gradient only: the run ends when a step changes G by
            less than this share of its first value.
        smoothness (> 0; ≤ 1; only for 'global'): Constrained Newton only: how much weight bending has
            against distance; larger values give fewer wrinkles.
        fairness (≤ 1; only for 'global'): Constrained Newton only: how much detail is smoothed away: bumps
            shorter than this share of the size of their part.
        max_displacement (length): Constrained Newton only: no vertex ends farther than this from where it
            was; -1 means 15 % of its part's diagonal. For 'local': How far a vertex may move along its
            original normal; -1 means the mean edge length.
        material (only for 'global'): Constrained Newton only: What the panels are made of, which says how
            far they may be stretched and compressed.
        allowed_stretch (%; ≤ 1000; only for 'global'): Constrained Newton only: How much longer the
            material may be on the shape than in the pattern; -1 is what it bears.
        allowed_compression (%; ≤ 100; only for 'global'): Constrained Newton only: How much shorter the
            material may be on the shape than in the pattern; -1 is what it bears.
        grain (only for 'global'): Constrained Newton only: Which way the grain, the warp of a cloth, runs
            in every panel.
        thickness (length; only for 'global'): Constrained Newton only: How thick the material is, in the
            mesh's unit; 0 means that bending is not judged.
        map: What is written to the vertex quality.
        colorize: Colour the vertices by the map, in place of the colours that they have.
        max_operations (only for 'local'): The run ends after so many visits to a vertex at the latest.
        descent (only for 'local'): Halve each move until the vertex and its neighbours come nearer to
            developable, and set it aside if none does.
        smoothing (rad²; only for 'local'): How strongly the moves of neighbours are kept alike, against
            wrinkles; try 0.01 to 0.1.
        assembling_vertices (only for 'local'): Whether vertices on seams stay fixed, or move together with
            all panels that meet there.
        avoid_self_intersections (only for 'local'): Shorten or refuse moves that would make the surface cut
            itself.
    """
    raise NotImplementedError


@implemented_by(cutting.cut_into_panels)
def cut_into_panels(
    vertices: Source,
    faces: npt.ArrayLike | None = None,
    *,
    only_selected: npt.ArrayLike | None = None,
    keep_selected_whole: npt.ArrayLike | None = None,
    face_labels: npt.ArrayLike | None = None,
    texture_coordinates: npt.ArrayLike | None = None,
    patches: Literal[
        "Connected components", "Face colour", "Texture islands", "Face quality"
    ] = "Connected components",
    weld_distance: float | str = 0.0,
    max_displacement: float | str = -1.0,
    material: Literal[
        "Custom", "Sheet steel", "Sheet aluminium", "Plywood", "Leather", "Woven cloth", "Knit", "Paper"
    ]
    | str
    | Mapping[str, Any] = "Custom",
    allowed_stretch: float = -1.0,
    allowed_compression: float = -1.0,
    grain: Literal["Longest seam", "X axis", "Y axis", "Z axis"] | Sequence[float] = "Longest seam",
    max_panels: int = 0,
    darts: bool = True,
    crease_angle: float = 40.0,
    symmetric: bool = False,
    cut: bool = True,
    colorize: bool = True,
) -> CutPanels:
    """Cut a surface, open or closed, into few panels that can be made developable, with short seams.

    vertices: n x 3, any unit of length. faces: m x 3 indices from 0. Or, in place of the two, a file that
    pymeshlab, trimesh or meshio reads, or an object of trimesh or meshio. Nothing is moved. Vertices along
    seams are doubled and coincide, so that `make_developable` and `flatten` take the result as it is.

    only_selected: m of bool; only the patches with such a face are cut. keep_selected_whole: m of bool; no
    seam crosses these faces. face_labels: m of any kind; patches meet where labels differ, and are only cut
    further. texture_coordinates: n x 2, or m x 3 x 2 at the faces' corners; patches are the texture islands.
    Other parameters are those of the filter Cut into Developable Panels; lengths are plain numbers in the
    mesh's unit.

    Raises InvalidMeshError, InvalidParameterError, FilterError and what `load` raises.

    Parameters of the filter:
        patches: What separates the patches: nothing but gaps, or also edges between faces of different
            colour, texture island or quality.
        weld_distance (length): Vertices at most this far apart are linked and move as one; 0 links only
            those with equal coordinates.
        max_displacement (length): How far a vertex may move when the panels are made developable; -1 means
            2 % of the diagonal of each part.
        material: What the panels are made of, which says how far they may be stretched and compressed.
        allowed_stretch (%; ≤ 1000): How much longer the material may be on the shape than in the pattern;
            -1 is what it bears.
        allowed_compression (%; ≤ 100): How much shorter the material may be on the shape than in the
            pattern; -1 is what it bears.
        grain: Which way the grain, the warp of a cloth, runs in every panel.
        max_panels: So many panels at most, even if some then can't be made developable within the largest
            displacement; 0 means as many as it takes.
        darts: Where a cut from the border is enough a panel stays whole and gets a dart.
        crease_angle (°; ≤ 180): Seams like to lie on edges whose faces make a sharper turn than this.
        symmetric: Left and right panels of a surface that is its own mirror image mirror each other, and
            have no darts.
        cut: Double the vertices along seams and darts, and split faces where seams cross them; else faces
            are only labelled.
        colorize: Colour the faces by panel.
    """
    raise NotImplementedError


@implemented_by(flattening.flatten)
def flatten(
    vertices: Source,
    faces: npt.ArrayLike | None = None,
    *,
    only_selected: npt.ArrayLike | None = None,
    face_labels: npt.ArrayLike | None = None,
    texture_coordinates: npt.ArrayLike | None = None,
    patches: Literal[
        "Connected components", "Face colour", "Texture islands", "Face quality"
    ] = "Connected components",
    weld_distance: float | str = 0.0,
    material: Literal[
        "Custom", "Sheet steel", "Sheet aluminium", "Plywood", "Leather", "Woven cloth", "Knit", "Paper"
    ]
    | str
    | Mapping[str, Any] = "Custom",
    allowed_stretch: float = -1.0,
    allowed_compression: float = -1.0,
    grain: Literal["Longest seam", "X axis", "Y axis", "Z axis"] | Sequence[float] = "Longest seam",
    gap: float | str = -1.0,
    map: Literal["Edge strain", "Elastic energy", "Stretch", "Compression"] = "Edge strain",
    write_texture_coordinates: bool = False,
    colorize: bool = True,
) -> FlatteningResult:
    """Lay every patch flat at the mesh's own scale, with edges as long as they are on the mesh, or nearly.

    vertices: n x 3, any unit of length. faces: m x 3 indices from 0. Or, in place of the two, a file that
    pymeshlab, trimesh or meshio reads, or an object of trimesh or meshio. Connected components are the
    patches, unless there are labels or texture coordinates, or `patches` says otherwise.

    only_selected: m of bool; only the patches with such a face are laid flat. face_labels: m of any kind;
    patches meet where labels differ. texture_coordinates: n x 2, or m x 3 x 2 at the faces' corners; patches
    are the texture islands. Other parameters are those of the filter Flatten Patches; lengths are plain
    numbers in the mesh's unit.

    Raises InvalidMeshError, InvalidParameterError, FilterError (for closed patches, patches with handles,
    faces without area) and what `load` raises.

    Parameters of the filter:
        patches: What separates the patches: nothing but gaps, or also edges between faces of different
            colour, texture island or quality.
        weld_distance (length): Vertices at most this far apart are linked and move as one; 0 links only
            those with equal coordinates.
        material: What the panels are made of, which says how far they may be stretched and compressed.
        allowed_stretch (%; ≤ 1000): How much longer the material may be on the shape than in the pattern;
            -1 is what it bears.
        allowed_compression (%; ≤ 100): How much shorter the material may be on the shape than in the
            pattern; -1 is what it bears.
        grain: Which way the grain, the warp of a cloth, runs in every panel.
        gap (length): How far apart the pieces lie; -1 means 2 % of the diagonal of the largest piece's box.
        map: What is written to the vertex quality of the model and of the patterns.
        write_texture_coordinates: Write the patterns to the model too, as texture coordinates of its face
            corners, scaled to fit the unit square.
        colorize: Colour the vertices by the map, in place of the colours that they have.
    """
    raise NotImplementedError
