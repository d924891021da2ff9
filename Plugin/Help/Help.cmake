# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Help pages with pictures. paraview_add_plugin() has two functions of ParaView make the pages of a
# plugin and their archive; these here take their place. They need Python and Qt's qhelpgenerator
# alone, which belongs to Debian's paraview-dev, where ParaView's own want xmlpatterns as well, which
# Qt 6 has no more. The archive is the same for Qt 5 and Qt 6.

# ParaView 5.13 asks for no pages where it was built with Qt 6, as its own need tools of Qt 5. The
# plugin has nothing else of Qt.
set(PARAVIEW_QT_MAJOR_VERSION 5)

set(_help_source "${CMAKE_CURRENT_LIST_DIR}")

# The pages are made together with their archive, below.
function (paraview_client_documentation)
  cmake_parse_arguments(_doc "" "TARGET;OUTPUT_DIR" "XMLS" ${ARGN})
  set_property(GLOBAL PROPERTY orthogonal_slices_help_xmls "${_doc_XMLS}")
  add_custom_target("${_doc_TARGET}")
endfunction ()

function (paraview_client_generate_help)
  cmake_parse_arguments(_help ""
    "NAME;TARGET;OUTPUT_DIR;OUTPUT_PATH;TABLE_OF_CONTENTS" "DEPENDS;PATTERNS" ${ARGN})
  get_property(_xmls GLOBAL PROPERTY orthogonal_slices_help_xmls)
  list(TRANSFORM _xmls PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/"
    REGEX "^[^/]")
  set(_pictures "${PROJECT_SOURCE_DIR}/Plugin/Pictures")
  file(GLOB _picture_files "${_pictures}/*.png")
  set(_archive "${_help_OUTPUT_DIR}/${_help_NAME}.qch")
  add_custom_command(
    OUTPUT  "${_archive}"
    COMMAND "${Python3_EXECUTABLE}" "${_help_source}/MakeHelp.py"
            "${_help_NAME}" "${_help_OUTPUT_DIR}" "${_pictures}" ${_xmls}
    COMMAND "${ORTHOGONAL_SLICES_QHELPGENERATOR}" "${_help_OUTPUT_DIR}/${_help_NAME}.qhp"
            -s -o "${_archive}"
    DEPENDS "${_help_source}/MakeHelp.py" ${_xmls} ${_picture_files}
    COMMENT "Making the help pages of ${_help_NAME}"
    VERBATIM)
  add_custom_target("${_help_TARGET}" DEPENDS "${_archive}")
  set("${_help_OUTPUT_PATH}" "${_archive}" PARENT_SCOPE)
endfunction ()
