#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# setup.sh [TARGET...]: installs what is missing and builds the targets, all of them when none is named.
# A target is a host, whose plugin becomes build/HOST/libfilter_developable.so, or `tests`, the C++ unit tests.
# Two other targets are demo, which is pymeshlab-2025.7 without what only tests need of .venv, and wheel, the plugin for
# python/hatch_build.py, which names its host's library. What all of them link, the library of vcg_ext, is built first.
# A second run finds everything in place and ends in seconds.

. "$(dirname "$0")/lib/common.sh"
. "$root/scripts/lib/packages.sh"
. "$root/scripts/lib/debian_source.sh"
. "$root/scripts/lib/headers.sh"
. "$root/scripts/lib/cholmod.sh"
. "$root/scripts/lib/python.sh"

all_targets=(meshlab-2020.09 pymeshlab-2022.2 pymeshlab-2025.7 meshlab-2025.07 tests)

build_packages=(g++ cmake ninja-build libeigen3-dev libcgal-dev qtbase5-dev libqt5opengl5-dev libgl-dev libglew-dev)
# What the stock programs and the wheels expect of a desktop.
run_packages=(libgl1 libglu1-mesa libegl1 libopengl0 libxrender1 libxcursor1 libfontconfig1)
# Of the tests of windows, of pages and of faults.
test_packages=(libgtest-dev xvfb openbox xdotool chromium chromium-driver strace)

# provide_library: what vcg_ext itself is compiled with, and all builds share
provide_library() {
	install_packages "${build_packages[@]}"
	provide_headers 2025.07
	provide_cholmod
}

# provide_host TARGET: what a target needs besides
provide_host() {
	case $1 in
	meshlab-2020.09)
		install_packages meshlab xvfb xauth libgl1-mesa-dri
		provide_headers 2020.09
		;;
	pymeshlab-2022.2)
		install_packages "${run_packages[@]}"
		provide_environment "$root/.venv-2022.2" "$root/python/requirements-2022.2.txt"
		provide_headers 2022.02
		;;
	pymeshlab-2025.7)
		install_packages "${run_packages[@]}"
		provide_environment "$root/.venv" "$root/python/requirements-dev.txt"
		;;
	demo)
		install_packages "${run_packages[@]}"
		provide_environment "$root/.venv" "$root/python/requirements-demo.txt"
		;;
	meshlab-2025.07) ;;
	wheel)
		install_packages "${run_packages[@]}"
		;;
	tests)
		install_packages "${test_packages[@]}"
		;;
	*)
		fail "'$1' is no target; the targets are: ${all_targets[*]}"
		;;
	esac
}

configure() { (cd "$root" && cmake --preset "$1" >"$build_root/$1.log") || fail "configuring $1 failed"; }

# build TARGET: Ninja itself sees what is out of date
build() {
	once "$build_root/$1/.configured" "$(checksum "$root/CMakePresets.json") $root ${DEVELOPABLE_HOST_LIBRARY:-}" configure "$1"
	say "building $1"
	cmake --build "$build_root/$1" -j "$(nproc)" -- --quiet 2>&1 | sed '/^ninja: no work to do/d; /^-- /d'
}

targets=("$@")
if ((${#targets[@]} == 0)); then targets=("${all_targets[@]}"); fi
provide_library
alone "$build_root/.library.lock" build library & # what targets need besides is fetched meanwhile
library=$!
trap wait EXIT
for target in "${targets[@]}"; do provide_host "$target"; done
wait "$library"
for target in "${targets[@]/#demo/pymeshlab-2025.7}"; do alone "$build_root/.$target.lock" build "$target"; done
