# SPDX-License-Identifier: GPL-3.0-or-later
"""Which meshes a batch works on, and where the results of each go."""

from __future__ import annotations

import collections
import dataclasses
import hashlib
from collections.abc import Iterable
from pathlib import Path, PurePosixPath

from meshlab_developable.errors import InvalidMeshError
from meshlab_developable.names import printable

SUFFIXES = frozenset(
    {
        ".3ds",
        ".3mf",
        ".ctm",
        ".dae",
        ".glb",
        ".gltf",
        ".obj",
        ".off",
        ".ply",
        ".stl",
        ".vtk",
        ".vtu",
        ".wrl",
        ".x3d",
    }
)  # of surfaces, as pymeshlab, meshio or trimesh read them

LONGEST_STEM = 200  # bytes; names of files have 255 at most


@dataclasses.dataclass(frozen=True)
class Input:
    """A mesh to work on."""

    name: str  # as the table has it: relative to the folder, or as it stands in the list
    path: Path
    stem: str  # of its results, with folders, without a suffix


def find_inputs(source: Path, out: Path) -> list[Input]:
    """Every mesh in a folder and the folders in it, except those in `out`; or those of a list, a text file
    with a path a line, relative to the list's folder. In the order of their names, or of the list.

    Raises InvalidMeshError when there is none.
    """
    paths = _listed(source) if source.is_file() else _found(source, out.resolve())
    if not paths:
        raise InvalidMeshError(f"there is no mesh in {source}; meshes end in {', '.join(sorted(SUFFIXES))}")
    stems = _stems(paths)
    return [Input(name, path, stem) for (name, path), stem in zip(paths.items(), stems, strict=True)]


def _found(folder: Path, out: Path) -> dict[str, Path]:
    found = {}
    for path in sorted(folder.rglob("*")):
        if path.suffix.lower() in SUFFIXES and path.is_file() and not path.resolve().is_relative_to(out):
            found[printable(path.relative_to(folder).as_posix())] = path.absolute()
    return found


def _listed(path: Path) -> dict[str, Path]:
    if path.suffix.lower() in SUFFIXES:
        raise InvalidMeshError(f"{path} is a mesh, where a folder or a list of meshes is wanted")
    try:
        lines = path.read_text("utf-8", "surrogateescape").splitlines()
    except OSError as error:
        raise InvalidMeshError(f"{path} cannot be read: {error.strerror}") from None
    if any("\0" in line for line in lines):
        raise InvalidMeshError(f"{path} is neither a folder nor a text file that lists meshes")
    names = [line.strip() for line in lines if line.strip() and not line.lstrip().startswith("#")]
    return {printable(name): (path.parent / name).absolute() for name in names}


def _stems(names: Iterable[str]) -> list[str]:
    """Names of results: short where that tells all apart, else with the suffix, else with a number too."""
    names = list(names)
    clean = [_inside(name) for name in names]
    short = [str(PurePosixPath(name).with_suffix("")) for name in clean]
    uses = collections.Counter(stem.lower() for stem in short)
    stems = [name if uses[stem.lower()] > 1 else stem for name, stem in zip(clean, short, strict=True)]
    seen: set[str] = set()
    result = []
    for stem in stems:
        unique, number = stem, 2
        while unique.lower() in seen:
            unique, number = f"{stem}-{number}", number + 1
        seen.add(unique.lower())
        result.append(unique)
    return result


def _inside(name: str) -> str:
    """The name as a path that stays below the folder it is put in, with room for another suffix."""
    path = PurePosixPath(Path(name).as_posix())
    if path.is_absolute() or ".." in path.parts:
        path = PurePosixPath(path.name)
    return str(path.parent.joinpath(_shortened(path.stem) + path.suffix))


def _shortened(name: str) -> str:
    """The name, cut where it is long, and then with what tells it from others that begin the same."""
    encoded = name.encode()
    if len(encoded) <= LONGEST_STEM:
        return name
    return f"{encoded[: LONGEST_STEM - 9].decode(errors='ignore')}-{hashlib.sha256(encoded).hexdigest()[:8]}"
