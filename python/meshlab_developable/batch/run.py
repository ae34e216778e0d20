# SPDX-License-Identifier: GPL-3.0-or-later
"""A batch from its inputs to its tables."""

from __future__ import annotations

import contextlib
import fcntl
import logging
import shutil
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

from distributed import Client, LocalCluster, as_completed, get_worker
from distributed.utils import silence_logging_cmgr

from meshlab_developable.batch.children import Children
from meshlab_developable.batch.inputs import Input
from meshlab_developable.batch.overview import write_overview
from meshlab_developable.batch.records import Job, Row, State, read_record, write_record
from meshlab_developable.batch.settings import Settings
from meshlab_developable.batch.table import write_tables
from meshlab_developable.errors import DevelopableError
from meshlab_developable.processors import cores

Finished = Callable[[Row], None]
SECONDS_BETWEEN = 3.0  # from the first mesh to the pages, and from one writing of them to the next


def run(
    inputs: Sequence[Input],
    out: Path,
    settings: Settings,
    *,
    scheduler: str | None = None,
    workers: int | None = None,
    again: Sequence[State] = (),
    finished: Finished = lambda row: None,
) -> list[Row]:
    """Work on all the inputs and write everything into the folder `out`; the rows in the inputs' order.

    scheduler: the address of a Dask scheduler whose workers see the same files; without one a cluster in
    processes of this machine, with so many workers (all cores when None). Inputs that an earlier run into the
    same folder has finished are not worked on again, unless they ended in a state of `again`, or the file or
    the method has changed. finished: called with each row, those of earlier runs first.

    Raises DevelopableError when the folder or the scheduler cannot be used, or another run uses the folder.
    """
    with _claimed(out) as scratch:
        jobs = [_job(item, out, scratch, settings) for item in inputs]
        rows = {job.name: row for job in jobs if (row := read_record(job)) and row.state not in again}
        pages = _Pages(out, jobs, settings, scratch)
        for row in rows.values():
            finished(row)
        waiting = [job for job in jobs if job.name not in rows]
        for job in waiting:
            with contextlib.suppress(OSError):  # a path too long ends its mesh, not the batch
                job.record.unlink(missing_ok=True)
        if waiting:
            with (
                silence_logging_cmgr(logging.CRITICAL),
                _client(scheduler, min(workers or cores(), len(waiting))) as client,
            ):
                for row in _work(client, waiting, settings):
                    rows[row.input] = row
                    finished(row)
                    pages.write_now_and_then(rows)
        pages.write(rows)
    return [rows[job.name] for job in jobs]


class _Pages:
    """The tables and the overview, which grow while a batch runs."""

    def __init__(self, out: Path, jobs: Sequence[Job], settings: Settings, scratch: Path) -> None:
        self._out, self._jobs, self._settings, self._scratch = out, jobs, settings, scratch
        self._next: float | None = None  # when to write again

    def write(self, rows: Mapping[str, Row]) -> None:
        """With the meshes that are finished."""
        jobs = [job for job in self._jobs if job.name in rows]
        known = [rows[job.name] for job in jobs]
        write_tables(self._out, known, self._settings.method, self._scratch)
        write_overview(self._out, jobs, known, self._scratch, len(self._jobs))

    def write_now_and_then(self, rows: Mapping[str, Row]) -> None:
        """Unless that was done a moment ago; the more there is to write, the longer the moment."""
        start = time.monotonic()
        if self._next is None:
            self._next = start + SECONDS_BETWEEN
        if start < self._next:
            return
        self.write(rows)
        self._next = time.monotonic() + max(SECONDS_BETWEEN, 20 * (time.monotonic() - start))


def work(job: Job) -> Row:
    """What a Dask worker does with a mesh; the result is recorded before it is returned.

    Dask repeats what it lost with a worker, so a mesh that was finished by one that died is finished.
    """
    recorded = read_record(job)
    if recorded:
        return recorded
    children = get_worker().plugins[Children.name]
    assert isinstance(children, Children)
    fingerprint = job.fingerprint()  # of the file as it is before it is read
    for path in filter(None, (job.target, job.thumbnail, job.before)):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)  # of an earlier run of another method
    if job.pattern is not None:
        shutil.rmtree(job.pattern, ignore_errors=True)
    row = children.work(job)
    write_record(job, row, fingerprint)
    return row


def _work(client: Client, jobs: Sequence[Job], settings: Settings) -> Iterator[Row]:
    """The rows as they come."""
    try:
        client.register_plugin(Children(settings))
        futures = client.map(work, jobs, pure=False)
        job_of = {future.key: job for future, job in zip(futures, jobs, strict=True)}
        for future in as_completed(futures):
            job = job_of[future.key]
            if future.status == "finished":
                # Dask would fetch the row from the worker, which may be dead by now.
                yield read_record(job) or future.result()
            elif future.status != "error":
                raise _lost("it answers no more")
            else:
                row = Row(job.name, State.CRASHED, f"the worker failed: {future.exception()}")
                with contextlib.suppress(OSError):  # which may be why it failed
                    write_record(job, row, job.fingerprint())
                yield row
    except DevelopableError:
        raise
    except Exception as error:  # Dask raises whatever its sockets and timers come to
        raise _lost(f"{type(error).__name__}: {error}") from None
    finally:
        with contextlib.suppress(Exception):  # the same
            client.unregister_worker_plugin(Children.name)


def _lost(why: str) -> DevelopableError:
    return DevelopableError(f"the scheduler is gone ({why}); start the batch again, and it goes on")


@contextlib.contextmanager
def _client(scheduler: str | None, workers: int) -> Iterator[Client]:
    with contextlib.ExitStack() as stack:
        address = scheduler or stack.enter_context(_cluster(workers))
        try:
            made = Client(address)
        except (OSError, ValueError) as error:
            raise DevelopableError(f"the scheduler {address} cannot be used: {error}") from None
        try:
            yield made
        finally:
            with contextlib.suppress(Exception):  # the scheduler may be gone, and everything is written
                made.close()


def _cluster(workers: int) -> LocalCluster:
    return LocalCluster(
        n_workers=workers,
        threads_per_worker=1,
        processes=True,
        memory_limit=0,  # children have a limit of their own
        dashboard_address="127.0.0.1:0",
        silence_logs=logging.CRITICAL,
    )


@contextlib.contextmanager
def _claimed(out: Path) -> Iterator[Path]:
    """The folder `out`, for this run alone; gives a folder in it for what is not finished."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        lock = (out / ".lock").open("w")
    except OSError as error:
        raise DevelopableError(f"{out} cannot be written to: {error.strerror}") from None
    with lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise DevelopableError(f"another run is writing to {out}") from None
        scratch = (out / ".unfinished").absolute()
        shutil.rmtree(scratch, ignore_errors=True)  # of a run that was killed
        scratch.mkdir()
        try:
            yield scratch
        finally:
            shutil.rmtree(scratch, ignore_errors=True)


def _job(item: Input, out: Path, scratch: Path, settings: Settings) -> Job:
    folder = out.absolute()
    return Job(
        name=item.name,
        source=item.path,
        target=folder / "meshes" / f"{item.stem}.ply",
        thumbnail=folder / "thumbnails" / f"{item.stem}.png",
        before=folder / "thumbnails_before" / f"{item.stem}.png",
        pattern=folder / "patterns" / item.stem,
        record=folder / "records" / f"{item.stem}.json",
        scratch=scratch,
        settings=settings,
    )
