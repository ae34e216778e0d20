# SPDX-License-Identifier: GPL-3.0-or-later
"""The process that does the work: a job a line comes in, a row a line goes out.

`python -m meshlab_developable.batch.child PARENT MEMORY_LIMIT`, the limit in MB above what it takes itself.
"""

from __future__ import annotations

import dataclasses
import json
import os
import resource
import sys
import warnings
from pathlib import Path
from typing import Any

from meshlab_developable import materials, mesh_sets, plugin
from meshlab_developable.batch.records import State
from meshlab_developable.batch.thumbnails import write_thumbnail
from meshlab_developable.departure import departure_of
from meshlab_developable.errors import DevelopableError, LostFacesWarning
from meshlab_developable.file_methods import save_whole
from meshlab_developable.material_verdict import judged
from meshlab_developable.methods import METHODS
from meshlab_developable.panels import panel_reports
from meshlab_developable.parent import OUT_OF_MEMORY, die_with
from meshlab_developable.writing import written_whole


def main() -> None:
    """Works until there is no more work, or no parent."""
    parent, limit = int(sys.argv[1]), float(sys.argv[2])
    die_with(parent)
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # what libraries print is no answer
    plugin.load()
    _limit_memory(limit)
    print("{}", file=answers, flush=True)  # ready
    for line in sys.stdin:
        try:
            answer = _work(json.loads(line))
        except MemoryError:
            os._exit(OUT_OF_MEMORY)
        print(json.dumps(answer), file=answers, flush=True)


def _work(request: dict[str, Any]) -> dict[str, Any]:
    """The row of a job, but for the input's name."""
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", LostFacesWarning)
            answer = _developed(request)
        lost = (str(warning.message) for warning in caught if warning.category is LostFacesWarning)
        return answer | {"message": "; ".join([answer["message"], *lost])}
    except DevelopableError as error:
        if any(words in str(error) for words in ("bad_alloc", "not enough memory")):
            raise MemoryError from error
        return {
            "state": State.BAD_INPUT,
            "message": " ".join(str(error).split()),
            "numbers": {},
            "panels": [],
        }


def _developed(request: dict[str, Any]) -> dict[str, Any]:
    applied, report_type = METHODS[request["method"]]
    meshes = mesh_sets.open_mesh(Path(request["source"]))
    scratch = Path(request["scratch"])
    if request["before"] is not None:
        with written_whole(Path(request["before"]), scratch) as path:
            write_thumbnail(path, meshes.current_mesh())
    numbers = mesh_sets.apply_filter(meshes, applied, request["parameters"])
    save_whole(meshes, Path(request["target"]), scratch)
    with written_whole(Path(request["thumbnail"]), scratch) as path:
        write_thumbnail(path, meshes.current_mesh())
    panels = panel_reports(meshes.current_mesh())
    report = report_type.from_values(numbers, panels).compared(departure_of(meshes.current_mesh()))
    report = judged(report, request["parameters"])
    state = State.DONE if report.developable else State.NOT_CONVERGED
    told = [dataclasses.asdict(panel) | {"status": panel.status.name.lower()} for panel in panels]
    said = (report.reason, report.material_verdict, *report.warnings, *_pattern_notes(request))
    message = "; ".join(filter(None, said))
    return {"state": state, "message": message, "numbers": numbers, "panels": told}


def _pattern_notes(request: dict[str, Any]) -> tuple[str, ...]:
    """Write the mesh's pattern, where that was asked for; what a user should know of it."""
    if request["patterns"] is None or request["pattern"] is None:
        return ()
    from meshlab_developable.patterns import make_patterns

    kept = ("patches", "weld_distance", "material", "allowed_stretch", "allowed_compression")
    parts = {key: value for key, value in request["parameters"].items() if key in kept}
    direction = materials.grain_direction(request["parameters"])
    if direction is not None:
        parts["grain"] = direction
    target, folder = Path(request["target"]), Path(request["pattern"])
    try:
        return make_patterns(target, folder=folder, name=folder.name, **parts | request["patterns"]).notes
    except DevelopableError as error:
        return (f"no pattern: {error}",)


def _limit_memory(limit: float) -> None:
    """Where the system counts a process's data, it may grow by so many MB."""
    status = Path("/proc/self/status")
    if not status.exists():
        return
    lines = dict(line.split(":", 1) for line in status.read_text().splitlines())
    now = int(lines["VmData"].split()[0]) * 1024
    resource.setrlimit(resource.RLIMIT_DATA, (now + int(limit * 2**20),) * 2)


if __name__ == "__main__":
    main()
