# SPDX-License-Identifier: GPL-3.0-or-later
"""Adds up JUnit reports: `count_tests.py REPORT...` prints how many tests passed and how many failed."""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def count(report: Path) -> tuple[int, int]:
    """How many test cases of a report passed and failed; the skipped count as neither."""
    passed = failed = 0
    for case in ElementTree.parse(report).iter("testcase"):
        outcomes = {child.tag for child in case}
        if outcomes & {"failure", "error"} or case.get("status") == "fail":
            failed += 1
        elif "skipped" not in outcomes:
            passed += 1
    return passed, failed


if __name__ == "__main__":
    counts = [count(Path(name)) for name in sys.argv[1:]]
    print(sum(passed for passed, _ in counts), sum(failed for _, failed in counts))
