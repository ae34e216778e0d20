# SPDX-License-Identifier: GPL-3.0-or-later
"""What is compiled for AVX2 must not serve other processors: the linker takes any copy of a function."""

import os
import platform
import subprocess
from pathlib import Path

import pytest

CACHE = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "developable"
ARCHIVE = CACHE / "cholmod" / "lib" / "libcholmod_for_plugins.a"
RENAMED = "EigenForAvx2"


def shared_functions(member):
    """The functions of one member of which the linker keeps one copy for the whole program."""
    symbols = subprocess.run(["nm", "-C", ARCHIVE], capture_output=True, text=True, check=True).stdout
    of_member = symbols.split(f"{member}.cpp.o:\n")[1].split("\n\n")[0].splitlines()
    words = [line.split(maxsplit=2) for line in of_member if not line.startswith(" ")]
    return [name for _, kind, name in words if kind in "WVu" and "gxx_personality" not in name]


@pytest.mark.skipif(platform.machine() != "x86_64", reason="only x86 has AVX2")
def test_avx2_stays_where_it_was_asked_for():
    assert any("llt_inplace" in name for name in shared_functions("eigen_avx2"))
    assert [name for name in shared_functions("eigen_avx2") if RENAMED not in name] == []
    assert [name for name in shared_functions("eigen_blas") if RENAMED in name] == []
