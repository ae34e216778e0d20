#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# test.sh: sets up what is missing, builds, runs every test and check. Non-zero when one fails, or a runner ran none.

. "$(dirname "$0")/lib/common.sh"
. "$root/scripts/lib/packages.sh"
. "$root/scripts/lib/checks.sh"

passed=0
failed=0

# run_tests NAME COMMAND...: the command writes the JUnit report $report
run_tests() {
	local name=$1 counts good bad ok=1
	shift
	say "$name"
	rm -f "$report"
	"$@" || ok=0
	counts=$([[ -f $report ]] && "$root/.venv/bin/python" "$root/scripts/lib/count_tests.py" "$report") || counts="0 0"
	read -r good bad <<<"$counts"
	if ((good + bad == 0)); then say "$name: no test ran"; fi
	# A runner that fails without a failed test counts as one.
	if ((bad == 0 && (ok == 0 || good == 0))); then bad=1; fi
	passed=$((passed + good))
	failed=$((failed + bad))
}

# run_check NAME COMMAND...: counts as one test
run_check() {
	local name=$1
	shift
	say "$name"
	if ("$@"); then
		passed=$((passed + 1))
	else
		say "$name: failed"
		failed=$((failed + 1))
	fi
}

bash "$root/scripts/setup.sh"
install_packages clang-format-14 clang-tidy-14 shellcheck
cd "$root"
mkdir -p "$build_root/reports"
export -f tidy_unit cpp_files once checksum
export root build_root

run_check "format of C++" check_cpp_format
run_check "lint of Python" check_python_lint
run_check "format of Python" check_python_format
run_check "types of Python" check_python_types
run_check "lint of shell" check_shell
run_check "clang-tidy" check_cpp_tidy

report=$build_root/reports/cpp.xml
run_tests "C++ unit tests" ctest --preset tests --output-junit "$report"
# What opens windows mostly waits for them: it goes well beside builds, not beside tests that calculate.
apart=(tests/build_system tests/gui tests/meshlabserver)
report=$build_root/reports/python.xml
run_tests "tests in .venv" .venv/bin/python -m pytest -q --junitxml="$report" --numprocesses auto --dist loadfile \
	"${apart[@]/#/--ignore=}"
report=$build_root/reports/hosts.xml
run_tests "tests of builds and hosts" .venv/bin/python -m pytest -q --junitxml="$report" --numprocesses 3 --dist loadfile \
	"${apart[@]}"
report=$build_root/reports/python-2022.2.xml
run_tests "tests in .venv-2022.2" .venv-2022.2/bin/python -m pytest -q --junitxml="$report" tests/pymeshlab

echo "$passed passed, $failed failed"
((failed == 0))
