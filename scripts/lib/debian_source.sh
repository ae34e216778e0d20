# SPDX-License-Identifier: GPL-3.0-or-later
# debian_source.sh: source tarballs out of the packages that Debian keeps, each pinned by its sha256.
#
# They are fetched with apt from the archive that the machine itself uses: a private apt configuration names that archive's
# sources, so that the system's own is not touched.

# archive_addresses: of the archives that the machine takes Debian itself from. apt knows its own sources, in whatever
# format they are written, and prints them even before the first update.
archive_addresses() {
	local codename
	codename=$(. /etc/os-release && printf '%s' "$VERSION_CODENAME")
	apt-get update --print-uris |
		sed -nE "s#^'(.*)/dists/($codename|stable|oldstable)/InRelease' .*#\1#p" | awk '!seen[$0]++'
}

# private_apt FOLDER COMMAND...: an apt command that knows only the sources in FOLDER/sources.list. An old index will do: the
# tarball in it is pinned.
private_apt() {
	local folder=$1 command=$2
	shift 2
	"$command" -q -o Dir::Etc::sourcelist="$folder/sources.list" -o Dir::Etc::sourceparts=/dev/null \
		-o Dir::State::lists="$folder/lists" -o Dir::Cache="$folder/cache" -o APT::Sandbox::User=root \
		-o Acquire::Check-Valid-Until=false -o Acquire::Check-Date=false "$@"
}

# source_version FOLDER PACKAGE SHA256: the version of the source package that the tarball belongs to; nothing when unknown
source_version() {
	private_apt "$1" apt-cache showsrc "$2" 2>/dev/null |
		awk -v sha256="$3" '/^Version: / { version = $2 } $1 == sha256 { print version; exit }'
}

# fetch_tarball PACKAGE SHA256 FOLDER SUITE...: leaves the package's tarball in FOLDER; the suites are those that have it
fetch_tarball() {
	local package=$1 sha256=$2 folder=$3 keyring=/usr/share/keyrings/debian-archive-keyring.gpg
	local archive suite version option=""
	shift 3
	if [[ -f $keyring ]]; then option="[signed-by=$keyring] "; fi
	mkdir -p "$folder"/{lists,cache/archives}/partial
	for archive in $(archive_addresses); do
		for suite in "$@"; do
			echo "deb-src $option$archive $suite main" >"$folder/sources.list"
			if ! private_apt "$folder" apt-get update >"$folder/log" 2>&1; then continue; fi
			version=$(source_version "$folder" "$package" "$sha256")
			if [[ -z $version ]]; then continue; fi
			if (cd "$folder" && private_apt "$folder" apt-get source --tar-only "$package=$version" >>log 2>&1) &&
				sha256sum --status -c <<<"$sha256  $(ls "$folder/$package"_*.orig.tar.*)"; then
				return
			fi
		done
	done
	if [[ -f $folder/log ]]; then cat "$folder/log" >&2; fi
	return 1
}
