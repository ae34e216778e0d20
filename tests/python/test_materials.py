# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of materials, and files of one's own in its form."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
from meshlab_developable import filters, materials, scripts
from meshlab_developable.errors import InvalidParameterError

OWN = {
    "materials": [
        {"name": "Our canvas", "stretch": 1.5, "compression": 0.5, "source": "measured in May"},
        {"name": "Felt", "stretch": 3, "compression": 0, "source": "measured in June"},
        {"name": "Twill", "stretch": {"warp": 1, "weft": 2, "bias": 3}, "compression": 0, "source": "a book"},
    ]
}


@pytest.fixture
def own_file(tmp_path):
    path = tmp_path / "ours.json"
    path.write_text(json.dumps(OWN), encoding="utf-8")
    return path


def test_every_material_of_the_dialog_is_in_the_table_with_a_source_and_bounds():
    table = materials.materials()
    assert tuple(table) == filters.GLOBAL.parameter("material").kind.texts
    assert filters.FLATTEN.parameter("material").kind.texts == tuple(table)
    for entry in table.values():
        assert len(entry["source"]) > 20
        assert entry["name"] == "Custom" or 0 < entry["smoothness"] <= 1
        for said in ("smoothness", "thickness", "elastic_strain"):
            assert said not in entry or _is_sourced(entry, said), f"{entry['name']}: {said}"
        for key in ("stretch", "compression"):
            bounds = entry[key]
            values = bounds.values() if isinstance(bounds, dict) else [bounds]
            assert all(0 <= value < 100 for value in values)
            assert not isinstance(bounds, dict) or set(bounds) == {"warp", "weft", "bias"}


def _is_sourced(entry, said):
    """Whether the source says something of that number, or has it."""
    words = {"elastic_strain": "strain|%", "thickness": "mm", "smoothness": "smoothness"}
    return re.search(words[said], entry["source"]) is not None


def test_an_own_material_is_the_entry_of_its_file(own_file):
    chosen = filters.GLOBAL.checked({"material": f"{own_file}#Twill", "allowed_compression": 2.0})
    assert chosen == {"material": OWN["materials"][2], "allowed_compression": 2.0}
    assert filters.GLOBAL.checked(chosen) == chosen


def test_a_file_with_one_material_needs_no_name(tmp_path):
    path = tmp_path / "one.json"
    path.write_text(json.dumps({"materials": OWN["materials"][:1]}), encoding="utf-8")
    assert filters.FLATTEN.checked({"material": str(path)})["material"] == OWN["materials"][0]


def test_a_script_holds_an_own_material_as_numbers(own_file):
    text = scripts.script_text(filters.GLOBAL, {"material": f"{own_file}#Felt", "allowed_compression": 0.5})
    assert 'enum_val0="Custom"' in text
    values = {found[1]: found[2] for found in re.finditer(r'name="(\w+)" type="\w+" value="([^"]*)"', text)}
    assert values["material"] == "0"
    assert (values["allowed_stretch"], values["allowed_compression"]) == ("3", "0.5")
    with pytest.raises(InvalidParameterError, match="a script can't hold the bounds of 'Twill'"):
        scripts.script_text(filters.GLOBAL, {"material": f"{own_file}#Twill"})


@pytest.mark.parametrize(
    ("name", "message"), [("Our canvass", "did you mean 'Our canvas'"), ("", "it has 'Our canvas'")]
)
def test_what_a_file_has_not_is_refused_with_what_it_has(own_file, name, message):
    with pytest.raises(InvalidParameterError, match=message):
        filters.GLOBAL.checked({"material": f"{own_file}#{name}"})


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("no json", "is no table of materials"),
        ('{"materials": [{"stretch": 1}]}', "is no table of materials"),
        ('{"materials": [{"name": "A", "stretch": 1, "compression": 0}]}', "says no 'source'"),
        (
            '{"materials": [{"name": "A", "stretch": -1, "compression": 0, "source": "x"}]}',
            "must be a number",
        ),
        (
            '{"materials": [{"name": "A", "stretch": "2", "compression": 0, "source": "x"}]}',
            "must be a number",
        ),
        ('{"materials": [{"name": "A", "compression": 0, "source": "x"}]}', "must be a number"),
        (
            '{"materials": [{"name": "A", "stretch": {"warp": 1}, "compression": 0, "source": "x"}]}',
            "must be one number, or have warp, weft, bias",
        ),
        (
            '{"materials": [{"name": "A", "stretch": 1, "compression": 101, "source": "x"}]}',
            "0 or more and at most 100",
        ),
        (
            '{"materials": [{"name": "A", "stretch": 1, "compresion": 1, "source": "x"}]}',
            "unknown 'compresion'; did you mean 'compression'",
        ),
        (
            '{"materials": [{"name": "A", "stretch": NaN, "compression": 1, "source": "x"}]}',
            "must be a number",
        ),
    ],
)
def test_a_bad_file_is_refused_with_a_sentence(tmp_path, content, message):
    path = tmp_path / "bad.json"
    path.write_text(content, encoding="utf-8")
    with pytest.raises(InvalidParameterError, match=message):
        filters.GLOBAL.checked({"material": str(path)})


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(InvalidParameterError, match=r"none\.json can't be read"):
        filters.GLOBAL.checked({"material": str(tmp_path / "none.json")})


def test_an_unknown_material_is_refused_with_the_nearest():
    with pytest.raises(InvalidParameterError, match="did you mean 'Leather'"):
        filters.GLOBAL.checked({"material": "lether"})


def test_patterns_may_be_strained_by_what_the_material_bears(own_file):
    """Of a model's edge of length 1: in the pattern 1 / 1.25 where it is stretched, 1 / 0.93 compressed."""
    strain = materials.greatest_edge_strain
    assert strain({}) == 0
    assert strain({"material": "Leather", "allowed_compression": 7.0}) == pytest.approx(100 * (1 / 0.93 - 1))
    assert strain({"material": f"{own_file}#Felt"}) == pytest.approx(100 * (1 - 1 / 1.03))
    assert strain({"allowed_stretch": 25.0, "allowed_compression": float("nan")}) == 0


@pytest.mark.parametrize("material", ["Woven cloth", "Knit", "Plywood", "own"])
def test_the_strain_of_patterns_of_directed_materials_is_the_most_that_maps_within_the_bounds_have(
    own_file, material
):
    chosen = f"{own_file}#Twill" if material == "own" else material
    entry = materials.resolved({"material": chosen})["material"]
    entry = entry if isinstance(entry, dict) else materials.materials()[entry]
    low, high = (
        np.array(
            [
                entry[key][name] if isinstance(entry[key], dict) else entry[key]
                for name in materials.DIRECTIONS
            ]
        )
        / 100
        for key in ("compression", "stretch")
    )
    low, high = (1 - low) ** 2, (1 + high) ** 2
    a, b, shear = np.meshgrid(
        np.linspace(low[0], high[0], 61),
        np.linspace(low[1], high[1], 61),
        np.linspace(-0.6, 0.6, 1201) * (high.max() - low.min()),
        indexing="ij",
    )
    middle, radius = (a + b) / 2, np.hypot((a - b) / 2, shear)
    within = (middle + np.abs(shear) <= high[2] + 1e-12) & (middle - np.abs(shear) >= low[2] - 1e-12)
    for limits, beyond in ((low, low[0] - (middle - radius)), (high, middle + radius - high[0])):
        if np.ptp(limits) == 0:  # bounds every direction
            within &= beyond <= 1e-12
    expected = max(
        ((middle - radius)[within] ** -0.5).max() - 1, 1 - ((middle + radius)[within] ** -0.5).min()
    )
    bound = materials.greatest_edge_strain({"material": chosen})
    assert 100 * expected <= bound + 1e-9
    assert bound == pytest.approx(100 * expected, rel=0.02) or bound == pytest.approx(
        100 * max(1 - high.max() ** -0.5, low.min() ** -0.5 - 1)  # which no map need have
    )


def test_a_grain_is_a_choice_or_a_direction_whose_axes_are_choices():
    checked = filters.GLOBAL.checked
    assert checked({"grain": (0.0, 0.5, 1)}) == {"grain": (0.0, 0.5, 1.0)}
    assert checked({"grain": np.array([0.0, -2.0, 0.0])}) == {"grain": "Y axis"}
    assert checked({"grain": 3}) == {"grain": "Z axis"}
    parsed = filters.FLATTEN.parsed
    assert parsed({"grain": "0,0.5,1"}) == {"grain": (0.0, 0.5, 1.0)}
    assert parsed({"grain": "0, 0, 3"}) == {"grain": "Z axis"}
    assert parsed({"grain": "longest seam"}) == {"grain": "Longest seam"}


@pytest.mark.parametrize(
    ("direction", "message"),
    [
        ((0, 0, 0), "not all of them 0"),
        ((1, 2), "three finite numbers"),
        ((1, 2, 3, 4), "three finite numbers"),
        ((1, float("nan"), 0), "three finite numbers"),
        (("x", 1, 0), "three numbers"),
        ("Longest side", "did you mean 'Longest seam'"),
    ],
)
def test_what_is_no_direction_is_refused(direction, message):
    with pytest.raises(InvalidParameterError, match=message):
        filters.CUT.checked({"grain": direction})


def test_a_script_refuses_a_direction_of_ones_own_and_holds_an_axis():
    with pytest.raises(InvalidParameterError, match="a script can't hold the grain"):
        scripts.script_text(filters.GLOBAL, {"grain": (1.0, 1.0, 0.0)})
    assert 'name="grain" type="RichEnum" value="2"' in scripts.script_text(
        filters.GLOBAL, {"grain": (0, 1, 0)}
    )
