# SPDX-License-Identifier: GPL-3.0-or-later
# checks.sh: what is asked of the sources themselves: format and lint, of C++, Python and shell.

cpp_folders=()
for folder in vcg_ext filter_developable tests bench; do
	if [[ -d $root/$folder ]]; then cpp_folders+=("$root/$folder"); fi
done

cpp_files() { find "${cpp_folders[@]}" -name '*.h' -o -name '*.cpp' | sort; }

check_cpp_format() { cpp_files | xargs clang-format-14 --dry-run -Werror; }

# tidy_unit UNIT: clang-tidy on the sources of a folder, unless it passed as they and all headers are now
tidy_unit() {
	set -euo pipefail
	local sources
	sources=$({ sed -n 's/^#include "\(.*\)"$/\1/p' "$1" && cpp_files | grep '\.h$'; })
	# shellcheck disable=SC2086 # one word a source
	once "${1%.cpp}.passed" "$(checksum "$root/.clang-tidy" "$1" $sources)" \
		clang-tidy-14 --quiet -p "$(dirname "$1")" --config-file="$root/.clang-tidy" --checks=-bugprone-suspicious-include "$1" \
		2> >(grep -vE '^[0-9]+ warnings? (generated|treated)' >&2)
}

# The plugin's sources are looked at as one host's build compiles them. The tests' units, which take longest and ship
# nothing, are looked at when DEVELOPABLE_TIDY_TESTS is set; helpers of different tests may have the same name.
check_cpp_tidy() {
	"$root/.venv/bin/python" "$root/scripts/lib/lint_units.py" "$build_root/tidy" "$build_root/library" \
		${DEVELOPABLE_TIDY_TESTS:+"$build_root/tests:alone"} "$build_root/pymeshlab-2025.7" "$build_root/meshlab-2020.09" |
		xargs -P "$(nproc)" -L 1 bash -c 'tidy_unit "$@"' tidy_unit
}

check_python_lint() { "$root/.venv/bin/ruff" check --quiet "$root"; }
check_python_format() { "$root/.venv/bin/ruff" format --check "$root"; }
check_python_types() { (cd "$root/python" && "$root/.venv/bin/mypy" --no-error-summary); }
check_shell() { shellcheck "$root"/scripts/*.sh "$root"/scripts/lib/*.sh "$root/.ci/run"; }
