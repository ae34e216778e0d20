# SPDX-License-Identifier: GPL-3.0-or-later
"""What several files here look at, and is made once."""

from __future__ import annotations

import pytest
from demonstrated import PANTS


@pytest.fixture(scope="session")
def demonstration(tmp_path_factory):
    """The demonstration of the short pants: the folder that it wrote to, and what is known of them."""
    from meshlab_developable.demo.__main__ import METHODS, run
    from meshlab_developable.demo.study import Input

    folder = tmp_path_factory.mktemp("demo")
    [study] = run([Input(PANTS, "Short pants <of four panels>.", "cm")], METHODS, folder)
    return folder, study
