# SPDX-License-Identifier: GPL-3.0-or-later
# Warnings.cmake: the warnings that our own targets are held to; a compiler other than GCC and Clang keeps its defaults.

option(DEVELOPABLE_WARNINGS_AS_ERRORS "Stop the build at a warning in our own code" ON)

function(developable_warnings target)
	if(NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
		return()
	endif()
	target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow)
	if(DEVELOPABLE_WARNINGS_AS_ERRORS)
		target_compile_options(${target} PRIVATE -Werror)
	endif()
endfunction()
