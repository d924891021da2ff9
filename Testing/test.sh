#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash Testing/test.sh
# Builds the core without VTK, then the filters with plain VTK 9.1 and with ParaView's VTK, and the
# fuzzer; passes all tests at once, the long ones first. Build folders: build/core, build/vtk,
# build/paraview, build/fuzz.
#   Every test runs once, those whose outcome depends on VTK once with each:
#   build/core      units of the core, random solids, the direction of includes. There is no VTK in
#                   them; both builds of the filters link the objects that are tested here.
#   build/vtk       filters (ports, properties, messages, arrays, forms of input), Python, downstream
#                   projects, of which one compiles the core itself; and what needs VTK for reading
#                   and measuring only: the guarantees on all data sets, degenerate and shaken input,
#                   the sampling condition, the comparisons with other methods.
#   build/paraview  filters, Python and downstream projects once more, and the plugin. The rest is
#                   left out: it calls the same objects of the core with the same numbers.
#   build/fuzz      contours changed at random, from a fixed seed, with sanitizers.
#
# bash Testing/test.sh --sanitize
# Passes the tests of the core and of the filters with the address, undefined behaviour and thread
# sanitizers and plain VTK 9.1, which takes longer. Build folders: build/asan, build/tsan.
#
# bash Testing/test.sh --tidy
# Has clang-tidy look at the core, as .clang-tidy says. Build folder: build/tidy.
#
# bash Testing/test.sh --coverage
# Passes the tests of the core and says which lines of it they have passed through; fails if it is
# less than 95 % of them. Build folder: build/coverage, with one page for each file.
#
# Made for a bare Debian 12: installs what is missing.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source Testing/install-dependencies.sh
source Testing/configure.sh

configure_options=(-DCMAKE_COMPILE_WARNING_AS_ERROR=ON)
jobs=$(nproc)
library=lib/$(uname -m)-linux-gnu
vtk=$PWD/build/vtk9.1
vtk_dir=$vtk/usr/$library/cmake/vtk-9.1

configure_preset()
{
  local preset=$1
  shift
  configure "build/$preset" --preset "$preset" "$@"
}

# Plain VTK's libraries have other names than those of ParaView's VTK, and leave it alone.
with_plain_vtk()
{
  LD_LIBRARY_PATH="$vtk/usr/$library${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" "$@"
}

test_all()
{
  # clang with its runtime libraries, among them libFuzzer; what packages for Debian and for Python are
  # made with, and the reference; and mesh generators that are to fill the surfaces.
  install_dependencies clang libclang-rt-14-dev dpkg-dev file python3-venv doxygen tetgen gmsh
  configure_folder build/core -DORTHOGONAL_SLICES_CORE_ONLY=ON
  # What needs one processor goes beside the compilation of the core.
  prepare_others > build/prepare.log 2>&1 &
  local others=$!
  echo "-- Building build/core"
  ninja -C build/core -j "$jobs"
  wait "$others" || { cat build/prepare.log; return 1; }
  local folder
  for folder in vtk paraview fuzz; do
    echo "-- Building build/$folder"
    with_plain_vtk ninja -C "build/$folder" -j "$jobs"
  done

  # One run of ctest, which starts the longest tests of all builds first.
  echo "-- Testing core, vtk, paraview and fuzz"
  printf 'subdirs("%s")\n' core vtk paraview fuzz > build/CTestTestfile.cmake
  with_plain_vtk ctest --test-dir build -j "$jobs" --output-on-failure
}

prepare_others()
{
  local core="-DORTHOGONAL_SLICES_CORE_BUILD=$PWD/build/core"
  unpack_vtk "$vtk"
  configure_preset fuzz -DORTHOGONAL_SLICES_TEST_PREFIX=fuzz.
  # /usr is where its packages for Debian are installed.
  configure_folder build/paraview "$core" -DORTHOGONAL_SLICES_TEST_PREFIX=paraview. \
    -DORTHOGONAL_SLICES_TEST_INTERFACE_ONLY=ON -DCMAKE_INSTALL_PREFIX=/usr
  with_plain_vtk configure_folder build/vtk "$core" -DORTHOGONAL_SLICES_TEST_PREFIX=vtk. \
    "-DVTK_DIR=$vtk_dir"
}

test_sanitized()
{
  install_dependencies
  unpack_vtk "$vtk"
  # Addresses that are more random than this are too much for the thread sanitizer.
  local fixed=()
  if [ "$(cat /proc/sys/vm/mmap_rnd_bits 2> /dev/null || echo 0)" -gt 28 ]; then
    fixed=(setarch "$(uname -m)" -R)
  fi
  # Both report, and the command fails if one does.
  local status=0 preset
  for preset in asan tsan; do
    with_plain_vtk configure_preset "$preset" "-DVTK_DIR=$vtk_dir"
    with_plain_vtk cmake --build --preset "$preset" -j "$jobs"
    echo "-- Testing with $preset"
    with_plain_vtk "${fixed[@]}" ctest --preset "$preset" -j "$jobs" || status=$?
  done
  return $status
}

tidy()
{
  install_tidy
  configure_folder build/tidy -DORTHOGONAL_SLICES_CORE_ONLY=ON -DORTHOGONAL_SLICES_BUILD_TESTING=OFF
  run-clang-tidy -quiet -p build/tidy -j "$jobs" "$PWD/Filters/Core/.*"
}

measure_coverage()
{
  install_coverage
  configure_preset coverage
  cmake --build --preset coverage -j "$jobs"
  find build/coverage -name "*.gcda" -delete
  ctest --preset coverage -j "$jobs"
  mkdir -p build/coverage/pages
  gcovr -j "$jobs" --root . --gcov-ignore-parse-errors --filter Filters/Core/ --object-directory build/coverage \
    --html-details build/coverage/pages/index.html --fail-under-line 95 --print-summary \
    build/coverage
}

mkdir -p build
case "${1-}" in
  "") run=test_all ;;
  --sanitize) run=test_sanitized ;;
  --tidy) run=tidy ;;
  --coverage) run=measure_coverage ;;
  *)
    echo "Usage: bash Testing/test.sh [--sanitize | --tidy | --coverage]" >&2
    exit 2
    ;;
esac
# In a process of its own, so that the first command that fails ends it also there.
status=0
(set -e; "$run") & wait $! || status=$?
if [ $status -ne 0 ]; then
  echo "-- Something failed: see above, and Testing in the build folders" >&2
fi
exit $status
