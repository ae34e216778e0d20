#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds a benchmark and runs it beside others: bash bench/run.sh NAME, with NAME one of bench/NAME.py.
set -euo pipefail
cd "$(dirname "$0")/.."
name=${1:?usage: bash bench/run.sh NAME, with NAME one of bench/NAME.py}
shift
bash scripts/setup.sh pymeshlab-2025.7 >&2
if [[ ! -f bench/${name}_bench.cpp ]]; then exec .venv/bin/python "bench/$name.py" "$@"; fi
cmake --preset bench >&2
cmake --build --preset bench --target "${name}_bench" >&2
exec .venv/bin/python "bench/$name.py" "build/bench/bench/${name}_bench" "$@"
