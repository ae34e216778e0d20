#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds a benchmark and runs it beside others: bash bench/run.sh NAME, with NAME one of bench/NAME.py.
. "$(dirname "$0")/../scripts/lib/common.sh"
. "$root/scripts/lib/packages.sh"
cd "$root"
name=${1:?usage: bash bench/run.sh NAME, with NAME one of bench/NAME.py}
shift
bash scripts/setup.sh pymeshlab-2025.7 >&2
requirements=bench/requirements-$name.txt
if [[ -f $requirements ]]; then .venv/bin/python -m pip install --quiet --disable-pip-version-check -r "$requirements" >&2; fi
program=${name}_bench
case $name in
solvers) install_packages libcgal-demo >&2 ;; # panels of other people
ablation | estimates | folds | goals | reference | verdicts) program=solvers_bench ;;
esac
if [[ ! -f bench/$program.cpp ]]; then exec .venv/bin/python "bench/$name.py" "$@"; fi
cmake --preset bench >&2
cmake --build --preset bench --target "$program" >&2
exec .venv/bin/python "bench/$name.py" "build/bench/bench/$program" "$@"
