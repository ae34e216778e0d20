# SPDX-License-Identifier: GPL-3.0-or-later
# packages.sh: Debian packages, installed only where they are missing.

as_root() {
	if ((EUID == 0)); then
		"$@"
	elif command -v sudo >/dev/null; then
		sudo "$@"
	else
		fail "this needs root: $*"
	fi
}

# missing_packages NAME...: those that are not installed, one a line
missing_packages() {
	comm -23 <(printf '%s\n' "$@" | sort -u) \
		<(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^installed //p' | sort -u)
}

# install_packages NAME...: with DEVELOPABLE_INSTALL=never only says what is missing
install_packages() {
	local missing
	mapfile -t missing < <(missing_packages "$@")
	if ((${#missing[@]} == 0)); then return; fi
	if [[ ${DEVELOPABLE_INSTALL:-} == never ]]; then
		fail "these packages of the system are missing, by their names in Debian: ${missing[*]}; install them first"
	fi
	say "installing Debian packages: ${missing[*]}"
	# Another source of the machine's may fail without harm: whether ours are there shows in the installation.
	as_root apt-get -q update >/dev/null || true
	as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends \
		-o DPkg::Lock::Timeout=600 -o Dpkg::Use-Pty=0 install "${missing[@]}" >/dev/null
}
