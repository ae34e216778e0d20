# SPDX-License-Identifier: GPL-3.0-or-later
# stage.sh: Debian's MeshLab 2020.09 with our plugin in it, in build/stage, the system's own left alone.

. "$root/scripts/lib/packages.sh"

stage=$build_root/stage

# MeshLab looks for its libraries, plugins and shaders beside its own program, wherever a link to it lies: so the programs
# are copied, and all else is links.
make_stage() {
	local library folder
	library=$(dirname "$(dpkg -L meshlab | grep '/libmeshlab-common\.so$')")
	folder=$stage/${library#/usr/}
	rm -rf "$stage"
	mkdir -p "$stage/bin" "$folder/plugins" "$stage/share"
	cp /usr/bin/meshlab /usr/bin/meshlabserver "$stage/bin/"
	ln -s "$library"/*.so "$folder/"
	ln -s "$library"/plugins/*.so "$folder/plugins/"
	ln -s /usr/share/meshlab "$stage/share/"
	ln -s "$build_root/meshlab-2020.09/libfilter_developable.so" "$folder/plugins/"
}

# provide_stage: sets up what is missing of it
provide_stage() {
	bash "$root/scripts/setup.sh" meshlab-2020.09 >&2
	alone "$build_root/.stage.lock" once "$stage/.complete" "$(dpkg-query -W -f '${Version}' meshlab) $root" make_stage
}

# run_staged PROGRAM [ARGS]: sets up what is missing and becomes the program, on a virtual display where it has to
run_staged() {
	local program=$1
	shift
	provide_stage
	if [[ $program == meshlabserver && -z ${DISPLAY:-} ]]; then
		exec xvfb-run -a "$stage/bin/$program" "$@"
	fi
	exec "$stage/bin/$program" "$@"
}
