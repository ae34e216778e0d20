# SPDX-License-Identifier: GPL-3.0-or-later
"""Many meshes made developable, on all cores or on a cluster, one bad mesh costing that mesh only.

Dask hands the meshes out. Each of its workers keeps child processes that do the work, so that a crash, a hang
or a mesh too large ends a child and nothing else. What is finished is recorded at once, in a file a mesh: a
run that was killed goes on where it was.
"""

from meshlab_developable.batch.records import Row, State
from meshlab_developable.batch.run import run
from meshlab_developable.batch.settings import Settings

__all__ = ["Row", "Settings", "State", "run"]
