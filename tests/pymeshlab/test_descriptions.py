# SPDX-License-Identifier: GPL-3.0-or-later
"""Names, order, types and defaults of parameters: scripts rely on all of them."""

import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import mlx_scripts
import pymeshlab
import pytest
from mesh_sets import GLOBAL, LOCAL, MAPS, mesh_set
from shapes import bump

DOCS = Path(__file__).resolve().parents[2] / "docs"
SEVEN_MAPS = (
    "Gaussian map",
    "Angle defect",
    "Gaussian curvature",
    "Minimum curvature",
    "Maximum curvature",
    "Distance",
    "Displacement",
)
PATCHES = (
    "patches",
    "RichEnum",
    "0",
    ("Connected components", "Face colour", "Texture islands", "Face quality"),
)
WELD = ("weld_distance", "RichAbsPerc", "0", ())
ONLY_SELECTED = ("only_selected", "RichBool", "false", ())
FIX_BOUNDARY = ("fix_boundary", "RichBool", "false", ())
FIX_SELECTED = ("fix_selected", "RichBool", "false", ())
ANGLE_TOLERANCE = ("angle_tolerance", "RichFloat", "0.0001", ())
MAP = ("map", "RichEnum", "6", SEVEN_MAPS)
MATERIAL = (
    (
        "material",
        "RichEnum",
        "0",
        ("Custom", "Sheet steel", "Sheet aluminium", "Plywood", "Leather", "Woven cloth", "Knit", "Paper"),
    ),
    ("allowed_stretch", "RichFloat", "-1", ()),
    ("allowed_compression", "RichFloat", "-1", ()),
    ("grain", "RichEnum", "0", ("Longest seam", "X axis", "Y axis", "Z axis")),
)
COLORIZE = ("colorize", "RichBool", "true", ())

PARAMETERS = {
    "Global Developability": (
        ("solver", "RichEnum", "0", ("Constrained Newton", "Conjugate gradient")),
        PATCHES,
        WELD,
        ONLY_SELECTED,
        FIX_BOUNDARY,
        FIX_SELECTED,
        ANGLE_TOLERANCE,
        ("curvature_tolerance", "RichFloat", "0.0001", ()),
        ("max_iterations", "RichInt", "200", ()),
        ("relative_change", "RichFloat", "0.0001", ()),
        ("smoothness", "RichFloat", "3e-06", ()),
        ("fairness", "RichFloat", "0", ()),
        ("max_displacement", "RichAbsPerc", "-1", ()),
        *MATERIAL,
        ("thickness", "RichAbsPerc", "0", ()),
        MAP,
        COLORIZE,
    ),
    "Local Developability": (
        PATCHES,
        WELD,
        ONLY_SELECTED,
        FIX_SELECTED,
        ANGLE_TOLERANCE,
        ("max_displacement", "RichAbsPerc", "-1", ()),
        ("max_operations", "RichInt", "500000", ()),
        ("descent", "RichBool", "false", ()),
        ("smoothing", "RichFloat", "0", ()),
        ("assembling_vertices", "RichEnum", "0", ("Fixed", "Move together")),
        ("avoid_self_intersections", "RichBool", "false", ()),
        MAP,
        COLORIZE,
    ),
    "Developability Maps": (
        PATCHES,
        WELD,
        ANGLE_TOLERANCE,
        ("map", "RichEnum", "0", (*SEVEN_MAPS, "Elastic energy", "Bending radius")),
        ("reference", "RichMesh", "0", ()),
        COLORIZE,
    ),
}
FILTERS = {
    "Global Developability": (GLOBAL, mlx_scripts.GLOBAL),
    "Local Developability": (LOCAL, mlx_scripts.LOCAL),
    "Developability Maps": (MAPS, mlx_scripts.MAPS),
}


def described(element):
    """Name, type, value and choices of each parameter of a filter in a script."""
    return tuple(
        (
            parameter.get("name"),
            parameter.get("type"),
            parameter.get("value"),
            tuple(parameter.get(f"enum_val{i}") for i in range(int(parameter.get("enum_cardinality", 0)))),
        )
        for parameter in element
    )


@pytest.fixture(params=PARAMETERS)
def filter_name(request):
    return request.param


def test_filters_have_their_names_in_menus_and_in_python(filter_name):
    python_name, _ = FILTERS[filter_name]
    assert python_name in pymeshlab.filter_list()


def test_parameters_are_those_of_the_interface(filter_name, tmp_path):
    meshes = mesh_set(bump())
    meshes.apply_filter(FILTERS[filter_name][0])
    meshes.save_filter_script(str(tmp_path / "used.mlx"))
    used = ElementTree.parse(tmp_path / "used.mlx").getroot().find("filter")
    assert used.get("name") == filter_name
    assert described(used) == PARAMETERS[filter_name]
    assert all(parameter.get("description") and parameter.get("tooltip") for parameter in used)


PAGES = {
    GLOBAL: "global_developability",
    LOCAL: "local_developability",
    MAPS: "developability_maps",
    "generate_flat_patches": "flatten_patches",
    "meshing_cut_into_developable_panels": "cut_into_panels",
}
MATHEMATICS = re.compile(
    r"weld|tolerance|iteration|displacement|operation|relative|assembling|boundar|intersect|solver|patches|"
    r"angle defect|newton|gradient|normals|penalty|minimi|least squares",
    re.IGNORECASE,
)


def labels_of(name, folder):
    """What the dialog shows beside each parameter, but for its unit."""
    meshes = mesh_set(bump())
    meshes.apply_filter(name)
    meshes.save_filter_script(str(folder / "used.mlx"))
    used = ElementTree.parse(folder / "used.mlx").getroot().find("filter")
    return {parameter.get("name"): parameter.get("description").split(" (")[0] for parameter in used}


@pytest.mark.parametrize("name", PAGES)
def test_dialogs_speak_to_those_who_sew_and_build(name, tmp_path):
    labels = labels_of(name, tmp_path).values()
    assert len(set(labels)) == len(labels) > 4
    assert [label for label in labels if MATHEMATICS.search(label)] == []
    assert max(map(len, labels)) <= 30  # the dialog has to fit on a small screen


@pytest.mark.parametrize("name", PAGES)
def test_pages_say_which_parameter_a_label_is(name, tmp_path):
    page = " ".join((DOCS / f"{PAGES[name]}.md").read_text("utf-8").split())
    for parameter, label in labels_of(name, tmp_path).items():
        if label.lower().replace(" ", "_") != parameter:
            assert f"*{label}* is `{parameter}`" in page


def test_our_scripts_hold_the_defaults(filter_name):
    element = mlx_scripts.filter_element(FILTERS[filter_name][1])
    assert element.get("name") == filter_name
    assert described(element) == PARAMETERS[filter_name]


def test_colorize_is_off_on_a_mesh_that_has_colours(filter_name):
    meshes = mesh_set(bump())
    name = FILTERS[filter_name][0]
    assert meshes.filter_parameter_values(name)["colorize"] is True
    meshes.apply_filter(name, colorize=True)
    assert meshes.current_mesh().has_vertex_color()
    assert meshes.filter_parameter_values(name)["colorize"] is False
