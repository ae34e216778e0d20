# SPDX-License-Identifier: GPL-3.0-or-later
"""What is done with one mesh: measured, then each method tried on a copy of it, results and pictures kept."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pymeshlab

from meshlab_developable.cutting import CutReport, cut_layer, seam_tolerance
from meshlab_developable.errors import PatternError
from meshlab_developable.flattening import FlatteningResult, flattened_layer
from meshlab_developable.panels import panel_reports
from meshlab_developable.patterns import UNITS, PatternOptions, write_patterns
from meshlab_developable.plugin import vertex_quality
from meshlab_developable.rendering import Array, IndexArray, Picture, View, render, robust_scale
from meshlab_developable.reports import DEVELOPABLE, Measures, OptimizationReport, PatternReport


@dataclasses.dataclass(frozen=True)
class Input:
    """A mesh to try."""

    path: Path
    what: str  # a sentence
    unit: str = "model units"
    view: View = dataclasses.field(default_factory=View)
    cut: bool = False  # first cut it into panels, as closed surfaces have to be

    @property
    def name(self) -> str:
        """What files and headings call it."""
        return self.path.stem

    @property
    def square_unit(self) -> str:
        """The unit of areas and energies."""
        return f"({self.unit})²" if " " in self.unit else f"{self.unit}²"


@dataclasses.dataclass(frozen=True)
class Method:
    """A filter with its parameters."""

    name: str  # in file names
    title: str
    what: str  # a sentence
    filter: str
    parameters: Mapping[str, Any]
    flatten: bool = False  # lay the result flat when the method has converged


@dataclasses.dataclass(frozen=True)
class MapKind:
    """A map to show."""

    title: str  # as the filter's parameter `map` has it
    label: str  # with the unit
    signed: bool
    caption: str
    before_too: bool = True  # False for maps that are 0 before
    of_pattern: bool = False  # comes with a flat pattern, and is shown where there is one


@dataclasses.dataclass(frozen=True)
class Pattern:
    """A surface laid flat, and what that costs."""

    report: PatternReport
    vertices: Array  # in the plane z = 0
    faces: IndexArray
    edge_strain: Array  # the largest at each vertex
    maps: Mapping[str, Array]  # of the surface that was laid flat, by the map's title
    file: Path
    to_cut: Sequence[Path] = ()  # the same as SVG, PDF and DXF


@dataclasses.dataclass(frozen=True)
class Outcome:
    """What a method made of a mesh."""

    method: Method
    report: OptimizationReport
    vertices: Array  # n x 3
    maps: Mapping[str, Array]  # n values by the map's title; those of a pattern where there is one
    file: Path
    pattern: Pattern | None = None

    @property
    def marks(self) -> list[tuple[float, float, float]]:
        """Where most curvature is left, of each panel that is not developable."""
        left = [panel for panel in self.report.panels if panel.status not in DEVELOPABLE]
        return [panel.worst_point for panel in left]


@dataclasses.dataclass(frozen=True)
class Figure:
    """A picture in the report."""

    file: Path
    title: str
    caption: str


@dataclasses.dataclass(frozen=True)
class Study:
    """All that is known about one mesh."""

    source: Input
    angle_tolerance: float  # rad
    vertices: Array  # n x 3
    faces: IndexArray  # m x 3
    measures: Measures
    maps: Mapping[str, Array]  # n values by the map's title, before
    outcomes: Sequence[Outcome]
    figures: Sequence[Figure]
    pattern: Pattern | None = None  # of the mesh as it came, where an outcome has one to compare
    cut: CutReport | None = None  # where it was cut into panels before all else

    @property
    def diagonal(self) -> float:
        """Diagonal of the bounding box."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))

    @property
    def angle_defects(self) -> dict[str, Array]:
        """Of the vertices inside patches, rad, by what was done; boundary vertices have none."""
        sides = np.sort(self.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        edges, uses = np.unique(sides, axis=0, return_counts=True)
        inside = np.setdiff1d(self.faces, edges[uses == 1])
        named = {"before": self.maps} | {f"after: {o.method.title}": o.maps for o in self.outcomes}
        return {name: maps["Angle defect"][inside] for name, maps in named.items()}


MAPS = (
    MapKind(
        "Angle defect",
        "angle defect g, rad",
        True,
        "Red: the surface is a dome there, flat material has too much round it and needs a dart. Blue: it is "
        "a saddle, flat material has too little. Grey: it can be laid flat. Rings: where most is left in a "
        "panel that is not developable.",
    ),
    MapKind(
        "Gaussian map",
        "Gaussian map g², rad²",
        False,
        "The squared angle defect, as in Fig. 5 to 7 of the paper. The paper's methods lower its sum.",
    ),
    MapKind(
        "Gaussian curvature",
        "Gaussian curvature κ, 1/{square_unit}",
        True,
        "The angle defect for each unit of area (Eq. 1), which does not depend on how fine the mesh is.",
    ),
    MapKind(
        "Minimum curvature",
        "|κ_min|, 1/({unit})",
        False,
        "The principal curvature of smaller absolute value: 0 on a developable surface (Fig. 10).",
    ),
    MapKind(
        "Maximum curvature",
        "|κ_max|, 1/({unit})",
        False,
        "The other principal curvature: how strongly the material is bent (Fig. 10).",
    ),
    MapKind("Displacement", "distance moved, {unit}", False, "How far each vertex moved.", before_too=False),
    MapKind(
        "Distance",
        "distance to the surface before, {unit}",
        False,
        "How far each vertex is from the nearest point of the surface before (Fig. 8).",
        before_too=False,
    ),
    MapKind(
        "Elastic energy",
        "elastic energy of laying it flat, {square_unit}",
        False,
        "Where the surface must stretch or shrink to lie flat (Fig. 1): the squared changes of length of the "
        "edges at each vertex, half of each edge to each of its ends.",
        of_pattern=True,
    ),
)
MARKED = "Angle defect"  # the map with a ring where most curvature is left in a panel
MAPS_OF_PANELS = tuple(kind for kind in MAPS if kind.title in (MARKED, "Displacement"))
EYE_ABOVE = View((0.0, 0.0, 1.0), (0.0, 1.0, 0.0))


def study(
    source: Input,
    methods: Sequence[Method],
    angle_tolerance: float,
    folder: Path,
    kinds: Sequence[MapKind] = MAPS,
) -> Study:
    """Measure a mesh, try the methods, write results and pictures of the maps into the folder.

    It is cut first where the input says so.

    Raises pymeshlab.PyMeshLabException when the mesh cannot be read or a filter refuses it.
    """
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(source.path))
    cut = cut_layer(meshes, {}) if source.cut else None
    colours = meshes.current_mesh().face_color_matrix()[:, :3] if cut else None
    values = _apply_maps_filter(meshes, "Gaussian map", angle_tolerance)
    original = meshes.current_mesh()
    vertices, faces = original.vertex_matrix(), original.face_matrix()
    maps = _maps(meshes, [kind for kind in kinds if kind.before_too], angle_tolerance)
    _save(meshes, folder / f"{source.name}_before.ply")
    outcomes = [_try(meshes, source, method, angle_tolerance, folder, kinds) for method in methods]
    pattern = None
    if any(outcome.pattern for outcome in outcomes):
        meshes.set_current_mesh(0)
        pattern, _ = _flatten(meshes, folder / f"{source.name}_before_pattern.ply")
        maps |= pattern.maps
    shapes: list[tuple[str, Array, Mapping[str, Array]]] = [("before", vertices, maps)]
    shapes += [(f"after: {o.method.title}", o.vertices, o.maps) for o in outcomes]
    marks = {f"after: {o.method.title}": o.marks for o in outcomes}
    figures = []
    if colours is not None:
        figures.append(_panels_figure(source, [Picture(t, v, faces, colours) for t, v, _ in shapes], folder))
    for kind in kinds:
        pictures = [
            Picture(title, v, faces, m[kind.title], marks.get(title, ()) if kind.title == MARKED else ())
            for title, v, m in shapes
            if kind.title in m
        ]
        if pictures:
            figures.append(_figure(kind, source, pictures, folder))
    if pattern:
        figures.append(_pattern_figure(source, pattern, outcomes, folder))
    measures = Measures.from_values(values)
    return Study(source, angle_tolerance, vertices, faces, measures, maps, outcomes, figures, pattern, cut)


def _try(
    meshes: Any,
    source: Input,
    method: Method,
    angle_tolerance: float,
    folder: Path,
    kinds: Sequence[MapKind],
) -> Outcome:
    meshes.set_current_mesh(0)
    meshes.apply_filter("generate_copy_of_current_mesh")
    values = meshes.apply_filter(method.filter, angle_tolerance=angle_tolerance, **method.parameters)
    report = OptimizationReport.from_values(values, panel_reports(meshes.current_mesh()))
    file = folder / f"{source.name}_{method.name}.ply"
    maps = _maps(meshes, kinds, angle_tolerance)
    vertices = meshes.current_mesh().vertex_matrix()
    _apply_maps_filter(meshes, "Angle defect", angle_tolerance)
    _save(meshes, file)
    pattern = None
    if method.flatten and report.converged:
        pattern, flat = _flatten(meshes, folder / f"{source.name}_{method.name}_pattern.ply")
        pattern = dataclasses.replace(pattern, to_cut=_write_to_cut(flat, source, pattern.file))
        maps |= pattern.maps
    return Outcome(method, report, vertices, maps, file, pattern)


def _flatten(meshes: Any, file: Path) -> tuple[Pattern, FlatteningResult]:
    """Lay the current mesh flat; the pattern is the current layer afterwards."""
    surface = meshes.current_mesh()
    flat = flattened_layer(meshes, {"map": "Edge strain"})
    vertices = meshes.current_mesh().vertex_matrix()
    energy = np.array(surface.vertex_custom_scalar_attribute_array("elastic_energy"))
    _save(meshes, file)
    maps = {"Elastic energy": energy}
    return Pattern(flat.report, vertices, flat.faces, flat.quality, maps, file), flat


def _write_to_cut(flat: FlatteningResult, source: Input, file: Path) -> Sequence[Path]:
    """The pieces as files to print and cut, unless one of them can't be cut so."""
    unit = source.unit if source.unit in UNITS else "mm"
    options = PatternOptions(unit=unit)
    if source.cut:
        tolerance = options.millimetres * seam_tolerance(flat.vertices, flat.faces)
        options = dataclasses.replace(options, seam_tolerance=tolerance)
    try:
        return write_patterns(flat, file.parent, file.stem, options).files
    except PatternError:
        return ()


def _maps(meshes: Any, kinds: Sequence[MapKind], angle_tolerance: float) -> dict[str, Array]:
    maps = {}
    for kind in kinds:
        if kind.of_pattern:
            continue
        _apply_maps_filter(meshes, kind.title, angle_tolerance)
        maps[kind.title] = vertex_quality(meshes.current_mesh())
    return maps


def _apply_maps_filter(meshes: Any, title: str, angle_tolerance: float) -> dict[str, Any]:
    result: dict[str, Any] = meshes.apply_filter(
        "compute_scalar_by_developability_per_vertex",
        angle_tolerance=angle_tolerance,
        map=title,
        colorize=True,
    )
    return result


def _save(meshes: Any, file: Path) -> None:
    meshes.save_current_mesh(str(file))


def _figure(kind: MapKind, source: Input, pictures: Sequence[Picture], folder: Path) -> Figure:
    """Of one map; where the first picture is of the mesh before, its values say the scale."""
    compared = pictures[:1] if kind.before_too else pictures
    label = kind.label.format(unit=source.unit, square_unit=source.square_unit)
    scale = robust_scale(label, [picture.values for picture in compared], kind.signed)
    file = folder / f"{source.name}_{kind.title.lower().replace(' ', '_')}.png"
    render(file, pictures, scale, source.view)
    return Figure(file, kind.title, kind.caption)


def _panels_figure(source: Input, pictures: Sequence[Picture], folder: Path) -> Figure:
    file = folder / f"{source.name}_panels.png"
    render(file, pictures, None, source.view)
    caption = "A colour a panel: cut along seams and darts, and made developable with all seams closed."
    return Figure(file, "Panels", caption)


def _pattern_figure(source: Input, before: Pattern, outcomes: Sequence[Outcome], folder: Path) -> Figure:
    patterns = {"before": before} | {f"after: {o.method.title}": o.pattern for o in outcomes if o.pattern}
    pictures = [Picture(title, p.vertices, p.faces, 100 * p.edge_strain) for title, p in patterns.items()]
    scale = robust_scale("edge strain, %", [pictures[0].values], False)
    file = folder / f"{source.name}_pattern.png"
    render(file, pictures, scale, EYE_ABOVE)
    strains = "; ".join(
        f"{title}: at most {100 * p.report.max_edge_strain:.2g} %, {100 * p.report.mean_edge_strain:.2g} % "
        "on average"
        for title, p in patterns.items()
    )
    caption = (
        "The surface laid flat, coloured by how much edges must change their length for that. " + strains
    )
    return Figure(file, "Flat pattern", f"{caption}.")
