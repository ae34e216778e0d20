# SPDX-License-Identifier: GPL-3.0-or-later
# headers.sh: the hosts' headers, out of the source packages that Debian keeps of MeshLab.
#
# Debian ships MeshLab without headers, but its source tarballs have them, vcglib included. What is kept lies in
# $cache_root/meshlab-RELEASE, laid out as in MeshLab's source tree.

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
		read -ra suites <<<"${tarball_suites[$1]}"
		fetch_tarball meshlab "${tarball_sha256[$1]}" "$folder" "${suites[@]}" ||
			fail "the source of MeshLab $1 was not found in Debian's ${tarball_suites[$1]// /, } (sha256 ${tarball_sha256[$1]})." \
				"Unpack it into $cache_root/meshlab-$1 yourself, and run again."
		unpack_headers "$1" "$folder"
	)
}
