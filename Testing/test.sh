#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash Testing/test.sh
# Builds with ParaView's VTK and with plain VTK 9.1, passes all tests and runs the fuzzer with a fixed
# seed. Build folders: build/paraview, build/vtk, build/fuzz.
#
# bash Testing/test.sh --sanitize
# Passes the tests of the core and of the filter with the address, undefined behaviour and thread
# sanitizers and plain VTK 9.1, which takes longer. Build folders: build/asan, build/tsan.
#
# Made for a bare Debian 12: installs what is missing.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source Testing/install-dependencies.sh

jobs=$(nproc)
library=lib/$(uname -m)-linux-gnu
vtk=$PWD/build/vtk9.1

configure()
{
  local folder=$1
  shift
  echo "-- Building $folder"
  if ! cmake -DPython3_EXECUTABLE=/usr/bin/python3 -Wno-dev "$@" > "$folder.log" 2>&1; then
    cat "$folder.log"
    return 1
  fi
}

build()
{
  local folder=$1
  shift
  configure "$folder" -G Ninja -S . -B "$folder" "$@"
  ninja -C "$folder" -j "$jobs"
}

build_preset()
{
  configure "build/$1" --preset "$1" -DVTK_DIR="$vtk/usr/$library/cmake/vtk-9.1"
  cmake --build --preset "$1" -j "$jobs"
}

with_plain_vtk()
{
  LD_LIBRARY_PATH="$vtk/usr/$library${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" \
    PYTHONPATH="$vtk/usr/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}" "$@"
}

# The whole of it reports, and the command fails if a part does.
status=0
pass()
{
  echo "-- Testing $1"
  shift
  "$@" || status=$?
}

case "${1-}" in
  "" | --sanitize) ;;
  *)
    echo "Usage: bash Testing/test.sh [--sanitize]" >&2
    exit 2
    ;;
esac
mkdir -p build
install_dependencies
unpack_vtk "$vtk"

if [ "${1-}" = --sanitize ]; then
  # Addresses that are more random than this are too much for the thread sanitizer.
  fixed=()
  if [ "$(cat /proc/sys/vm/mmap_rnd_bits 2> /dev/null || echo 0)" -gt 28 ]; then
    fixed=(setarch "$(uname -m)" -R)
  fi
  for preset in asan tsan; do
    with_plain_vtk build_preset "$preset"
    pass "with $preset" with_plain_vtk "${fixed[@]}" ctest --preset "$preset" -j "$jobs"
  done
else
  install_fuzzer
  build build/paraview
  with_plain_vtk build build/vtk -DVTK_DIR="$vtk/usr/$library/cmake/vtk-9.1"
  with_plain_vtk build_preset fuzz
  pass "with plain VTK 9.1" \
    with_plain_vtk ctest --test-dir build/vtk -j "$jobs" --output-on-failure
  # The core is the same with every VTK: its random solids need not be tried again.
  pass "with ParaView" \
    ctest --test-dir build/paraview -j "$jobs" --output-on-failure -E '^RandomSolids'
  pass "random changes of contours (fuzzer)" with_plain_vtk ctest --preset fuzz
fi
if [ $status -ne 0 ]; then
  echo "-- Some tests failed: see Testing in the build folders" >&2
fi
exit $status
