# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# ninja reference: pages of all headers in reference/html of the build folder, by Doxygen. It fails on
# every warning, and where something that is installed has no documentation.

find_program(ORTHOGONAL_SLICES_DOXYGEN doxygen)
mark_as_advanced(ORTHOGONAL_SLICES_DOXYGEN)
if (NOT ORTHOGONAL_SLICES_DOXYGEN)
  return ()
endif ()

set(_reference "${CMAKE_BINARY_DIR}/reference")
file(MAKE_DIRECTORY "${_reference}")

# The public headers by themselves, strictly; XML instead of pages.
set(_doxygen_input "Filters/vtkOrthogonalSliceReconstruction.h Filters/vtkOrthogonalSlicer.h")
set(_doxygen_extract_all NO)
set(_doxygen_html NO)
set(_doxygen_xml YES)
configure_file("${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in" "${_reference}/Doxyfile.public" @ONLY)
# All headers, with pages.
set(_doxygen_input "Filters")
set(_doxygen_extract_all YES)
set(_doxygen_html YES)
set(_doxygen_xml NO)
configure_file("${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in" "${_reference}/Doxyfile.all" @ONLY)

add_custom_target(reference
  COMMAND "${ORTHOGONAL_SLICES_DOXYGEN}" "${_reference}/Doxyfile.public"
  COMMAND "${ORTHOGONAL_SLICES_DOXYGEN}" "${_reference}/Doxyfile.all"
  WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
  COMMENT "Making the reference in ${_reference}/html"
  VERBATIM)
