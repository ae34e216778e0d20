# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel has the compiled plugin in it and is all that one needs: it is installed in an environment of its
own, with a newer Python where the machine has one, and the package's tests run there. The source distribution
has all that the wheel is made of."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
HOST = "pymeshlab-2025.7"
PLUGIN = f"meshlab_developable/plugins/{HOST}/libfilter_developable.so"


def run(*command: object, **options: object) -> str:
    """What a command prints; a failure shows all it said."""
    environment = {name: value for name, value in os.environ.items() if name != "DEVELOPABLE_PLUGIN"}
    ran = subprocess.run(
        list(map(str, command)), capture_output=True, text=True, check=False, env=environment, **options
    )
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return ran.stdout


def newest_python() -> Path:
    """The newest Python on the machine that can make environments, or the one that runs this."""
    names = [shutil.which(f"python3.{minor}") for minor in (14, 13, 12)]
    kept = sorted(Path.home().glob(".pyenv/versions/3.1[2-9].*/bin/python"), reverse=True)
    check = "import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 12))"
    for candidate in [*filter(None, names), *kept]:
        if subprocess.run([candidate, "-c", check], capture_output=True, check=False).returncode == 0:
            return Path(candidate)
    return Path(sys.executable)


def made_wheel(source: Path, folder: Path) -> Path:
    """The wheel of a folder or of a source distribution."""
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check"]
    # What an isolated build would fetch is there already: set-up has pinned it.
    run(*pip, "wheel", "--no-deps", "--no-build-isolation", "--wheel-dir", folder, source)
    (made,) = folder.iterdir()
    return made


@pytest.fixture(scope="module")
def wheel(tmp_path_factory) -> Path:
    return made_wheel(ROOT / "python", tmp_path_factory.mktemp("wheel"))


@pytest.fixture(scope="module")
def sdist(tmp_path_factory) -> Path:
    """What `python -m build --sdist` makes."""
    folder = tmp_path_factory.mktemp("sdist")
    run(sys.executable, "-m", "hatchling", "build", "-t", "sdist", "-d", folder, cwd=ROOT / "python")
    (made,) = folder.iterdir()
    return made


@pytest.fixture(scope="module")
def python(wheel, tmp_path_factory) -> Path:
    """The Python of a fresh environment that has the wheel, what it asks for, and pytest."""
    folder = tmp_path_factory.mktemp("fresh")
    run(newest_python(), "-m", "venv", folder)
    made = folder / "bin" / "python"
    run(made, "-m", "pip", "install", "--disable-pip-version-check", wheel, "pytest")
    return made


def test_the_wheel_has_the_plugin_and_serves_every_python(wheel):
    assert wheel.name.split("-")[2:4] == ["py3", "none"]
    assert not wheel.name.endswith("-any.whl")
    (major, minor) = map(int, re.search(r"-manylinux_(\d+)_(\d+)_x86_64\.whl$", wheel.name).groups())
    file = ROOT / "build" / HOST / "libfilter_developable.so"
    symbols = re.findall(r"GLIBC_(\d+)\.(\d+)", run("objdump", "-T", file))
    assert max((int(a), int(b)) for a, b in symbols) <= (major, minor)
    plugin = file.read_bytes()
    with zipfile.ZipFile(wheel) as archive:
        assert archive.read(PLUGIN) == plugin
        names = archive.namelist()
        (metadata,) = (name for name in names if name.endswith("METADATA"))
        assert b"Requires-Dist: pymeshlab==2025.7.*" in archive.read(metadata)
    package = ROOT / "python" / "meshlab_developable"
    sources = {f"{file.relative_to(package.parent)}" for file in package.rglob("*.py")}
    assert sources <= set(names)
    assert {"meshlab_developable/py.typed", "meshlab_developable/LICENSE"} <= set(names)


def test_making_a_wheel_installs_no_packages_of_the_system_but_names_them(tmp_path):
    """With a dpkg-query that knows of no package, and an apt-get that must not be called."""
    for name, content in (("dpkg-query", "exit 0"), ("apt-get", f"touch {tmp_path}/called")):
        (tmp_path / name).write_text(f"#!/bin/sh\n{content}\n")
        (tmp_path / name).chmod(0o755)
    environment = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}", "DEVELOPABLE_INSTALL": "never"}
    command = ["bash", ROOT / "scripts" / "setup.sh", "wheel"]
    ran = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
    assert ran.returncode != 0
    assert re.search(r"these packages of the system are missing.*\bcmake\b.*install them first", ran.stderr)
    assert not (tmp_path / "called").exists()


def test_the_plugin_that_is_loaded_is_the_wheels(python, tmp_path):
    script = "from meshlab_developable import load, plugin; load()\n"
    script += "print(plugin.find_plugin(plugin.pymeshlab_version(), plugin.plugin_folders()))"
    found = Path(run(python, "-c", script, cwd=tmp_path).strip())
    assert found.is_relative_to(python.parents[1])


def test_the_command_gives_the_checkouts_result_to_the_last_bit(python, tmp_path):
    mesh = ROOT / "meshes" / "shoe_upper.ply"
    for command, name in ((python.with_name("developable"), "fresh.ply"), ("developable", "checkout.ply")):
        path = command if isinstance(command, Path) else Path(sys.executable).with_name(command)
        run(path, "global", mesh, "-o", tmp_path / name, cwd=tmp_path)
    assert (tmp_path / "fresh.ply").read_bytes() == (tmp_path / "checkout.ply").read_bytes()


def test_the_packages_own_tests_pass_there(python):
    tests = [ROOT / "tests" / "python" / f"test_{name}.py" for name in ("package", "command_line")]
    said = run(python, "-m", "pytest", "-q", "-p", "no:cacheprovider", *tests, cwd=ROOT)
    assert " passed" in said
    assert "failed" not in said


def test_the_source_distribution_has_all_that_the_plugin_is_made_of(sdist, tmp_path):
    with tarfile.open(sdist) as archive:
        archive.extractall(tmp_path, filter="data")
    (unpacked,) = tmp_path.iterdir()
    for folder in ("cmake", "filter_developable", "scripts/lib", "vcg_ext"):
        for file in filter(Path.is_file, (ROOT / folder).rglob("*")):
            if file.parent.name != "__pycache__":
                assert (unpacked / file.relative_to(ROOT)).read_bytes() == file.read_bytes()
    library = run(sys.executable, "-c", "import pymeshlab; print(pymeshlab.__file__)").strip()
    library = Path(library).parent / "lib" / "libmeshlab-common.so"
    options = ["-DCMAKE_UNITY_BUILD=OFF", f"-DDEVELOPABLE_HOST_LIBRARY={library}"]  # each source a command
    run("cmake", "--preset", "wheel", *options, cwd=unpacked)
    commands = json.loads((unpacked / "build" / "wheel" / "compile_commands.json").read_text())
    compiled = [Path(command["file"]) for command in commands]
    assert unpacked / "filter_developable" / "filters" / "flatten_patches.cpp" in compiled
    assert all(file.is_relative_to(unpacked) for file in compiled)


@pytest.mark.slow
def test_a_wheel_can_be_made_of_the_source_distribution(sdist, tmp_path):
    with zipfile.ZipFile(made_wheel(sdist, tmp_path / "wheel")) as archive:
        plugin = archive.extract(PLUGIN, tmp_path)
    script = f"import pymeshlab as p; p.load_plugin({plugin!r}); print(*p.filter_list())"
    assert "generate_flat_patches" in run(sys.executable, "-c", script)
