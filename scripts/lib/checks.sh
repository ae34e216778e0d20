# SPDX-License-Identifier: GPL-3.0-or-later
# checks.sh: what is asked of the sources themselves: format and lint, of C++, Python and shell.

cpp_folders=()
for folder in vcg_ext filter_developable tests bench; do
	if [[ -d $root/$folder ]]; then cpp_folders+=("$root/$folder"); fi
done

cpp_files() { find "${cpp_folders[@]}" -name '*.h' -o -name '*.cpp' | sort; }

check_cpp_format() { cpp_files | xargs clang-format-14 --dry-run -Werror; }

# tidy_one BUILD FILE: clang-tidy on one translation unit, unless it passed as it and all headers are now
tidy_one() {
	set -euo pipefail
	local headers
	headers=$(cpp_files | grep '\.h$')
	# shellcheck disable=SC2086 # one word a header
	once "$build_root/tidy/${2#"$root"/}" "$(checksum "$root/.clang-tidy" "$2" $headers)" \
		clang-tidy-14 --quiet -p "$1" "$2" 2> >(grep -vE '^[0-9]+ warnings? (generated|treated)' >&2)
}

# commands_without_precompiled_headers BUILD FOLDER: how a build compiles its units, as clang-tidy can follow it: it can't read
# GCC's precompiled headers, and every unit names what it includes anyway
commands_without_precompiled_headers() {
	mkdir -p "$2"
	sed -E 's# -Winvalid-pch -include [^ ]*/cmake_pch\.hxx##' "$1/compile_commands.json" >"$2/compile_commands.json"
}

# A unit is looked at once, in the first of the builds that compile it. The tests' units, which take longest and ship
# nothing, are looked at when DEVELOPABLE_TIDY_TESTS is set.
check_cpp_tidy() {
	local build folder
	for build in library ${DEVELOPABLE_TIDY_TESTS:+tests} pymeshlab-2025.7 meshlab-2020.09; do
		folder=$build_root/tidy-commands/$build
		commands_without_precompiled_headers "$build_root/$build" "$folder"
		sed -n 's/^ *"file": "\(.*\)".*/\1/p' "$folder/compile_commands.json" | grep -v "^$build_root/" | sed "s#^#$folder #"
	done | awk '!seen[$2]++' | xargs -P "$(nproc)" -L 1 bash -c 'tidy_one "$@"' tidy_one
}

check_python_lint() { "$root/.venv/bin/ruff" check --quiet "$root"; }
check_python_format() { "$root/.venv/bin/ruff" format --check "$root"; }
check_python_types() { (cd "$root/python" && "$root/.venv/bin/mypy" --no-error-summary); }
check_shell() { shellcheck "$root"/scripts/*.sh "$root"/scripts/lib/*.sh "$root/.ci/run"; }
