# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# What is installed beside libraries, and Debian packages of it all: cpack in the build folder, split
# as Debian does. Included by the project's CMakeLists.txt when everything else is declared.
#
#   component    package
#   runtime      libvtkfiltersorthogonalslices<soversion>   the library
#   development  libvtkfiltersorthogonalslices-dev          headers, CMake package
#   python       python3-orthogonalslices                   Python package, examples with data
#   plugin       paraview-orthogonalslices                  ParaView's plugin; ParaView lists and loads it
#
# With plain VTK there is no plugin, and the other packages go with Debian's VTK. As Debian's ParaView
# has a VTK of its own, the version says which one they were built with.

set(_documentation "${CMAKE_INSTALL_DATAROOTDIR}/doc/orthogonalslices")
install(FILES LICENSE README.md CHANGELOG.md CITATION.cff
  DESTINATION "${_documentation}" COMPONENT runtime)
install(DIRECTORY Plugin/Examples
  DESTINATION "${_documentation}" COMPONENT python
  PATTERN "__pycache__" EXCLUDE
  PATTERN "make-pictures.sh" EXCLUDE)
if (ORTHOGONAL_SLICES_BUILD_PLUGIN)
  install(DIRECTORY Plugin/Macros
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/orthogonalslices" COMPONENT plugin)
  if (ORTHOGONAL_SLICES_PLUGIN_HELP)
    # The pages for a browser, too.
    install(DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/Plugin/paraview_help/"
      DESTINATION "${_documentation}/Help" COMPONENT plugin
      FILES_MATCHING PATTERN "*.html" PATTERN "*.png")
  endif ()
endif ()
# A source archive for Python comes without data.
if (EXISTS "${PROJECT_SOURCE_DIR}/Data/heart")
  file(GLOB _contours "${PROJECT_SOURCE_DIR}/Data/heart/n32_*.vtp")
  install(FILES ${_contours} Data/licences/SimVascular.txt
    DESTINATION "${_documentation}/Examples/heart" COMPONENT python)
endif ()

#--------------------------------------------------------------------------------------------------
# ninja uninstall: what the last installation has written, and folders that are empty then.
file(CONFIGURE
  OUTPUT  "${CMAKE_BINARY_DIR}/Uninstall.cmake"
  CONTENT [==[
file(STRINGS "@CMAKE_BINARY_DIR@/install_manifest.txt" files)
foreach (file IN LISTS files)
  file(REMOVE "$ENV{DESTDIR}${file}")
  cmake_path(GET file PARENT_PATH folder)
  # Each folder after those in it; the prefix and what is not empty stay.
  while (folder MATCHES "/(OrthogonalSlices|orthogonalslices|Formats|Examples|Help|Macros|heart)(/|$)")
    file(GLOB entries "$ENV{DESTDIR}${folder}/*")
    if (entries)
      break ()
    endif ()
    file(REMOVE_RECURSE "$ENV{DESTDIR}${folder}")
    cmake_path(GET folder PARENT_PATH folder)
  endwhile ()
endforeach ()
list(LENGTH files count)
message(STATUS "Removed ${count} files")
]==]
  @ONLY)
add_custom_target(uninstall
  COMMAND "${CMAKE_COMMAND}" -P "${CMAKE_BINARY_DIR}/Uninstall.cmake"
  COMMENT "Removing what was installed"
  VERBATIM)

#--------------------------------------------------------------------------------------------------
# Names and texts of the packages.
find_program(ORTHOGONAL_SLICES_DPKG dpkg)
find_program(ORTHOGONAL_SLICES_GZIP gzip)
mark_as_advanced(ORTHOGONAL_SLICES_DPKG ORTHOGONAL_SLICES_GZIP)
if (NOT ORTHOGONAL_SLICES_DPKG OR NOT ORTHOGONAL_SLICES_GZIP)
  return ()
endif ()

set(_components runtime development)
if (ORTHOGONAL_SLICES_WRAP_PYTHON)
  list(APPEND _components python)
endif ()
if (ORTHOGONAL_SLICES_BUILD_PLUGIN)
  list(APPEND _components plugin)
endif ()
set(_runtime_package "libvtkfiltersorthogonalslices${ORTHOGONAL_SLICES_SOVERSION}")
set(_development_package "libvtkfiltersorthogonalslices-dev")
set(_python_package "python3-orthogonalslices")
set(_plugin_package "paraview-orthogonalslices")
if (ORTHOGONAL_SLICES_USE_PARAVIEW)
  set(_flavour "paraview${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
  set(_vtk_development "paraview-dev")
  set(_vtk_python "python3-paraview")
else ()
  set(_flavour "vtk${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}")
  set(_vtk_development "libvtk9-dev")
  set(_vtk_python "python3-vtk9")
endif ()
set(_version "${PROJECT_VERSION}-1+${_flavour}")

# Of each package licences and changes, where Debian has them. Who makes packages for others says who
# they are as Debian's tools want it, by DEBFULLNAME and DEBEMAIL.
set(_maintainer "the Orthogonal Slices contributors <orthogonalslices@localhost>")
if (NOT "$ENV{DEBEMAIL}" STREQUAL "")
  set(_maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif ()
string(TIMESTAMP _date "%a, %d %b %Y %H:%M:%S +0000" UTC) # that of SOURCE_DATE_EPOCH, if there is one
file(READ LICENSE _licence)
string(FIND "${_licence}" "Redistribution" _start)
string(SUBSTRING "${_licence}" ${_start} -1 _licence)
string(STRIP "${_licence}" _licence)
string(REGEX REPLACE "\n\n" "\n.\n" _licence "${_licence}")
string(REPLACE "\n" "\n " _licence "${_licence}")
set(_packages "${CMAKE_BINARY_DIR}/Packages")
configure_file("${CMAKE_CURRENT_LIST_DIR}/copyright.in" "${_packages}/copyright" @ONLY)
configure_file("${CMAKE_CURRENT_LIST_DIR}/changelog.in" "${_packages}/changelog.Debian" @ONLY)
configure_file("${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${_packages}/changelog" COPYONLY)
foreach (_file IN ITEMS changelog changelog.Debian)
  execute_process(
    COMMAND     "${ORTHOGONAL_SLICES_GZIP}" -9nc "${_packages}/${_file}"
    OUTPUT_FILE "${_packages}/${_file}.gz"
    COMMAND_ERROR_IS_FATAL ANY)
endforeach ()
foreach (_component IN LISTS _components)
  install(
    FILES
      "${_packages}/copyright"
      "${_packages}/changelog.gz"
      "${_packages}/changelog.Debian.gz"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${_${_component}_package}"
    COMPONENT   "${_component}"
    EXCLUDE_FROM_ALL)
endforeach ()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME orthogonalslices)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
# CPack's default: any other summary would come before that of each package.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${CMAKE_PROJECT_NAME} built using CMake")
set(CPACK_PACKAGE_VENDOR "the Orthogonal Slices contributors")
set(CPACK_PACKAGE_CONTACT "${_maintainer}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL ${_components})
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_IGNORE_GROUPS ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_VERSION "${_version}")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# Dependencies on libraries are found by dpkg-shlibdeps; those on our own are said below.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")

function (orthogonal_slices_package component section summary text)
  string(TOUPPER "${component}" _upper)
  list(JOIN ARGN ", " _depends)
  foreach (_pair IN ITEMS
      "PACKAGE_NAME=${_${component}_package}"
      "PACKAGE_SECTION=${section}"
      "PACKAGE_DEPENDS=${_depends}"
      "PACKAGE_SHLIBDEPS=ON"
      "DESCRIPTION=${summary}\n${text}")
    string(REGEX MATCH "^[A-Z_]+" _name "${_pair}")
    string(REGEX REPLACE "^[A-Z_]+=" "" _value "${_pair}")
    set("CPACK_DEBIAN_${_upper}_${_name}" "${_value}" PARENT_SCOPE)
  endforeach ()
endfunction ()

set(_library "${_runtime_package} (= ${_version})")
orthogonal_slices_package(runtime libs
  "surfaces from orthogonal sets of planar contours: library"
  "VTK filters that make closed surfaces from contours on x-, y- and z-slices,\nand cut such contours from surfaces and images.")
orthogonal_slices_package(development libdevel
  "surfaces from orthogonal sets of planar contours: headers"
  "What programs in C++ are built with: headers, and the CMake package\nOrthogonalSlices."
  "${_library}" ${_vtk_development})
orthogonal_slices_package(python python
  "surfaces from orthogonal sets of planar contours: Python"
  "The Python package orthogonalslices: reconstruct() for arrays of NumPy, and\nthe classes of VTK. With examples that read the formats contours come in."
  "${_library}" "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR})"
  python3-numpy ${_vtk_python})
set(_plugin_depends "${_library}" paraview)
if (PARAVIEW_QT_MAJOR_VERSION EQUAL 6)
  list(APPEND _plugin_depends libqt6sql6-sqlite) # with which ParaView reads help pages
endif ()
orthogonal_slices_package(plugin science
  "surfaces from orthogonal sets of planar contours: ParaView's plugin"
  "Orthogonal Slice Reconstruction, Parallel Slice Reconstruction and Orthogonal\nSlicer in the menu of ParaView, which loads the plugin when it starts."
  ${_plugin_depends})
# No program is in it that would be linked.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)

#--------------------------------------------------------------------------------------------------
# Scripts of the packages. The linker learns of the library. ParaView loads what is in the folder
# plugins beside its program; Debian's has none, and that of another plugin may be there.
file(WRITE "${_packages}/triggers" "activate-noawait ldconfig\n")
# Programs that were linked with the library need this package, or a later one.
file(WRITE "${_packages}/shlibs" "libvtkFiltersOrthogonalSlices ${ORTHOGONAL_SLICES_SOVERSION} "
  "${_runtime_package} (>= ${_version})\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${_packages}/triggers" "${_packages}/shlibs")
if (ORTHOGONAL_SLICES_BUILD_PLUGIN)
  file(RELATIVE_PATH _plugin_link "/prefix/${CMAKE_INSTALL_BINDIR}/plugins"
    "/prefix/${CMAKE_INSTALL_LIBDIR}/${_plugin_subdirectory}/OrthogonalSlices/OrthogonalSlices.so")
  file(RELATIVE_PATH _macros_link "/prefix/${CMAKE_INSTALL_BINDIR}"
    "/prefix/${CMAKE_INSTALL_DATAROOTDIR}/orthogonalslices/Macros")
endif ()
foreach (_component IN ITEMS python plugin)
  string(TOUPPER "${_component}" _upper)
  foreach (_script IN ITEMS postinst prerm)
    if (_component IN_LIST _components)
      set(_file "${_packages}/${_component}/${_script}")
      configure_file("${CMAKE_CURRENT_LIST_DIR}/${_component}/${_script}.in" "${_file}" @ONLY
        FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
          GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
      list(APPEND "CPACK_DEBIAN_${_upper}_PACKAGE_CONTROL_EXTRA" "${_file}")
    endif ()
  endforeach ()
endforeach ()
include(CPack)
