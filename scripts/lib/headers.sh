# SPDX-License-Identifier: GPL-3.0-or-later
# headers.sh: the hosts' headers, out of the source packages that Debian keeps of MeshLab.
#
# Debian ships MeshLab without headers, but its source tarballs have them, vcglib included. They are fetched with apt from
# the archive that the machine itself uses: a private apt configuration names that archive's sources, so that the system's
# own is not touched. What is kept lies in $cache_root/meshlab-RELEASE, laid out as in MeshLab's source tree.

# What is pinned of each release: the tarball's sha256, and the Debian suites that have or had it.
declare -A tarball_sha256=(
	[2020.09]=d6715352ff65caffdec0292858d4263eb0c3cbbf3b1e5c2e2bab218e3f234630
	[2022.02]=11da26ec46c3fbbbc806d410a3221542ec21ec13fdcc55d624304600029435fd
	[2025.07]=d22c98d362f2a284e481af8dbfc272b2222f5b9c67b3cf8bec57d1c3161886f4
)
declare -A tarball_suites=(
	[2020.09]="bookworm"
	[2022.02]="trixie"
	[2025.07]="sid forky"
)
# What is kept of a tree: what a plugin includes; of the newest release also what its own build system needs to take our
# plugin in (tests/build_system).
kept_paths=(ML_VERSION LICENSE.txt {src/,}vcglib/{vcg,wrap} src/common{,_gui})
build_system_paths=(CMakeLists.txt src/CMakeLists.txt src/cmake src/external src/vcglib/CMakeLists.txt)

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

# source_version FOLDER SHA256: the version of the source package meshlab that the tarball belongs to; nothing when unknown
source_version() {
	private_apt "$1" apt-cache showsrc meshlab 2>/dev/null |
		awk -v sha256="$2" '/^Version: / { version = $2 } $1 == sha256 { print version; exit }'
}

# fetch_tarball RELEASE FOLDER: leaves the release's tarball in FOLDER
fetch_tarball() {
	local release=$1 folder=$2 sha256=${tarball_sha256[$1]} keyring=/usr/share/keyrings/debian-archive-keyring.gpg
	local archive suite version option=""
	if [[ -f $keyring ]]; then option="[signed-by=$keyring] "; fi
	mkdir -p "$folder"/{lists,cache/archives}/partial
	for archive in $(archive_addresses); do
		for suite in ${tarball_suites[$release]}; do
			echo "deb-src $option$archive $suite main" >"$folder/sources.list"
			if ! private_apt "$folder" apt-get update >"$folder/log" 2>&1; then continue; fi
			version=$(source_version "$folder" "$sha256")
			if [[ -z $version ]]; then continue; fi
			if (cd "$folder" && private_apt "$folder" apt-get source --tar-only "meshlab=$version" >>log 2>&1) &&
				sha256sum --status -c <<<"$sha256  $(ls "$folder"/*.orig.tar.*)"; then
				return
			fi
		done
	done
	if [[ -f $folder/log ]]; then cat "$folder/log" >&2; fi
	fail "the source of MeshLab $release was not found in Debian's ${tarball_suites[$release]// /, } (sha256 $sha256)." \
		"Unpack it into $cache_root/meshlab-$release yourself, and run again."
}

# unpack_headers RELEASE FOLDER: what a plugin needs of the tarball in FOLDER, to its place in the cache
unpack_headers() {
	local release=$1 folder=$2 name names=("${kept_paths[@]}")
	if [[ $release == 2025.07 ]]; then names+=("${build_system_paths[@]}"); fi
	mkdir "$folder/tree"
	tar -xf "$folder"/*.orig.tar.* -C "$folder/tree" --strip-components=1
	mkdir "$folder/kept"
	for name in "${names[@]}"; do
		if [[ -e $folder/tree/$name ]]; then
			mkdir -p "$(dirname "$folder/kept/$name")"
			mv "$folder/tree/$name" "$folder/kept/$name"
		fi
	done
	# Another set-up may have been quicker.
	mv -T "$folder/kept" "$cache_root/meshlab-$release" || [[ -f $cache_root/meshlab-$release/ML_VERSION ]]
}

# provide_headers RELEASE
provide_headers() {
	if [[ -f $cache_root/meshlab-$1/ML_VERSION ]]; then return; fi
	say "fetching the headers of MeshLab $1"
	install_packages xz-utils
	mkdir -p "$cache_root"
	local folder
	folder=$(mktemp -d "$cache_root/fetching.XXXXXX")
	(
		trap 'rm -rf "$folder"' EXIT
		fetch_tarball "$1" "$folder"
		unpack_headers "$1" "$folder"
	)
}
