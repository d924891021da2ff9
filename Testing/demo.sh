#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash Testing/demo.sh [case [slices]]
# Builds the plugin, reconstructs a data set of Data/ in ParaView (default: heart n32) and leaves in
# build/demo the surface and a picture; then, with one slice moved as if the patient had, the picture
# and the table that show which slice it was; last, the table of figures of merit beside other
# methods. Made for a bare Debian 12: installs what is missing.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source Testing/install-dependencies.sh
source Testing/configure.sh

case=${1:-heart}
slices=${2:-n32}
core=build/demo/core
folder=build/demo/paraview
out=build/demo

build_core()
{
  configure_folder "$core" -DORTHOGONAL_SLICES_CORE_ONLY=ON
  ninja -C "$core" -j "$(nproc)" OrthogonalSlicesCore
}

mkdir -p "$out"
# Most of the code knows nothing of ParaView: it is compiled while that is installed.
announce_packages "${dependencies[@]}"
install_announced g++ cmake ninja-build libeigen3-dev libgtest-dev python3
build_core &
core_job=$!
install_announced "${dependencies[@]}"
wait "$core_job"

configure_folder "$folder" "-DORTHOGONAL_SLICES_CORE_BUILD=$PWD/$core"
ninja -C "$folder" -j "$(nproc)" OrthogonalSlices

plugin=$(find "$folder/lib" -name OrthogonalSlices.so)
contours=("Data/$case/${slices}_x.vtp" "Data/$case/${slices}_y.vtp" "Data/$case/${slices}_z.vtp")
run_in_paraview()
{
  xvfb-run -a -s "-noreset -screen 0 1600x1200x24" pvpython "$@"
}

echo "-- Reconstructing $case from Data/$case/${slices}_{x,y,z}.vtp"
run_in_paraview Plugin/Examples/ReconstructFiles.py "${contours[@]}" \
  "$out/$case.vtp" "$out/$case.png" "$plugin"
echo "-- Surface and picture: $out/$case.vtp, $out/$case.png"

echo "-- Moving one slice and finding it again"
run_in_paraview Plugin/Examples/InspectDisagreement.py "${contours[@]}" "$out/disagreement.png" \
  --plugin "$plugin" --shift y 15 0.012 0.008 | tee "$out/disagreement.txt"

echo "-- Building the Python package"
ninja -C "$folder" -j "$(nproc)" vtkFiltersOrthogonalSlicesPython

if [ -e Testing/Baselines/CompareMethods.cxx ]; then
  echo "-- Comparing with other methods (lengths in slice spacings)"
  ninja -C "$core" -j "$(nproc)" OrthogonalSlicesTestSupport
  ninja -C "$folder" -j "$(nproc)" CompareMethods
  "$folder/bin/CompareMethods" --data Data --cases "$case" --slices "${slices#n}" \
    | tee "$out/$case.txt"
fi

echo "-- Results:"
ls -l "$out"
