#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# meshlabserver.sh ARGS: the stock meshlabserver 2020.09 with the plugin in it; it gets a virtual display when there is none.

. "$(dirname "$0")/lib/common.sh"
. "$root/scripts/lib/stage.sh"
run_staged meshlabserver "$@"
