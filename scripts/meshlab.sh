#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# meshlab.sh [ARGS]: the stock MeshLab 2020.09 with the plugin in it.

. "$(dirname "$0")/lib/common.sh"
. "$root/scripts/lib/stage.sh"
run_staged meshlab "$@"
