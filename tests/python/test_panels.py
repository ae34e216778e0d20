# SPDX-License-Identifier: GPL-3.0-or-later
"""Global Developability on other people's panels.

Those that have a developable shape near them reach it; those that have none are told to need a cut and keep
their triangles in order.
"""

import os
import subprocess
import sys
import tarfile
from pathlib import Path

import meshlab_developable
import numpy as np
import pymeshlab
import pytest
from measures import edges_of, shape_measures
from meshlab_developable import Status

DEMO = Path("/usr/share/doc/libcgal-dev/data.tar.gz")
BUNNY = Path(pymeshlab.__file__).parent / "tests/sample_meshes/bunny10k_textured.obj"

needs_demo = pytest.mark.skipif(
    not DEMO.exists(), reason="libcgal-demo, whose panels these are, is not installed"
)


def panel(name: str, folder: Path) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of a panel of libcgal-demo."""
    with tarfile.open(DEMO) as archive:
        path = folder / f"{name}.off"
        path.write_bytes(archive.extractfile(f"data/meshes/{name}.off").read())
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    return meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()


def normals(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Unit normals of the faces."""
    a, b, c = (vertices[faces[:, i]] for i in range(3))
    normal = np.cross(b - a, c - a)
    return normal / np.linalg.norm(normal, axis=1)[:, None]


def smallest_angle(vertices: np.ndarray, faces: np.ndarray) -> float:
    """Of all corners, degrees."""
    smallest = 180.0
    for i in range(3):
        u = vertices[faces[:, (i + 1) % 3]] - vertices[faces[:, i]]
        v = vertices[faces[:, (i + 2) % 3]] - vertices[faces[:, i]]
        angles = np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), np.einsum("ij,ij->i", u, v))
        smallest = min(smallest, float(np.degrees(angles.min())))
    return smallest


def assert_sound(before: np.ndarray, after: np.ndarray, faces: np.ndarray) -> None:
    """No face is flipped and none has become a sliver."""
    pairs = np.array([sharing for sharing in edges_of(faces).values() if len(sharing) == 2])
    cosines = [
        np.einsum("ij,ij->i", n[pairs[:, 0]], n[pairs[:, 1]])
        for n in (normals(v, faces) for v in (before, after))
    ]
    assert not np.any((cosines[0] > 0) & (cosines[1] < -0.5))
    assert smallest_angle(after, faces) >= min(smallest_angle(before, faces) / 2, 2)


@needs_demo
@pytest.mark.parametrize("name", ["nefertiti", "patch-01"])
def test_a_panel_becomes_developable(name: str, tmp_path: Path) -> None:
    """C is next to nothing, by a measure of our own."""
    vertices, faces = panel(name, tmp_path)
    result = meshlab_developable.make_developable(vertices, faces)
    assert result.report.status is Status.CONVERGED
    assert shape_measures(result.vertices, faces)["total_absolute_curvature"] < 1e-3
    assert_sound(vertices, result.vertices, faces)


def assert_needs_cut(vertices: np.ndarray, faces: np.ndarray) -> None:
    """Better than before, near, and in order."""
    result = meshlab_developable.make_developable(vertices, faces)
    report = result.report
    assert report.status is Status.NEEDS_CUT
    assert report.total_absolute_curvature_after < report.total_absolute_curvature_before
    assert report.detect_function_after < report.detect_function_before
    assert report.max_displacement < 0.21 * np.linalg.norm(np.ptp(vertices, axis=0))
    assert_sound(vertices, result.vertices, faces)


@needs_demo
@pytest.mark.parametrize("name", ["mushroom", "lion-head", "three_peaks"])
def test_a_panel_that_needs_a_cut_is_told_so(name: str, tmp_path: Path) -> None:
    """Much curvature and a short border."""
    assert_needs_cut(*panel(name, tmp_path))


def test_the_bunny_needs_a_cut() -> None:
    """The scan that comes with pymeshlab."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(BUNNY))
    mesh = meshes.current_mesh()
    assert_needs_cut(mesh.vertex_matrix(), mesh.face_matrix())


def test_the_number_of_threads_changes_nothing() -> None:
    """To the last bit, on a mesh that is solved on several levels."""
    program = (
        "import hashlib, numpy as np, meshlab_developable as md\n"
        "n = 61; u, v = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n))\n"
        "points = np.stack([u, v, 0.05 * np.sin(6 * u) * np.cos(5 * v)], -1).reshape(-1, 3)\n"
        "i = np.arange(n * n).reshape(n, n); a, b, c, d = i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]\n"
        "faces = np.concatenate([np.stack(t, -1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])\n"
        "result = md.make_developable(points, faces)\n"
        "print(result.report.status.name, hashlib.sha256(result.vertices.tobytes()).hexdigest())\n"
    )
    outputs = {
        subprocess.run(
            [sys.executable, "-c", program],
            env={**os.environ, "OMP_NUM_THREADS": threads, "OPENBLAS_NUM_THREADS": threads},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for threads in ("1", "2", "3")
    }
    assert len(outputs) == 1
    assert outputs.pop().startswith("CONVERGED")
