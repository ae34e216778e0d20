# SPDX-License-Identifier: GPL-3.0-or-later
"""What the package knows of the filters is what the plugin says of them."""

from __future__ import annotations

import importlib.util
import inspect
from pathlib import Path

import meshlab_developable
import pytest
from meshlab_developable import filters
from meshlab_developable.description import Reason
from meshlab_developable.parameters import Choice

ROOT = Path(__file__).parents[2]
FUNCTIONS = [
    (meshlab_developable.measure, [filters.MAPS]),
    (meshlab_developable.make_developable, [filters.GLOBAL, filters.LOCAL]),
    (meshlab_developable.flatten, [filters.FLATTEN]),
]
# What these functions take in another form than the filters.
AS_ARRAYS = {"only_selected", "fix_selected", "reference"}


@pytest.fixture(scope="module")
def generator():
    spec = importlib.util.spec_from_file_location("generate_filters", ROOT / "python/generate_filters.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_generated_files_are_what_the_built_plugin_says(generator):
    for path, text in generator.generated().items():
        assert path.read_text("utf-8") == text, f"{path.name} is not current: run {generator.COMMAND}"


@pytest.mark.parametrize(("function", "known"), FUNCTIONS)
def test_signatures_show_every_parameter_with_its_default(function, known):
    shown = inspect.signature(function).parameters
    assert not any(parameter.kind is parameter.VAR_KEYWORD for parameter in shown.values())
    for parameter in (parameter for each in known for parameter in each.parameters):
        if parameter.name not in AS_ARRAYS:
            assert shown[parameter.name].kind is inspect.Parameter.KEYWORD_ONLY
            assert shown[parameter.name].default == parameter.default
            assert type(shown[parameter.name].default) is type(parameter.default)
            if isinstance(parameter.kind, Choice):
                assert all(repr(text) in shown[parameter.name].annotation for text in parameter.kind.texts)


@pytest.mark.parametrize(("function", "known"), FUNCTIONS)
def test_help_says_what_each_parameter_is_and_its_unit(function, known):
    words = " ".join(inspect.getdoc(function).split())
    for parameter in (parameter for each in known for parameter in each.parameters):
        if parameter.name not in AS_ARRAYS:
            assert parameter.help in words
            assert f"{parameter.name} ({parameter.unit}" in words or not parameter.unit


def test_help_tells_the_methods_apart():
    words = inspect.getdoc(meshlab_developable.make_developable)
    assert "max_operations (only for 'local'): " in words
    assert "For 'local': How far a vertex may move" in " ".join(words.split())
    assert "fix_boundary (only for 'global'): " in words
    assert "angle_tolerance (rad): " in words


@pytest.mark.parametrize("known", filters.FILTERS, ids=lambda known: known.name)
def test_help_of_a_parameter_is_one_short_sentence(known):
    for parameter in known.parameters:
        assert parameter.help.endswith(".")
        assert len(parameter.help) <= 130
        assert not any(words in parameter.help for words in ("Fig.", "Eq.", "Section"))


def test_reasons_have_the_numbers_of_the_interface():
    assert {reason.name: int(reason) for reason in Reason} == {
        "AS_STATUS": 0,
        "NOT_LOWERED": 1,
        "NOTHING_MOVES": 2,
        "NEEDS_CUT": 3,
        "UNSOLVABLE": 4,
        "TOO_FAR": 5,
        "NEARLY_THERE": 6,
        "BEYOND_BOUNDS": 7,
        "WITHIN_BOUNDS": 8,
        "BORDER_OVERLAPS": 9,
        "SEAM_TOO_FAR": 10,
        "SEAM_OVERLAPS": 11,
        "SEAM_NO_SHEET": 12,
        "SEAM_BEYOND_BOUNDS": 13,
        "SEAM_SEWN": 14,
        "SEAM_STILL": 15,
        "SEAM_CRUMPLES": 16,
    }
