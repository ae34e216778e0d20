# SPDX-License-Identifier: GPL-3.0-or-later
"""Several meshes studied side by side."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from meshlab_developable.demo.study import MAPS, MAPS_OF_PANELS, Input, Method, Study, study
from meshlab_developable.plugin import load
from meshlab_developable.processors import cores


def studies(
    inputs: Sequence[Input], methods: Sequence[Method], angle_tolerance: float, folder: Path
) -> Iterator[Study]:
    """In the order of the inputs; several at once, each on one thread. What is to be cut takes longest, and
    begins first.

    Raises what study raises.
    """
    workers = min(len(inputs), cores())
    if workers <= 1:
        load()
        yield from (_studied(source, methods, angle_tolerance, folder) for source in inputs)
        return
    fresh = multiprocessing.get_context("spawn")  # a copy of this process would hold the plugin's threads
    with ProcessPoolExecutor(workers, mp_context=fresh, initializer=_begin_beside_others) as pool:
        ahead = {
            index: pool.submit(_studied, inputs[index], methods, angle_tolerance, folder)
            for index in sorted(range(len(inputs)), key=lambda index: not inputs[index].cut)
        }
        try:
            yield from (ahead[index].result() for index in range(len(inputs)))
        finally:
            pool.shutdown(cancel_futures=True)


def _begin_beside_others() -> None:
    os.environ["OMP_NUM_THREADS"] = "1"
    load()


def _studied(source: Input, methods: Sequence[Method], angle_tolerance: float, folder: Path) -> Study:
    """Panels of a cut are for the methods that go all the way, which can be laid flat."""
    if source.cut:
        methods = [method for method in methods if method.flatten]
    return study(source, methods, angle_tolerance, folder, MAPS_OF_PANELS if source.cut else MAPS)
