# SPDX-License-Identifier: GPL-3.0-or-later
"""What several folders of tests share lies in support/; the independent measures in python/."""

import sys
from pathlib import Path

for folder in ("support", "python"):
    sys.path.insert(0, str(Path(__file__).parent / folder))
