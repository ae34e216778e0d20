# SPDX-License-Identifier: GPL-3.0-or-later
"""Batches: every input ends in one state, whatever is killed on the way, and nothing is done twice."""

from __future__ import annotations

import csv
import fcntl
import html.parser
import json
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import meshlab_developable
import numpy as np
import psutil
import pyarrow.csv
import pyarrow.parquet
import pymeshlab
import pytest
from click.testing import CliRunner
from distributed import Client, LocalCluster
from meshlab_developable import filters
from meshlab_developable.batch import Settings, State
from meshlab_developable.batch.children import Children
from meshlab_developable.batch.inputs import find_inputs
from meshlab_developable.batch.records import Job, Row
from meshlab_developable.batch.settings import read_settings
from meshlab_developable.batch.table import write_tables
from meshlab_developable.batch.thumbnails import BACKGROUND, SIZE, draw
from meshlab_developable.command_line import main
from PIL import Image

MODELS = Path(__file__).parents[2] / "meshes"
HEADER = "ply\nformat {} 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
HEADER += "element face {}\nproperty list uchar int vertex_indices\nend_header\n"
CORNERS = "0 0 0\n1 0 0\n0 1 0\n"
BROKEN = {
    "empty.ply": b"",
    "garbage.obj": bytes(range(256)) * 50,
    "garbage.vtu": bytes(range(256)) * 50,
    "garbage.glb": bytes(range(256)) * 50,
    "no_faces.ply": (HEADER.format("ascii", 3, 0) + CORNERS).encode(),
    "wrong_index.ply": (HEADER.format("ascii", 3, 1) + CORNERS + "3 0 1 7\n").encode(),
    "truncated.ply": (MODELS / "shoe_upper.ply").read_bytes()[:9000],
}
CRASHES = {
    "too_large.ply": HEADER.format("binary_little_endian", 2_000_000_000, 1).encode(),
    "wild_index.obj": b"v 0 0 0\nv 1 0 0\nf 1 2 99999999\n",  # ends the host
}


def batch(*arguments: object):
    return CliRunner().invoke(main, ["batch", *map(str, arguments)], prog_name="developable")


def start(*arguments: object) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "meshlab_developable.command_line", "batch", *map(str, arguments)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def rows_of(out: Path) -> dict[str, dict[str, object]]:
    return {row["input"]: row for row in pyarrow.parquet.read_table(out / "results.parquet").to_pylist()}


def states_of(out: Path) -> dict[str, str]:
    return {name: row["state"] for name, row in rows_of(out).items()}


def snapshot(out: Path, *folders: str) -> dict[Path, tuple[int, int]]:
    """Which files there are, and whether they are still the same."""
    files = [file for folder in folders for file in (out / folder).rglob("*") if file.is_file()]
    return {file: (file.stat().st_ino, file.stat().st_mtime_ns) for file in files}


def copies(folder: Path, count: int) -> Path:
    folder.mkdir()
    for number in range(count):
        shutil.copy(MODELS / "short_pants.ply", folder / f"pants{number:02}.ply")
    return folder


@pytest.fixture(scope="module")
def mixed(tmp_path_factory) -> tuple[Path, Path, object]:
    """Good, hopeless, broken and murderous meshes, and how the batch of them ended."""
    folder = tmp_path_factory.mktemp("mixed")
    source, out = folder / "in", folder / "in" / "out"
    (source / "more").mkdir(parents=True)
    for name in ("shoe_upper.ply", "shoe_upper.obj", "dented_shell.ply"):
        shutil.copy(MODELS / name, source / name)
    shutil.copy(MODELS / "sheet_bent.ply", source / "more" / "sheet bent.ply")
    (source / "notes.txt").write_text("no mesh")
    for name, content in (BROKEN | CRASHES).items():
        (source / name).write_bytes(content)
    settings = folder / "settings.toml"
    settings.write_text('method = "global"\nmemory_limit = 400\n[parameters]\nmax_iterations = 40\n')
    return source, out, batch(source, "--out", out, "--parameters", settings)


def test_every_input_ends_in_one_state(mixed):
    _, out, result = mixed
    assert result.exit_code == 4, result.output
    good = ["dented_shell.ply", "more/sheet bent.ply", "shoe_upper.obj", "shoe_upper.ply"]
    expected = (
        dict.fromkeys(good, "done") | dict.fromkeys(BROKEN, "bad_input") | dict.fromkeys(CRASHES, "crashed")
    )
    assert states_of(out) == expected
    assert list(states_of(out)) == sorted(expected, key=Path)


def test_messages_say_what_was_wrong(mixed):
    rows = rows_of(mixed[1])
    assert "more memory than the limit" in rows["too_large.ply"]["message"]
    assert "SIGSEGV" in rows["wild_index.obj"]["message"]
    assert "no faces" in rows["no_faces.ply"]["message"]
    assert all(row["message"] and "\n" not in row["message"] for row in rows.values())


def test_tables_hold_the_same_and_all_numbers(mixed):
    parquet = pyarrow.parquet.read_table(mixed[1] / "results.parquet")
    text = pyarrow.csv.read_csv(mixed[1] / "results.csv")
    assert parquet.column_names == text.column_names
    assert text.column_names[:3] == ["input", "state", "message"]
    for name in parquet.column_names:
        assert parquet[name].to_pylist() == text[name].to_pylist()


@pytest.mark.parametrize(
    ("name", "target"), [("shoe_upper.ply", "shoe_upper.ply.ply"), ("dented_shell.ply", "dented_shell.ply")]
)
def test_results_are_the_filters_to_the_last_bit(name, target, mixed, tmp_path):
    meshlab_developable.load()
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(MODELS / name))
    values = meshes.apply_filter(filters.GLOBAL.function, max_iterations=40)
    meshes.save_current_mesh(str(tmp_path / "expected.ply"))
    assert (mixed[1] / "meshes" / target).read_bytes() == (tmp_path / "expected.ply").read_bytes()
    row = rows_of(mixed[1])[name]
    assert {key: row[key] for key in values if key != "seconds"} == {
        key: value for key, value in values.items() if key != "seconds"
    }
    assert set(row) == {"input", "state", "message", "panels", *values}


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.states, self.addresses = [], []

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        if tag == "li":
            self.states.append(attributes["class"])
        self.addresses += [attributes[key] for key in ("src", "href") if key in attributes]


def test_the_overview_has_the_worst_first_and_its_pictures(mixed):
    from urllib.parse import unquote

    page = Page()
    page.feed((mixed[1] / "overview.html").read_text("utf-8"))
    assert page.states == ["crashed"] * 2 + ["bad_input"] * len(BROKEN) + ["done"] * 4
    assert all((mixed[1] / unquote(address)).is_file() for address in page.addresses)
    pictures = [address for address in page.addresses if address.endswith(".png")]
    assert len(pictures) == 4
    for address in pictures:
        with Image.open(mixed[1] / unquote(address)) as picture:
            assert picture.size == SIZE
            assert len(picture.getcolors(1 << 16)) > 5


def test_a_second_run_does_nothing_twice(mixed):
    source, out, _ = mixed
    before = snapshot(out, "meshes", "thumbnails", "records")
    result = batch(source, "--out", out, "--parameters", source.parent / "settings.toml")
    assert result.exit_code == 4
    assert snapshot(out, "meshes", "thumbnails", "records") == before
    assert not list(out.rglob(".unfinished"))


def children_of(process: subprocess.Popen[bytes], words: str) -> list[psutil.Process]:
    try:
        found = psutil.Process(process.pid).children(recursive=True)
        return [child for child in found if words in " ".join(child.cmdline())]
    except psutil.NoSuchProcess:
        return []


def wait_for(condition, seconds: float = 120) -> None:
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


SLOW = '[parameters]\nsolver = "Conjugate gradient"\nrelative_change = 0\nmax_iterations = 400\n'


@pytest.fixture
def slow(tmp_path) -> Path:
    """Settings with which a mesh takes a fair part of a second, and does not converge."""
    path = tmp_path / "slow.toml"
    path.write_text(SLOW)
    return path


def test_a_killed_run_goes_on_where_it_was(tmp_path, slow):
    source, out = copies(tmp_path / "in", 8), tmp_path / "out"
    run = start(source, "--out", out, "--parameters", slow)
    wait_for(lambda: len(list(out.glob("records/*.json"))) >= 3)
    family = psutil.Process(run.pid).children(recursive=True)
    run.kill()
    run.communicate()
    psutil.wait_procs(family, timeout=60)
    assert not [process for process in family if process.is_running()]
    finished = {path.stem for path in out.glob("records/*.json")}
    assert 3 <= len(finished) < 8
    before = {
        path: state for path, state in snapshot(out, "records", "meshes").items() if path.stem in finished
    }
    assert len(before) == 2 * len(finished)
    result = batch(source, "--out", out, "--parameters", slow)
    assert result.exit_code == 4, result.output
    after = snapshot(out, "records", "meshes")
    assert {path: after[path] for path in before} == before
    assert list(states_of(out).values()) == ["not_converged"] * 8
    contents = {path.read_bytes() for path in (out / "meshes").iterdir()}
    assert len(contents) == 1
    assert not list(out.rglob(".unfinished"))


def test_an_interrupted_run_is_130_and_tidy(tmp_path, slow):
    source, out = copies(tmp_path / "in", 8), tmp_path / "out"
    run = start(source, "--out", out, "--parameters", slow)
    wait_for(lambda: list(out.glob("records/*.json")))
    family = psutil.Process(run.pid).children(recursive=True)
    run.send_signal(signal.SIGINT)
    _, errors = run.communicate(timeout=120)
    assert run.returncode == 130, errors
    assert b"Traceback" not in errors
    psutil.wait_procs(family, timeout=60)
    assert not [process for process in family if process.is_running()]
    assert not list(out.rglob(".unfinished*"))


def test_killed_workers_cost_nothing_and_killed_children_their_mesh(tmp_path, slow):
    source, out = copies(tmp_path / "in", 8), tmp_path / "out"
    run = start(source, "--out", out, "--parameters", slow, "--workers", 2)
    wait_for(lambda: len(list(out.glob("records/*.json"))) >= 1 and len(children_of(run, "batch.child")) == 2)
    victim, other = children_of(run, "batch.child")
    other.suspend()  # with a mesh in hand, or soon given one: what is finished from here on is not its work
    victim.parent().send_signal(signal.SIGKILL)  # the parents of children are Dask's workers
    psutil.wait_procs([victim], timeout=30)
    assert not victim.is_running()
    wait_for(lambda: len(list(out.glob("records/*.json"))) >= 6)  # one may wait for the suspended child
    other.send_signal(signal.SIGKILL)
    _, errors = run.communicate(timeout=120)
    assert run.returncode == 4, errors
    rows = rows_of(out)
    assert len(rows) == 8
    (crashed,) = (row["message"] for row in rows.values() if row["state"] == "crashed")
    assert "SIGKILL" in crashed
    assert sum(row["state"] == "not_converged" for row in rows.values()) == 7


def test_hard_names_cost_no_other_mesh_anything(tmp_path):
    """Names that are no text, as long as names can be, or formulas to a spreadsheet; and again."""
    source, out = tmp_path / "in", tmp_path / "out"
    source.mkdir()
    names = {
        "\udcff.ply": "bad_input",
        "n" * 251 + ".ply": "done",
        "n" * 250 + "m.ply": "done",
        "=1+1.ply": "done",
        "a.ply": "done",
    }
    for name in names:
        shutil.copy(MODELS / "dented_shell.ply", source / name)
    expected = {name.replace("\udcff", "\\xff"): state for name, state in names.items()}
    for _ in range(2):
        result = batch(source, "--out", out, "--workers", 1)
        assert result.exit_code == 4, result.output
        assert states_of(out) == expected
    assert "UTF-8" in rows_of(out)["\\xff.ply"]["message"]
    assert len(list((out / "meshes").iterdir())) == 4
    cells = pyarrow.csv.read_csv(out / "results.csv")["input"].to_pylist()
    assert set(cells) == expected.keys() - {"=1+1.ply"} | {"'=1+1.ply"}


@pytest.mark.parametrize("start", ["=", "+", "-", "@", "\t", "\r"])
def test_cells_are_no_formulas(start, tmp_path):
    row = Row(f"{start}SUM(A1).ply", State.BAD_INPUT, f"{start}1 = 2")
    write_tables(tmp_path, [row, Row("plain=.ply", State.BAD_INPUT, "")], "global", tmp_path)
    assert [row["input"] for row in rows_of(tmp_path).values()] == [row.input, "plain=.ply"]
    with (tmp_path / "results.csv").open(newline="") as file:
        cells = list(csv.DictReader(file))
    assert [cell["input"] for cell in cells] == ["'" + row.input, "plain=.ply"]
    assert cells[0]["message"] == "'" + row.message


def test_no_memory_inside_a_filter_is_crashed(tmp_path):
    """The reader needs less than the filter does, for a limit between."""
    side = 150
    grid = np.arange(side * side).reshape(side, side)
    a, b, c, d = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
    faces = np.concatenate([np.stack(corners, -1).reshape(-1, 3) for corners in ((a, b, c), (a, c, d))])
    x, y = np.divmod(np.arange(side * side), side)
    vertices = np.stack([x, y, np.sin(x / 9.0) * np.cos(y / 7.0)], axis=1)
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(vertices, faces))
    (tmp_path / "in").mkdir()
    meshes.save_current_mesh(str(tmp_path / "in" / "large.ply"))
    out = tmp_path / "out"
    settings = tmp_path / "settings.toml"
    settings.write_text("memory_limit = 30\n[parameters]\nmax_iterations = 5\n")
    assert batch(tmp_path / "in", "--out", out, "--parameters", settings).exit_code == 4
    (row,) = rows_of(out).values()
    assert (row["state"], row["message"]) == ("crashed", "needed more memory than the limit")


def test_time_limit_and_again(tmp_path, slow):
    source, out = copies(tmp_path / "in", 2), tmp_path / "out"
    result = batch(source, "--out", out, "--parameters", slow, "--time-limit", 0.01)
    assert result.exit_code == 4
    assert states_of(out)["pants00.ply"] == states_of(out)["pants01.ply"] == "timed_out"
    assert "longer than 0.01 s" in rows_of(out)["pants00.ply"]["message"]
    assert not list((out / "meshes").glob("pants*"))
    result = batch(source, "--out", out, "--parameters", slow, "--again", "timed_out", "--workers", 1)
    assert states_of(out)["pants00.ply"] == states_of(out)["pants01.ply"] == "not_converged"


def test_a_child_that_does_not_start_says_why(tmp_path, monkeypatch):
    program = tmp_path / "python"
    program.write_text("#!/bin/sh\necho 'a library is missing' >&2\nexit 3\n")
    program.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(program))
    path = tmp_path / "mesh.ply"
    job = Job("mesh.ply", path, path, path, path, tmp_path, Settings())
    children = Children(job.settings)
    children.setup(None)
    row = children.work(job)
    assert (row.input, row.state) == ("mesh.ply", State.CRASHED)
    assert row.message == "its process could not start: the process ended with code 3: a library is missing"


def test_an_existing_scheduler_and_a_list(tmp_path):
    shutil.copy(MODELS / "shoe_upper.ply", tmp_path / "a.ply")
    (tmp_path / "list.txt").write_text("# meshes\na.ply\n\nno_such_mesh.ply\n")
    out = tmp_path / "out"
    with LocalCluster(n_workers=1, threads_per_worker=2, dashboard_address=None) as cluster:
        address = cluster.scheduler_address
        result = batch(tmp_path / "list.txt", "--out", out, "--scheduler", address, "--json")
    assert result.exit_code == 4, result.output
    assert states_of(out) == {"a.ply": "done", "no_such_mesh.ply": "bad_input"}
    counts = json.loads(result.stdout)
    assert (counts["meshes"], counts["done"], counts["bad_input"]) == (2, 1, 1)


def test_all_done_is_0_and_a_changed_file_or_method_is_done_again(tmp_path):
    source, out = tmp_path / "in", tmp_path / "out"
    source.mkdir()
    shutil.copy(MODELS / "shoe_upper.ply", source / "a.ply")
    shutil.copy(MODELS / "shoe_upper.ply", source / "b.ply")
    assert batch(source, "--out", out, "--workers", 1).exit_code == 0
    before = snapshot(out, "records")
    shutil.copy(MODELS / "dented_shell.ply", source / "b.ply")
    assert batch(source, "--out", out, "--workers", 1).exit_code == 0
    after = snapshot(out, "records")
    assert [path.name for path in after if after[path] != before[path]] == ["b.json"]
    assert batch(source, "--out", out, "--method", "local", "--workers", 1).exit_code == 4
    assert not snapshot(out, "records").items() & after.items()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("methud = 'global'", ["'methud'", "'method'"]),
        ("method = 'sideways'", ["'sideways'", "'local'"]),
        ("time_limit = 0", ["time_limit", "above 0"]),
        ("memory_limit = true", ["memory_limit", "above 0"]),
        ("parameters = 3", ["parameters", "table"]),
        ("[parameters]\nangle_tolerence = 1", ["'angle_tolerence'", "'angle_tolerance'"]),
        ("[parameters]\nangle_tolerance = 'wide'", ["angle_tolerance", "0 or more"]),
        ("[parameters]\nmax_operations = 3", ["Global Developability", "'max_operations'"]),
        ("method = ", ["settings.toml"]),
    ],
)
def test_every_key_of_the_settings_is_checked(content, words, tmp_path):
    path = tmp_path / "settings.toml"
    path.write_text(content)
    with pytest.raises(meshlab_developable.InvalidParameterError) as caught:
        read_settings(path)
    for word in words:
        assert word in str(caught.value)
    shutil.copy(MODELS / "shoe_upper.ply", tmp_path)
    assert batch(tmp_path, "--out", tmp_path / "out", "--parameters", path).exit_code == 2
    assert not (tmp_path / "out").exists()


def test_settings_arrive(tmp_path):
    path = tmp_path / "settings.toml"
    path.write_text('method = "local"\ntime_limit = 5\nmemory_limit = 100\n[parameters]\ndescent = true\n')
    assert read_settings(path) == Settings("local", {"descent": True}, 5, 100)


def test_the_pages_settings_are_settings(tmp_path):
    page = (MODELS.parent / "docs" / "batch.md").read_text("utf-8")
    (example,) = re.findall(r"```toml\n(.*?)```", page, re.DOTALL)
    (tmp_path / "settings.toml").write_text(example)
    settings = read_settings(tmp_path / "settings.toml")
    assert (settings.method, settings.time_limit, settings.memory_limit) == ("global", 600, 2000)
    assert settings.parameters == {"angle_tolerance": 0.001, "fix_boundary": True}
    assert f"{Settings().time_limit:g} when not given" in page
    assert f"{Settings().memory_limit:g} when not given" in page
    assert all(f"`{state}`" in page for state in State)


def test_results_of_different_inputs_do_not_meet(tmp_path):
    (tmp_path / "in" / "b").mkdir(parents=True)
    names = ["x.ply", "x.obj", "X.stl", "y.ply", "b/y.ply", "x.obj.off"]
    for name in names:
        (tmp_path / "in" / name).touch()
    (tmp_path / "list.txt").write_text("\n".join(["in/y.ply", "../y.ply", "/elsewhere/y.ply"]))
    found = find_inputs(tmp_path / "in", tmp_path / "out")
    assert {item.name for item in found} == set(names)
    for inputs in (found, find_inputs(tmp_path / "list.txt", tmp_path / "out")):
        assert len({item.stem.lower() for item in inputs}) == len(inputs)
        assert not any(Path(item.stem).is_absolute() or ".." in Path(item.stem).parts for item in inputs)


def test_a_folder_serves_one_run_at_a_time(tmp_path):
    (tmp_path / "out").mkdir()
    with (tmp_path / "out" / ".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        result = batch(MODELS, "--out", tmp_path / "out")
    assert result.exit_code == 2
    assert "another run" in result.stderr


def test_a_lost_scheduler_is_2_in_words_and_what_was_finished_stays(tmp_path, slow, monkeypatch):
    monkeypatch.setenv("DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT", "2s")
    source, out = copies(tmp_path / "in", 4), tmp_path / "out"
    with LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster:
        run = start(source, "--out", out, "--parameters", slow, "--scheduler", cluster.scheduler_address)
        wait_for(lambda: list(out.glob("records/*.json")))
    _, errors = run.communicate(timeout=120)
    assert run.returncode == 2, errors
    assert b"start the batch again" in errors
    assert b"Traceback" not in errors
    assert list(out.glob("records/*.json"))


class _LostInTheMiddle(Client):
    """A client whose scheduler goes away while it is asked; Dask then raises what its timers come to."""

    def map(self, *arguments, **options):
        raise RuntimeError("Cannot change state of expiring Timeout")

    def unregister_worker_plugin(self, *arguments, **options):
        raise RuntimeError("no loop")

    def close(self, *arguments, **options):
        lost = self.status != "closed"
        super().close(*arguments, **options)
        if lost:
            raise RuntimeError("no loop")


def test_whatever_dask_raises_of_a_lost_scheduler_is_2_in_words(tmp_path, monkeypatch):
    monkeypatch.setattr(sys.modules["meshlab_developable.batch.run"], "Client", _LostInTheMiddle)
    result = batch(copies(tmp_path / "in", 1), "--out", tmp_path / "out")
    assert result.exit_code == 2
    assert "expiring Timeout); start the batch again" in result.stderr


@pytest.mark.parametrize(
    ("prepare", "words"),
    [
        (lambda folder: [folder, "--out", folder / "out"], "no mesh"),
        (lambda folder: [MODELS, "--out", MODELS / "shoe_upper.ply"], "shoe_upper.ply"),
        (lambda folder: [MODELS / "shoe_upper.ply", "--out", folder / "out"], "is a mesh"),
        (lambda folder: [MODELS, "--out", folder / "out", "--time-limit", -1], "time_limit"),
        (lambda folder: [MODELS, "--out", folder / "out", "--scheduler", "nonsense"], "nonsense"),
    ],
)
def test_bad_requests_are_2_in_words(prepare, words, tmp_path):
    result = batch(*prepare(tmp_path))
    assert result.exit_code == 2
    assert words in result.stderr


def test_a_thumbnail_shows_the_surface_without_gaps():
    side = np.arange(5.0)
    vertices = np.array([[x, y, 0] for x in side for y in side])
    index = np.arange(25).reshape(5, 5)
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    faces = np.concatenate([np.stack(corners, -1).reshape(-1, 3) for corners in ((a, b, c), (a, c, d))])
    picture = draw(vertices, faces)
    covered = (picture != BACKGROUND).any(axis=2)
    assert covered.sum() > 5000
    for line in covered[covered.any(axis=1)]:
        assert line[np.flatnonzero(line)[0] : np.flatnonzero(line)[-1] + 1].all()
