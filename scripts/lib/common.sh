# SPDX-License-Identifier: GPL-3.0-or-later
# common.sh: what every script needs: where things are, messages, and steps that are done once. Source it first.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
# shellcheck disable=SC2034 # for those who source this
build_root=$root/build
# shellcheck disable=SC2034
cache_root=${XDG_CACHE_HOME:-$HOME/.cache}/developable # as in cmake/MeshLabHost.cmake

# Hundreds of processes import the same modules, which pip has not compiled: the first keeps what it compiles for the others.
unset PYTHONDONTWRITEBYTECODE

say() { printf -- '-- %s\n' "$*"; }

fail() {
	printf 'error: %s\n' "$*" >&2
	exit 1
}

# checksum FILE...: one checksum over the files that exist
checksum() {
	local file
	for file in "$@"; do
		if [[ -f $file ]]; then cat "$file"; fi
	done | sha256sum | cut -d' ' -f1
}

# once STAMP KEY COMMAND...: runs the command, unless it already ended well under the same key
once() {
	local stamp=$1 key=$2
	shift 2
	if [[ -f $stamp && $(<"$stamp") == "$key" ]]; then return; fi
	rm -f "$stamp"
	"$@"
	mkdir -p "$(dirname "$stamp")"
	printf '%s\n' "$key" >"$stamp"
}

# alone LOCK COMMAND...: runs the command while no other process runs one under the same lock
alone() {
	local lock=$1
	shift
	mkdir -p "$(dirname "$lock")"
	(
		flock 9
		"$@"
	) 9>"$lock"
}
