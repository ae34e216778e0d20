# SPDX-License-Identifier: GPL-3.0-or-later
"""Units for clang-tidy: several sources of a folder in one, as most of its time goes to shared headers.

`lint_units.py FOLDER BUILD:SIZE...` reads the compile commands of builds, and writes units of up to so many
sources each and their commands into `FOLDER/BUILD`. A source is in one unit, of the first build that has it;
what a build generated is in none. Prints one unit's file name a line.
"""

import json
import re
import sys
from itertools import groupby
from pathlib import Path

PRECOMPILED = re.compile(r" -Winvalid-pch -include \S+/cmake_pch\.hxx")  # GCC's: clang can't read them
ALONE = {"filters"}  # folders whose sources have helpers of the same names


def main() -> None:
    """Write the units."""
    folder = Path(sys.argv[1])
    seen: set[Path] = set()
    for argument in sys.argv[2:]:
        build, size = argument.rsplit(":", 1)
        units = write_units(Path(build), folder / Path(build).name, int(size), seen)
        print("\n".join(map(str, units)))


def write_units(build: Path, folder: Path, size: int, seen: set[Path]) -> list[Path]:
    """Units of the sources of a build that are not among those seen, which they become."""
    folder.mkdir(parents=True, exist_ok=True)
    commands = {
        Path(entry["file"]): PRECOMPILED.sub("", entry["command"])
        for entry in json.loads((build / "compile_commands.json").read_text())
    }
    sources = sorted(source for source in commands if not source.is_relative_to(build) and source not in seen)
    seen.update(sources)
    entries = {}
    for parent, group in groupby(sources, key=lambda source: source.parent):
        members = list(group)
        step = 1 if parent.name in ALONE else size
        for first in range(0, len(members), step):
            unit = folder / f"{'_'.join(parent.parts[-2:])}_{first // step}.cpp"
            unit.write_text("".join(f'#include "{source}"\n' for source in members[first : first + step]))
            entries[unit] = commands[members[first]].replace(str(members[first]), str(unit))
    (folder / "compile_commands.json").write_text(
        json.dumps(
            [{"directory": str(folder), "command": entries[unit], "file": str(unit)} for unit in entries]
        )
    )
    return list(entries)


if __name__ == "__main__":
    main()
