# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -DBUILD=... -DPREFIX=... -P TestUninstall.cmake: removes what was installed in PREFIX, and
# fails if a file or a folder of the project's own is left there.
cmake_minimum_required(VERSION 3.22)

file(GLOB_RECURSE _before "${PREFIX}/*")
list(LENGTH _before _count)
if (_count LESS 10)
  message(FATAL_ERROR "only ${_count} files are installed in ${PREFIX}")
endif ()
execute_process(
  COMMAND "${CMAKE_COMMAND}" -P "${BUILD}/Uninstall.cmake"
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE _after LIST_DIRECTORIES true "${PREFIX}/*")
foreach (_path IN LISTS _after)
  if (NOT IS_DIRECTORY "${_path}" OR _path MATCHES "rthogonal-?[Ss]lices")
    message(SEND_ERROR "left behind: ${_path}")
  endif ()
endforeach ()
