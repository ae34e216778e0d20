# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of a batch as `results.parquet` and `results.csv`."""

from __future__ import annotations

import dataclasses
import json
import typing
from collections.abc import Sequence
from pathlib import Path

import pyarrow
import pyarrow.compute
import pyarrow.csv
import pyarrow.parquet

from meshlab_developable.batch.records import Row
from meshlab_developable.methods import METHODS
from meshlab_developable.writing import written_whole

_TYPES = {bool: pyarrow.bool_(), float: pyarrow.float64()}  # others are whole numbers, as filters return them

_IN_OTHER_COLUMNS = ("panels", "warnings", "material_verdict")  # the message has these words


def write_tables(out: Path, rows: Sequence[Row], method: str, scratch: Path) -> None:
    """A row an input: `input`, `state`, `message`, then the method's numbers, empty where there are none, and
    `panels`, a list in JSON."""
    table = _table(rows, method)
    with written_whole(out / "results.parquet", scratch) as path:
        pyarrow.parquet.write_table(table, path)
    with written_whole(out / "results.csv", scratch) as path:
        pyarrow.csv.write_csv(_without_formulas(table), path)


def _without_formulas(table: pyarrow.Table) -> pyarrow.Table:
    """Texts that a spreadsheet would take for a formula with an apostrophe before them; a name may be one."""
    for index, field in enumerate(table.schema):
        if pyarrow.types.is_string(field.type):
            texts = pyarrow.compute.replace_substring_regex(
                table.column(index), pattern=r"\A([=+\-@\t\r])", replacement=r"'\1"
            )
            table = table.set_column(index, field, texts)
    return table


def _table(rows: Sequence[Row], method: str) -> pyarrow.Table:
    report = METHODS[method][1]
    types = typing.get_type_hints(report)
    names = [field.name for field in dataclasses.fields(report) if field.name not in _IN_OTHER_COLUMNS]
    schema = pyarrow.schema(
        [(name, pyarrow.string()) for name in ("input", "state", "message")]
        + [(name, _TYPES.get(types[name], pyarrow.int64())) for name in names]
        + [("panels", pyarrow.string())]
    )
    content = [
        {
            "input": row.input,
            "state": str(row.state),
            "message": row.message,
            **row.numbers,
            "panels": json.dumps(row.panels) if row.panels else "",
        }
        for row in rows
    ]
    return pyarrow.Table.from_pylist(content, schema=schema)
