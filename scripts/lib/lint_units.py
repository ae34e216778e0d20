# SPDX-License-Identifier: GPL-3.0-or-later
"""Units for clang-tidy: all sources of a folder in one, as most of its time goes to shared headers.

`lint_units.py FOLDER BUILD...` reads the compile commands of builds, and writes units and their commands
into `FOLDER/BUILD`. Of a build that is written as `BUILD:alone` every source is a unit. A source is in one
unit, of the first build that has it; what a build generated is in none. Prints one unit's file name a line,
the largest first.
"""

import json
import re
import sys
from itertools import groupby
from pathlib import Path

COMPILED = "<compiled>"
INCLUDED = re.compile(r'^#include "(.*)"$', re.MULTILINE)
PRECOMPILED = re.compile(r" -Winvalid-pch -include \S+/cmake_pch\.hxx")  # GCC's: clang can't read them


def main() -> None:
    """Write the units."""
    folder = Path(sys.argv[1])
    seen: set[Path] = set()
    units: dict[Path, int] = {}
    for argument in sys.argv[2:]:
        build, _, alone = argument.partition(":")
        units.update(write_units(Path(build), folder / Path(build).name, bool(alone), seen))
    print("\n".join(map(str, sorted(units, key=lambda unit: (-units[unit], unit)))))


def commands_of(build: Path) -> dict[Path, str]:
    """The command for each source, COMPILED standing for what is compiled."""
    commands: dict[Path, str] = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        compiled = Path(entry["file"])
        sources = [compiled]
        if compiled.parent.name == "Unity":
            sources = [Path(source) for source in INCLUDED.findall(compiled.read_text())]
        command = PRECOMPILED.sub("", entry["command"]).replace(str(compiled), COMPILED)
        commands.update(dict.fromkeys(sources, command))
    return commands


def write_units(build: Path, folder: Path, alone: bool, seen: set[Path]) -> dict[Path, int]:
    """Units of the sources of a build that are not among those seen, which they become, in bytes."""
    folder.mkdir(parents=True, exist_ok=True)
    commands = commands_of(build)
    sources = sorted(source for source in commands if not source.is_relative_to(build) and source not in seen)
    seen.update(sources)
    units: dict[Path, int] = {}
    entries: list[dict[str, str]] = []
    for parent, group in groupby(sources, key=lambda source: source.parent):
        members = list(group)
        for number, part in enumerate([[source] for source in members] if alone else [members]):
            unit = folder / f"{'_'.join(parent.parts[-2:])}_{number}.cpp"
            unit.write_text("".join(f'#include "{source}"\n' for source in part))
            command = commands[part[0]].replace(COMPILED, str(unit))
            entries.append({"directory": str(folder), "command": command, "file": str(unit)})
            units[unit] = sum(source.stat().st_size for source in part)
    (folder / "compile_commands.json").write_text(json.dumps(entries))
    return units


if __name__ == "__main__":
    main()
