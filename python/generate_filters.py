# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what the package knows of the filters, as the built plugin describes them.

`.venv/bin/python python/generate_filters.py`, after a build of the plugin, writes description.py (filters
with their parameters, statuses, reasons), signatures.py (functions that take each parameter by its name) and
the table of materials in the package. What the plugin says is laid down in filter_developable/description.h.
"""

from __future__ import annotations

import ast
import ctypes
import json
import subprocess
import sys
import textwrap
from pathlib import Path
from typing import Any

import pymeshlab  # noqa: F401 - brings the libraries that the plugin needs

PACKAGE = Path(__file__).resolve().parent / "meshlab_developable"
PLUGIN = PACKAGE.parents[1] / "build" / "pymeshlab-2025.7" / "libfilter_developable.so"
MATERIALS = PACKAGE.parents[1] / "filter_developable" / "materials.json"
COMMAND = ".venv/bin/python python/generate_filters.py"
HEAD = f"""\
# SPDX-License-Identifier: GPL-3.0-or-later
# Generated from the built plugin by: {COMMAND}
"""
DESCRIPTION_HEAD = f"""{HEAD}
\"\"\"The filters of the plugin, the statuses and the reasons, as the plugin describes them.\"\"\"

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

"""
SIGNATURES_HEAD = f"""{HEAD}
\"\"\"The functions that take the parameters of filters, each parameter by its name.\"\"\"

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

"""
# Functions whose **parameters are those of filters, by module: the filters' short names.
FUNCTIONS = {
    "methods": {"measure": ("maps",), "make_developable": ("global", "local")},
    "cutting": {"cut_into_panels": ("cut",)},
    "flattening": {"flatten": ("flatten",)},
}
DOCSTRING_WIDTH = 104


def main() -> None:
    """Write the files."""
    for path, text in generated().items():
        path.write_text(text, encoding="utf-8")
        print(path)


def generated() -> dict[Path, str]:
    """What the files have to hold."""
    described = plugin_description()
    texts = {"description.py": description_text(described), "signatures.py": signatures_text(described)}
    files = {PACKAGE / name: formatted(text, name) for name, text in texts.items()}
    return files | {PACKAGE / "materials.json": MATERIALS.read_text(encoding="utf-8")}


def plugin_description() -> Any:
    """What the plugin says of itself."""
    if not PLUGIN.exists():
        raise FileNotFoundError(f"there is no {PLUGIN}; run: bash scripts/setup.sh {PLUGIN.parent.name}")
    library = ctypes.CDLL(str(PLUGIN))
    library.developable_description.restype = ctypes.c_char_p
    return json.loads(library.developable_description())


def formatted(text: str, name: str) -> str:
    """As ruff formats it."""
    ruff = [Path(sys.executable).with_name("ruff"), "format", "--stdin-filename", PACKAGE / name, "-"]
    return subprocess.run(ruff, input=text, capture_output=True, text=True, check=True).stdout


def description_text(described: Any) -> str:
    """The filters, statuses and reasons as Python objects."""
    text = DESCRIPTION_HEAD
    for known in described["filters"]:
        parameters = "".join(f"{parameter_text(parameter)}," for parameter in known["parameters"])
        names = ", ".join(repr(known[key]) for key in ("short_name", "name", "python_name"))
        text += f"{known['short_name'].upper()} = Filter({names}, ({parameters}),)\n\n"
    text += f"FILTERS = ({', '.join(known['short_name'].upper() for known in described['filters'])})\n\n\n"
    text += enumeration_text(
        "Status",
        "Why an optimisation ended; `text` says it in the words of the filters' log.",
        described["statuses"],
    )
    text += enumeration_text(
        "Reason",
        "What there is to say of a status beyond its own text; {names} stand for results of the filter.",
        described["reasons"],
    )
    return text + strain_left_text(described["strain_left"]) + warnings_text(described["warnings"])


def strain_left_text(text: str) -> str:
    """What follows a reason where the strain that is left is known."""
    comment = "# Follows a reason's text that lacks it, where {edge_strain_left} comes of curvature left."
    return f"\n\n{comment}\nSTRAIN_LEFT = {text!r}\n"


def warnings_text(warnings: Any) -> str:
    """What a result is warned of: its key, the limit, and the words."""
    rows = "".join(
        f"({known['key']!r}, {float(known['limit'])!r}, {known['text']!r}),\n" for known in warnings
    )
    comment = "# Of an optimisation, by a key of its results: above which value, and what to say."
    return f"\n\n{comment}\nWARNINGS = ({rows})\n"


def parameter_text(parameter: Any) -> str:
    """The parameter as a Python object."""
    name, default, unit = parameter["name"], default_of(parameter), parameter["unit"]
    return f"Parameter({name!r}, {kind_text(parameter)}, {default!r}, {unit!r}, {help_of(parameter)!r})"


def kind_text(parameter: Any) -> str:
    """What the parameter takes, as a Python object."""
    kinds = {"bool": "Boolean", "int": "Whole", "float": "Number", "length": "Length", "mesh": "Layer"}
    arguments: dict[str, Any] = {}
    if parameter["type"] == "enumeration":
        kind = {"material": "Material", "grain": "Grain"}.get(parameter["name"], "Choice")
        return f"{kind}({tuple(parameter['choices'])!r})"
    if parameter["type"] == "length":
        arguments = {"automatic": parameter["automatic"]}
    if parameter["type"] == "float":
        arguments = {"minimum": parameter["minimum"]} | {
            key: parameter[key] for key in ("minimum_excluded", "maximum", "positive_for_solver")
        }
    given = ", ".join(f"{name}={value!r}" for name, value in arguments.items() if value)
    return f"{kinds[parameter['type']]}({given})"


def enumeration_text(name: str, words: str, members: Any) -> str:
    """An enumeration whose members have a text."""
    texts = f"_{name.upper()}_TEXTS"
    numbers = "".join(f"    {member['name']} = {member['number']}\n" for member in members)
    pairs = "".join(f"{name}.{member['name']}: {member['text']!r}," for member in members)
    return f'''
class {name}(enum.IntEnum):
    """{words}"""

{numbers}
    @property
    def text(self) -> str:
        """In words."""
        return {texts}[self]


{texts} = {{{pairs}}}

'''


def signatures_text(described: Any) -> str:
    """The functions of the package that take a filter's parameters, with each parameter by its name."""
    text = SIGNATURES_HEAD
    by_name = {known["short_name"]: known for known in described["filters"]}
    for module, functions in FUNCTIONS.items():
        written = ast.parse((PACKAGE / f"{module}.py").read_text("utf-8")).body
        for function in written:
            if isinstance(function, ast.FunctionDef) and function.name in functions:
                filters = [by_name[name] for name in functions[function.name]]
                text += f"\n@implemented_by({module}.{function.name})\n{declaration(function, filters)}\n\n"
    return text


def declaration(function: ast.FunctionDef, filters: list[Any]) -> str:
    """The function as it is written, but with the filters' parameters in place of its last, and no body."""
    signature = function.args
    taken = {argument.arg for argument in signature.args + signature.kwonlyargs}
    words = [ast.get_docstring(function) or "", "", f"Parameters of the filter{'s' * (len(filters) > 1)}:"]
    for name, parameter in parameters_of(filters).items():
        if name not in taken:
            signature.kwonlyargs.append(ast.arg(name, ast.Name(annotation_of(parameter))))
            signature.kw_defaults.append(ast.Constant(default_of(parameter)))
            words.append(words_of(parameter))
    signature.kwarg = None
    assert function.returns is not None
    head = f"def {function.name}({ast.unparse(signature)}) -> {ast.unparse(function.returns)}:"
    docstring = textwrap.indent('"""' + "\n".join(words) + '\n"""', "    ")
    return f"{head}\n{docstring}\n    raise NotImplementedError"


def parameters_of(filters: list[Any]) -> dict[str, Any]:
    """The filters' parameters by name, each with a key `only`: the filter that has it, when not all have; and
    a key `others`: filters that say something else of it, with what they say."""
    found: dict[str, Any] = {}
    for known in filters:
        for parameter in known["parameters"]:
            name = parameter["name"]
            users = [known for known in filters if name in (other["name"] for other in known["parameters"])]
            only = known["short_name"] if len(users) < len(filters) else ""
            first = found.setdefault(name, parameter | {"only": only, "others": []})
            if help_of(parameter) != help_of(first):
                first["others"].append((known["short_name"], help_of(parameter)))
    return found


def words_of(parameter: Any) -> str:
    """What a docstring says of a parameter."""
    notes = [
        parameter["unit"],
        f"> {parameter['minimum']:g}" if parameter["minimum_excluded"] else "",
        f"≤ {parameter['maximum']:g}" if parameter["maximum"] is not None else "",
        f"only for {parameter['only']!r}" if parameter["only"] else "",
    ]
    noted = "; ".join(filter(None, notes))
    line = f"{parameter['name']}{f' ({noted})' if noted else ''}: {help_of(parameter)}"
    line += "".join(f" For {name!r}: {words}" for name, words in parameter["others"])
    return textwrap.fill(line, DOCSTRING_WIDTH, initial_indent="    ", subsequent_indent="        ")


def annotation_of(parameter: Any) -> str:
    """The type of the parameter, as Python writes it."""
    if parameter["type"] == "enumeration":
        own = {"material": " | str | Mapping[str, Any]", "grain": " | Sequence[float]"}
        return f"Literal[{', '.join(map(repr, parameter['choices']))}]{own.get(parameter['name'], '')}"
    return {"bool": "bool", "int": "int", "float": "float", "length": "float | str", "mesh": "int"}[
        parameter["type"]
    ]


def default_of(parameter: Any) -> Any:
    """The default, in the parameter's type."""
    return float(parameter["default"]) if parameter["type"] in ("float", "length") else parameter["default"]


def help_of(parameter: Any) -> str:
    """The first sentence of the tooltip."""
    sentence: str = parameter["tooltip"].split(". ")[0]
    return sentence.rstrip(".") + "."


if __name__ == "__main__":
    main()
