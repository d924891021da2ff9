#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash Testing/test.sh
# Builds with ParaView's VTK and with plain VTK 9.1 and passes all tests. Made for a bare Debian 12:
# installs what is missing. Build folders: build/paraview and build/vtk.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source Testing/install-dependencies.sh

jobs=$(nproc)
library=lib/$(uname -m)-linux-gnu
vtk=$PWD/build/vtk9.1

build()
{
  local folder=$1
  shift
  echo "-- Building $folder"
  if ! cmake -G Ninja -S . -B "$folder" -DPython3_EXECUTABLE=/usr/bin/python3 -Wno-dev "$@" \
    > "$folder.log" 2>&1; then
    cat "$folder.log"
    return 1
  fi
  ninja -C "$folder" -j "$jobs"
}

with_plain_vtk()
{
  LD_LIBRARY_PATH="$vtk/usr/$library${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" \
    PYTHONPATH="$vtk/usr/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}" "$@"
}

mkdir -p build
install_dependencies
unpack_vtk "$vtk"
build build/paraview
with_plain_vtk build build/vtk -DVTK_DIR="$vtk/usr/$library/cmake/vtk-9.1"

# Both runs report, and the command fails if one of them does.
status=0
echo "-- Testing with plain VTK 9.1"
with_plain_vtk ctest --test-dir build/vtk -j "$jobs" --output-on-failure || status=$?
echo "-- Testing with ParaView"
ctest --test-dir build/paraview -j "$jobs" --output-on-failure || status=$?
if [ $status -ne 0 ]; then
  echo "-- Some tests failed: see build/vtk/Testing and build/paraview/Testing" >&2
fi
exit $status
