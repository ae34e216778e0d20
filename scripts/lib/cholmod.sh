# SPDX-License-Identifier: GPL-3.0-or-later
# cholmod.sh: CHOLMOD with METIS as a static library that a plugin takes in whole, so that it stays one file.
#
# Debian's own static archives are not compiled for shared objects, so its sources are compiled once more. The library and
# CHOLMOD's headers end in $cache_root/cholmod.

suitesparse_sha256=bb106c43049138c19675cd70322e72ff8e4fd8bdcab3a096307fd78488913faf
metis_sha256=c50a88b92b01fa3972c5c92cf50117f126c62589b8f793657c7d865c59c23615

# build_cholmod FOLDER: from sources to $cache_root/cholmod, by way of FOLDER
build_cholmod() {
	local folder=$1 libraries=(SuiteSparse_config AMD COLAMD CAMD CCOLAMD CHOLMOD)
	if ! fetch_tarball suitesparse "$suitesparse_sha256" "$folder" bookworm ||
		! fetch_tarball metis "$metis_sha256" "$folder" bookworm; then
		fail "the sources of SuiteSparse and METIS were not found in Debian's bookworm."
	fi
	mkdir "$folder"/{suitesparse,metis}
	tar -xf "$folder"/suitesparse_*.orig.tar.* -C "$folder/suitesparse" --strip-components=1 --wildcards \
		"${libraries[@]/#/*/}"
	tar -xf "$folder"/metis_*.orig.tar.* -C "$folder/metis" --strip-components=1
	cmake -S "$root/cmake/cholmod" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
		-DCHOLMOD_SOURCES="$folder" -DCMAKE_INSTALL_PREFIX="$folder/kept" >"$folder/log"
	if ! cmake --build "$folder/build" --target install -j "$(nproc)" >>"$folder/log"; then
		cat "$folder/log" >&2
		fail "compiling CHOLMOD failed"
	fi
	rm -rf "$cache_root/cholmod"
	mv -T "$folder/kept" "$cache_root/cholmod"
}

# provide_cholmod
provide_cholmod() {
	local key folder
	key=$(checksum "$root"/cmake/cholmod/*)
	if [[ -f $cache_root/cholmod/key && $(<"$cache_root/cholmod/key") == "$key" ]]; then return; fi
	say "compiling CHOLMOD"
	install_packages xz-utils
	mkdir -p "$cache_root"
	folder=$(mktemp -d "$cache_root/fetching.XXXXXX")
	(
		trap 'rm -rf "$folder"' EXIT
		build_cholmod "$folder"
		echo "$key" >"$cache_root/cholmod/key"
	)
}
