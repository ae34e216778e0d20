# SPDX-License-Identifier: GPL-3.0-or-later
"""Child processes that stay ready for the next mesh, and are replaced when one of them dies."""

from __future__ import annotations

import json
import os
import selectors
import signal
import subprocess
import sys
import tempfile
import threading
import time
from typing import Any

from distributed import Worker, WorkerPlugin

from meshlab_developable.batch.records import Job, Row, State
from meshlab_developable.batch.settings import Settings
from meshlab_developable.parent import OUT_OF_MEMORY

START_LIMIT = 300.0  # seconds until a child must be ready
MESHES_A_CHILD = 500  # then it makes room for a fresh one, should a library not give back all it takes


class TimeLimitError(Exception):
    """A child did not answer in time."""


class StartError(Exception):
    """A child was never ready; the text says why."""


class Child:
    """One process, ready when made, or StartError says why it is not. Raises EOFError when it dies and
    TimeLimitError when it does not answer; it is of no use afterwards."""

    def __init__(self, settings: Settings) -> None:
        self._said = tempfile.TemporaryFile()  # noqa: SIM115 - closed at the end
        self._said_before = 0  # how much of that is about earlier jobs
        self._process = subprocess.Popen(
            [
                sys.executable,
                "-m",
                "meshlab_developable.batch.child",
                str(os.getpid()),
                f"{settings.memory_limit}",
            ],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._said,
            env={**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"},
        )
        self._selector = selectors.DefaultSelector()
        self._selector.register(self._answers, selectors.EVENT_READ)
        self.finished = 0
        self._wait_until_ready()

    @property
    def _answers(self) -> Any:
        return self._process.stdout

    def work(self, job: Job) -> dict[str, Any]:
        """The child's answer to a job."""
        request = {
            "source": str(job.source),
            "target": str(job.target),
            "thumbnail": str(job.thumbnail),
            "before": job.before and str(job.before),
            "pattern": job.pattern and str(job.pattern),
            "patterns": None if job.settings.patterns is None else dict(job.settings.patterns),
            "scratch": str(job.scratch),
            "method": job.settings.method,
            "parameters": dict(job.settings.parameters),
        }
        assert self._process.stdin is not None
        self._said_before = os.fstat(self._said.fileno()).st_size
        try:
            self._process.stdin.write(json.dumps(request).encode() + b"\n")
            self._process.stdin.flush()
        except BrokenPipeError:
            raise EOFError from None
        answer = self._answer(job.settings.time_limit)
        self.finished += 1
        return answer

    def is_alive(self) -> bool:
        """Whether the process is there."""
        return self._process.poll() is None

    def end(self) -> str:
        """Ends the process; how it ended, in words."""
        self._process.kill()  # does nothing to one that ended by itself
        self._process.wait()
        self._selector.close()
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                try:
                    pipe.close()
                except BrokenPipeError:
                    continue
        self._said.seek(self._said_before)
        said = self._said.read().decode(errors="replace").strip().splitlines()
        self._said.close()
        return _end_in_words(self._process.returncode, said)

    def _wait_until_ready(self) -> None:
        try:
            self._answer(START_LIMIT)
        except TimeLimitError:
            self.end()
            raise StartError(f"its process was not ready within {START_LIMIT:g} s") from None
        except EOFError:
            raise StartError(f"its process could not start: {self.end()}") from None

    def _answer(self, limit: float) -> dict[str, Any]:
        """The next line of the child's, which is never longer than a pipe holds."""
        end = time.monotonic() + limit
        line = b""
        while not line.endswith(b"\n"):
            if not self._selector.select(max(0.0, end - time.monotonic())):
                raise TimeLimitError
            read = os.read(self._answers.fileno(), 1 << 16)
            if not read:
                self._process.wait()
                raise EOFError
            line += read
        answer: dict[str, Any] = json.loads(line)
        return answer


class Children(WorkerPlugin):
    """What a Dask worker keeps: as many children as it does jobs at once."""

    name = "developable-children"

    def __init__(self, settings: Settings) -> None:
        self.settings = settings

    def setup(self, worker: Worker) -> None:
        """On the worker, before its first job."""
        self._idle: list[Child] = []
        self._lock = threading.Lock()

    def teardown(self, worker: Worker) -> None:
        """On the worker, after its last."""
        with self._lock:
            while self._idle:
                self._idle.pop().end()

    def work(self, job: Job) -> Row:
        """How a mesh ends; whatever it does to the child that works on it."""
        try:
            child = self._ready_child()
        except StartError as error:
            return Row(job.name, State.CRASHED, str(error))
        try:
            answer = child.work(job)
        except TimeLimitError:
            child.end()
            return Row(job.name, State.TIMED_OUT, f"took longer than {job.settings.time_limit:g} s")
        except EOFError:
            return Row(job.name, State.CRASHED, child.end())
        self._keep(child)
        return Row(job.name, State(answer["state"]), answer["message"], answer["numbers"], answer["panels"])

    def _ready_child(self) -> Child:
        """One that waits, or a new one; the death of one that waited is no mesh's fault."""
        while True:
            with self._lock:
                if not self._idle:
                    break
                child = self._idle.pop()
            if child.is_alive():
                return child
            child.end()
        return Child(self.settings)

    def _keep(self, child: Child) -> None:
        if child.finished >= MESHES_A_CHILD:
            child.end()
            return
        with self._lock:
            self._idle.append(child)


def _end_in_words(code: int, said: list[str]) -> str:
    signs = ("bad_alloc", "MemoryError", "Memory allocation still failed")  # the last is OpenBLAS's
    if code == OUT_OF_MEMORY or any(sign in line for sign in signs for line in said):
        return "needed more memory than the limit"
    last = f": {said[-1]}" if said else ""
    if code < 0:
        return f"the process was ended by {signal.Signals(-code).name}{last}"
    return f"the process ended with code {code}{last}"
