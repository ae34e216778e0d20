# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes laid out on sheets."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from meshlab_developable.errors import PatternError
from meshlab_developable.patterns.drawing import Motion
from meshlab_developable.patterns.packing import pack

SIZE, GAP = (1000.0, 700.0), 6.0


def triangles(count: int) -> dict[str, shapely.Polygon]:
    random = np.random.default_rng(4)
    corners = [[(0, 0), (random.uniform(200, 500), 0), (0, random.uniform(200, 600))] for _ in range(count)]
    return {f"triangle {number}": shapely.Polygon(ring) for number, ring in enumerate(corners)}


def placed(shapes, sheet):
    return {name: shapely.transform(shapes[name], motion) for name, motion in sheet.motions.items()}


def test_every_shape_is_on_one_sheet_apart_from_the_others():
    shapes = triangles(8)
    sheets = pack(shapes, SIZE, GAP, "half", upright=["triangle 3"])
    assert sorted(name for sheet in sheets for name in sheet.motions) == sorted(shapes)
    for sheet in sheets:
        there = list(placed(shapes, sheet).values())
        for index, shape in enumerate(there):
            assert shapely.box(0, 0, *SIZE).buffer(0.01).contains(shape)
            assert all(shape.distance(other) >= GAP for other in there[:index])
        assert all(motion.angle % 180 == 0 for motion in sheet.motions.values())
    (upright,) = (sheet.motions["triangle 3"] for sheet in sheets if "triangle 3" in sheet.motions)
    assert upright.angle == 0
    area = sum(shape.area for shape in shapes.values())
    assert len(sheets) <= np.ceil(area / (0.5 * SIZE[0] * SIZE[1]))


@pytest.mark.parametrize("size", [None, (900.0, 700.0)])
@pytest.mark.parametrize("count", [1, 2, 3])
def test_more_of_what_is_on_a_sheet_stands_upright_than_not(size, count):
    shapes = {f"panel {i}": shapely.box(0, 0, 320 - 20 * i, 420 - 10 * i) for i in range(count)}
    shapes["square"] = shapely.box(0, 0, 100, 100)
    for sheet in pack(shapes, size, GAP, "half", upright=["square"]):
        pieces = {name: motion for name, motion in sheet.motions.items() if name != "square"}
        upright = sum(shapes[name].area for name, motion in pieces.items() if motion.angle == 0)
        assert upright >= sum(shapes[name].area for name in pieces) / 2
        there = list(placed(shapes, sheet).values())
        for index, shape in enumerate(there):
            assert shapely.box(0, 0, *sheet.size).buffer(0.01).contains(shape)
            assert all(shape.distance(other) >= GAP for other in there[:index])
        assert sheet.motions.get("square", Motion()).angle == 0


def test_one_sheet_as_large_as_needed():
    shapes = triangles(5)
    (sheet,) = pack(shapes, None, GAP, "none")
    assert {motion.angle for motion in sheet.motions.values()} == {0}
    there = placed(shapes, sheet)
    bounds = shapely.total_bounds(list(there.values()))
    margins = np.concatenate([bounds[:2], np.subtract(sheet.size, bounds[2:])])
    assert margins.min() >= GAP / 2
    assert margins.max() <= 2 * GAP  # at a sharp corner


def test_a_shape_that_fits_only_when_turned():
    shapes = {"bar": shapely.box(0, 0, 300, 80)}
    with pytest.raises(PatternError, match="bar is larger than a sheet of 100 x 400 mm"):
        pack(shapes, (100, 400), GAP, "half")
    (sheet,) = pack(shapes, (100, 400), GAP, "free")
    assert shapely.box(0, 0, 100, 400).contains(placed(shapes, sheet)["bar"])


def test_of_several_that_are_too_large_the_first_is_named():
    shapes = {"one": shapely.box(0, 0, 300, 80), "two": shapely.box(0, 0, 300, 90)}
    with pytest.raises(PatternError, match="one and 1 more are larger"):
        pack(shapes, (100, 400), GAP, "none")


def test_nothing_needs_no_sheet():
    assert pack({}, SIZE, GAP, "half") == []
