# SPDX-License-Identifier: GPL-3.0-or-later
# MeshLabHost.cmake: a host's headers, library, version and precision, as two targets:
#   vcglib         vcglib's headers, always there (MeshLab's own build has a target of that name too)
#   MeshLab::host  what a plugin for the chosen host compiles and links with; absent when none is chosen
#
# MeshLab's loaders compare version and precision, so a plugin serves exactly one version of MeshLab.

set(DEVELOPABLE_HOSTS meshlab-2020.09 pymeshlab-2022.2 pymeshlab-2025.7 meshlab-2025.07)
set(DEVELOPABLE_HOST "" CACHE STRING "The host that the plugin is built for; empty: no plugin")
set_property(CACHE DEVELOPABLE_HOST PROPERTY STRINGS ${DEVELOPABLE_HOSTS})
set(DEVELOPABLE_HOST_LIBRARY "" CACHE FILEPATH "The host's meshlab-common library, where it is not found by itself")
set(MESHLAB_SOURCE_DIR "" CACHE PATH "A MeshLab source tree to build the plugin against")
option(MESHLAB_BUILD_WITH_DOUBLE_SCALAR "The MeshLab of MESHLAB_SOURCE_DIR is built with double scalars" OFF)

if(DEFINED ENV{XDG_CACHE_HOME})
	set(user_cache $ENV{XDG_CACHE_HOME})
else()
	set(user_cache $ENV{HOME}/.cache)
endif()
set(DEVELOPABLE_HEADER_CACHE ${user_cache}/developable CACHE PATH "Where scripts/setup.sh keeps the hosts' headers")

# What is known of each host. A host without a library leaves MeshLab's symbols undefined, as a module may: the running
# MeshLab has them.
set(wheel_library lib/python3*/site-packages/pymeshlab/lib/libmeshlab-common.so)
set(host_library_pattern "")
if(MESHLAB_SOURCE_DIR)
	file(STRINGS ${MESHLAB_SOURCE_DIR}/ML_VERSION host_release LIMIT_COUNT 1)
	if(MESHLAB_BUILD_WITH_DOUBLE_SCALAR)
		set(host_scalar double)
	else()
		set(host_scalar float)
	endif()
elseif(DEVELOPABLE_HOST STREQUAL "meshlab-2020.09")
	set(host_release 2020.09)
	set(host_scalar float)
	set(host_library_pattern /usr/lib/*/meshlab/libmeshlab-common.so)
elseif(DEVELOPABLE_HOST STREQUAL "pymeshlab-2022.2")
	set(host_release 2022.02)
	set(host_scalar double)
	set(host_library_pattern ${PROJECT_SOURCE_DIR}/.venv-2022.2/${wheel_library})
elseif(DEVELOPABLE_HOST STREQUAL "pymeshlab-2025.7")
	set(host_release 2025.07)
	set(host_scalar double)
	set(host_library_pattern ${PROJECT_SOURCE_DIR}/.venv/${wheel_library})
elseif(DEVELOPABLE_HOST STREQUAL "meshlab-2025.07" OR NOT DEVELOPABLE_HOST)
	set(host_release 2025.07)
	set(host_scalar float)
else()
	message(FATAL_ERROR "DEVELOPABLE_HOST is '${DEVELOPABLE_HOST}'; it must be one of: ${DEVELOPABLE_HOSTS}.")
endif()

# The headers: the user's source tree, or the part of one that set-up keeps. vcglib lies beside src/ until 2020.09.
if(MESHLAB_SOURCE_DIR)
	set(host_tree ${MESHLAB_SOURCE_DIR})
else()
	set(host_tree ${DEVELOPABLE_HEADER_CACHE}/meshlab-${host_release})
endif()
find_path(host_vcglib vcg/complex/complex.h PATHS ${host_tree}/src/vcglib ${host_tree}/vcglib NO_CACHE NO_DEFAULT_PATH)
if(NOT host_vcglib OR NOT EXISTS ${host_tree}/src/common)
	message(FATAL_ERROR "There are no MeshLab ${host_release} headers in ${host_tree}: run `scripts/setup.sh ${DEVELOPABLE_HOST}`, "
		"or name a MeshLab source tree, with vcglib in it, as MESHLAB_SOURCE_DIR.")
endif()

find_package(Eigen3 REQUIRED NO_MODULE)
add_library(vcglib INTERFACE)
target_include_directories(vcglib SYSTEM INTERFACE ${host_vcglib})
target_link_libraries(vcglib INTERFACE Eigen3::Eigen)

if(NOT DEVELOPABLE_HOST AND NOT MESHLAB_SOURCE_DIR)
	return()
endif()

if(host_library_pattern AND NOT DEVELOPABLE_HOST_LIBRARY)
	file(GLOB host_library ${host_library_pattern})
	if(NOT host_library)
		message(FATAL_ERROR "There is no ${host_library_pattern}: run `scripts/setup.sh ${DEVELOPABLE_HOST}`, "
			"or give the path of the host's meshlab-common library as DEVELOPABLE_HOST_LIBRARY.")
	endif()
else()
	set(host_library ${DEVELOPABLE_HOST_LIBRARY})
endif()

# The double builds of MeshLab carry a d behind their version.
set(host_version ${host_release})
if(host_scalar STREQUAL "double")
	string(APPEND host_version d)
endif()

find_package(Qt5 REQUIRED COMPONENTS Core Gui Widgets Xml OpenGL Network)
add_library(MeshLab::host INTERFACE IMPORTED)
set_target_properties(MeshLab::host PROPERTIES MESHLAB_RELEASE ${host_release})
target_include_directories(MeshLab::host INTERFACE ${host_tree}/src)
target_compile_definitions(MeshLab::host INTERFACE
	MESHLAB_VERSION=${host_version} MESHLAB_SCALAR=${host_scalar} QT_PLUGIN)
target_link_libraries(MeshLab::host INTERFACE
	vcglib ${host_library} Qt5::Core Qt5::Gui Qt5::Widgets Qt5::Xml Qt5::OpenGL Qt5::Network)

message(STATUS "Host: MeshLab ${host_version}, ${host_scalar}, headers in ${host_tree}")
