# SPDX-License-Identifier: GPL-3.0-or-later
"""How users build the plugin: inside MeshLab's own source tree, and against one of theirs."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CACHE = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "developable"
MESHLAB = CACHE / "meshlab-2025.07"


def configure(source, build, *options):
    """Configures a build folder and returns what CMake printed; CMake's failure is the caller's to judge."""
    command = ["cmake", "-G", "Ninja", "-S", source, "-B", build, *options]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def ninja(build, *arguments):
    result = subprocess.run(["ninja", "-C", build, *arguments], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout[-4000:]
    return result.stdout


@pytest.fixture
def meshlab_tree(tmp_path):
    """MeshLab 2025.07's source tree, as links to the one that set-up keeps, without plugins."""
    tree = tmp_path / "meshlab"
    (tree / "src" / "meshlabplugins").mkdir(parents=True)
    for name in ("CMakeLists.txt", "ML_VERSION"):
        (tree / name).symlink_to(MESHLAB / name)
    for path in (MESHLAB / "src").iterdir():
        (tree / "src" / path.name).symlink_to(path)
    return tree


def configure_meshlab(tree, build, *options):
    return configure(
        tree,
        build,
        "-DMESHLAB_BUILD_MINI=ON",  # without what MeshLab would download
        "-DMESHLAB_BUILD_ONLY_LIBRARIES=ON",
        "-DMESHLAB_PLUGINS=meshlabplugins/filter_developable",
        *options,
    )


def compiled_sources(build):
    """The plugin's sources that a configured build compiles, relative to the plugin's folder."""
    inputs = ninja(build, "-t", "inputs", "filter_developable").splitlines()
    paths = [path.split("/filter_developable/")[-1] for path in inputs if "/filter_developable/" in path]
    return {
        path
        for path in paths
        if (ROOT / "filter_developable" / path).suffix == ".cpp" and "autogen" not in path
    }


def own_sources(adapter):
    folder = ROOT / "filter_developable"
    patterns = ("*.cpp", "filters/*.cpp", f"hosts/{adapter}/*.cpp")
    made = {"materials_text.cpp"}  # of materials.json
    return made | {str(path.relative_to(folder)) for pattern in patterns for path in folder.glob(pattern)}


def test_a_link_to_the_plugin_in_meshlabs_tree_configures(meshlab_tree, tmp_path):
    (meshlab_tree / "src/meshlabplugins/filter_developable").symlink_to(ROOT / "filter_developable")
    result = configure_meshlab(meshlab_tree, tmp_path / "build")
    assert result.returncode == 0, result.stderr
    assert compiled_sources(tmp_path / "build") == own_sources("meshlab_2022")


def test_copies_of_plugin_and_method_in_meshlabs_tree_configure(meshlab_tree, tmp_path):
    for name in ("filter_developable", "vcg_ext"):
        shutil.copytree(ROOT / name, meshlab_tree / "src/meshlabplugins" / name)
    result = configure_meshlab(meshlab_tree, tmp_path / "build")
    assert result.returncode == 0, result.stderr


def test_the_plugin_in_meshlabs_tree_without_the_method_says_what_it_needs(meshlab_tree, tmp_path):
    shutil.copytree(ROOT / "filter_developable", meshlab_tree / "src/meshlabplugins/filter_developable")
    result = configure_meshlab(meshlab_tree, tmp_path / "build")
    assert result.returncode != 0
    assert "DEVELOPABLE_VCG_EXT_DIR" in result.stderr
    given = configure_meshlab(
        meshlab_tree, tmp_path / "build", f"-DDEVELOPABLE_VCG_EXT_DIR={ROOT / 'vcg_ext'}"
    )
    assert given.returncode == 0, given.stderr


@pytest.mark.parametrize(
    ("release", "options", "defines", "adapter"),
    [
        ("2020.09", [], {"MESHLAB_VERSION=2020.09", "MESHLAB_SCALAR=float"}, "meshlab_2020"),
        ("2022.02", [], {"MESHLAB_VERSION=2022.02", "MESHLAB_SCALAR=float"}, "meshlab_2022"),
        (
            "2025.07",
            ["-DMESHLAB_BUILD_WITH_DOUBLE_SCALAR=ON"],
            {"MESHLAB_VERSION=2025.07d", "MESHLAB_SCALAR=double"},
            "meshlab_2022",
        ),
    ],
)
def test_a_source_tree_of_the_users_decides_version_precision_and_adapter(
    tmp_path, release, options, defines, adapter
):
    result = configure(ROOT, tmp_path, f"-DMESHLAB_SOURCE_DIR={CACHE / f'meshlab-{release}'}", *options)
    assert result.returncode == 0, result.stderr
    commands = (tmp_path / "compile_commands.json").read_text()
    assert all(f"-D{define} " in commands for define in defines)
    assert compiled_sources(tmp_path) == own_sources(adapter)


def test_an_unknown_host_is_refused_with_the_known_ones(tmp_path):
    result = configure(ROOT, tmp_path, "-DDEVELOPABLE_HOST=meshlab-1999.01")
    assert result.returncode != 0
    assert "meshlab-1999.01" in result.stderr
    assert "pymeshlab-2025.7" in result.stderr


@pytest.mark.slow
def test_a_meshlab_of_single_precision_loads_both_its_own_build_of_the_plugin_and_ours(
    meshlab_tree, tmp_path
):
    plugins = meshlab_tree / "src/meshlabplugins"
    (plugins / "filter_developable").symlink_to(ROOT / "filter_developable")
    (plugins / "list_filters").symlink_to(ROOT / "tests/build_system/list_filters")
    build = tmp_path / "build"
    result = configure_meshlab(
        meshlab_tree,
        build,
        "-DMESHLAB_PLUGINS=meshlabplugins/filter_developable;meshlabplugins/list_filters",
    )
    assert result.returncode == 0, result.stderr
    ninja(build, "filter_developable", "list_filters")

    def filters(plugin):
        environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
        command = [build / "src/distrib/list_filters", plugin]
        return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)

    [dropped_in] = build.glob("**/plugins/libfilter_developable.so")
    for plugin in (dropped_in, ROOT / "build/meshlab-2025.07/libfilter_developable.so"):
        listed = filters(plugin)
        assert listed.returncode == 0, listed.stderr
        assert "apply_coord_global_developability" in listed.stdout.split()
    double = filters(ROOT / "build/pymeshlab-2025.7/libfilter_developable.so")
    assert double.returncode != 0
    assert "precision" in double.stderr
