# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Help pages with pictures. paraview_add_plugin() has two functions of ParaView make the pages of a
# plugin and their archive; these here take their place. They need Python and Qt's qhelpgenerator
# alone, which belongs to Debian's paraview-dev, where ParaView's own want xmlpatterns as well, which
# Qt 6 has no more. The archive is the same for Qt 5 and Qt 6.

# ParaView 5.13 asks for no pages where it was built with Qt 6, as its own need tools of Qt 5. It hears
# the true version below, when it has asked.
set(_help_qt "${PARAVIEW_QT_MAJOR_VERSION}")
set(PARAVIEW_QT_MAJOR_VERSION 5)

# With Qt 6, something has to let ParaView take the pages: pqWritableHelp.h. Debian: qt6-tools-dev.
set(_help_interfaces)
set(_help_sources)
if (_help_qt EQUAL 6)
  find_package(Qt6 QUIET COMPONENTS Core Widgets Help)
  if (Qt6_FOUND)
    paraview_plugin_add_auto_start(
      CLASS_NAME pqWritableHelp
      INTERFACES _help_interfaces
      SOURCES    _help_sources)
    list(APPEND _help_sources Help/pqWritableHelp.cxx Help/pqWritableHelp.h)
    include_directories("${CMAKE_CURRENT_LIST_DIR}")
  else ()
    message(STATUS "ParaView's help button will not find the plugin's pages: that takes Qt6Help")
  endif ()
endif ()

# Has the plugin linked with the libraries of ParaView's widgets themselves. Their targets want the
# headers of all that they are linked with in turn, down to boost and HDF5.
function (link_help plugin)
  get_target_property(_libraries "${plugin}" LINK_LIBRARIES)
  list(TRANSFORM _libraries REPLACE "^ParaView::pq[A-Za-z]+$" "$<TARGET_FILE:\\0>")
  list(TRANSFORM _libraries REPLACE "^Qt6::Core$" "Qt6::Help")
  set_property(TARGET "${plugin}" PROPERTY LINK_LIBRARIES "${_libraries}")
endfunction ()

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
  set(PARAVIEW_QT_MAJOR_VERSION "${_help_qt}" PARENT_SCOPE)
endfunction ()
