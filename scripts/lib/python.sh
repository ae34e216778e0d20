# SPDX-License-Identifier: GPL-3.0-or-later
# python.sh: the Python environments: .venv (pymeshlab 2025.7, and the tools) and .venv-2022.2.

# find_python: prints a Python 3.11 that can make environments
find_python() {
	local candidate
	for candidate in python3.11 python3 /usr/bin/python3.11; do
		if "$candidate" -c 'import sys, venv, ensurepip; sys.exit(sys.version_info[:2] != (3, 11))' 2>/dev/null; then
			"$candidate" -c 'import sys; print(sys.executable)'
			return
		fi
	done
	return 1
}

# make_environment FOLDER
make_environment() {
	local folder=$1 python
	python=$(find_python) || { install_packages python3.11-venv && python=$(find_python); } ||
		fail "no Python 3.11 with the venv module was found"
	say "making $(basename "$folder")"
	"$python" -m venv --clear "$folder"
}

# install_requirements FOLDER REQUIREMENTS: what is imported is compiled then, which is little of all there is
install_requirements() {
	"$1/bin/python" -m pip install --quiet --disable-pip-version-check --no-compile -r "$2"
}

# install_package FOLDER: our own package, such that an edit of it shows at once. Without pip's build isolation, which would
# fetch what only a wheel's build needs.
install_package() {
	"$1/bin/python" -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation -e "$root/python"
}

# provide_environment FOLDER REQUIREMENTS: what other requirements have put there stays, until any of them change
provide_environment() {
	local folder=$1 requirements=$2 key
	key="$(checksum "$root"/python/requirements-*.txt) $root"
	once "$folder/.environment" "$key" make_environment "$folder"
	once "$folder/.$(basename "$requirements")" "$key" install_requirements "$folder" "$requirements"
	once "$folder/.package" "$(checksum "$root/python/pyproject.toml") $root" install_package "$folder"
}
