#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# demo.sh [MESH...]: sets up what is missing, makes the demo's meshes (or those named) more developable, and writes
# results, pictures and a report to out/demo/.

. "$(dirname "$0")/lib/common.sh"

bash "$root/scripts/setup.sh" demo
exec "$root/.venv/bin/python" -m meshlab_developable.demo --out "$root/out/demo" "$@"
