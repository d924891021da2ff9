#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# bash Plugin/Examples/make-pictures.sh [folder [build]]
# Makes the pictures of the pages again (default: Data/pictures) with the plugin and the programs
# CompareMethods and CompareConvergence of a build folder with ParaView's VTK (default:
# build/demo/paraview, which Testing/demo.sh makes):
#   reconstruction.png  the contours of a heart, and the surface from them
#   comparison.png      the same slices given to other methods
#   disagreement.png    one slice was moved: where, how much, and which one it is
#   smooth.png          a knot with the paper's fans and with smooth patches
#   convergence.png     how errors fall with the number of planes
#   thin.png            a neuron thinner than the slices are apart, by discs and by evidence
#   sparse.png          one stack, a stack with slices across, two families, with virtual slices and
#                       without
#   gallery.png         the surfaces of all data sets

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
pictures=${1:-Data/pictures}
build=${2:-build/demo/paraview}
ninja -C "$build" OrthogonalSlices CompareMethods CompareConvergence
plugin=$(find "$build/lib" -name OrthogonalSlices.so | head -n 1)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# A display of the size of the pictures, for programs that draw.
draw()
{
  xvfb-run -a -s "-noreset -screen 0 1920x1200x24" "$@"
}

mkdir -p "$pictures"
echo "-- $pictures/reconstruction.png"
draw pvpython Plugin/Examples/ReconstructFiles.py Data/heart/n16_{x,y,z}.vtp \
  "$scratch/heart.vtp" "$pictures/reconstruction.png" "$plugin" 880
echo "-- $pictures/comparison.png"
draw "$build/bin/CompareMethods" --data Data --cases knot --slices 16 --samples 10000 \
  --methods orthogonal,ruled-walk,volume-z --picture "$pictures/comparison.png"
echo "-- $pictures/disagreement.png"
draw pvpython Plugin/Examples/InspectDisagreement.py Data/heart/n32_{x,y,z}.vtp \
  "$pictures/disagreement.png" --plugin "$plugin" --shift y 15 0.012 0.008
echo "-- $pictures/smooth.png"
draw pvpython Plugin/Examples/SmoothPatches.py Data/knot/n16_{x,y,z}.vtp \
  "$pictures/smooth.png" "$plugin" 1200
echo "-- $pictures/convergence.png"
"$build/bin/CompareConvergence" --methods smooth,coons,fan,fan-centroid,volume-xyz,volume-z \
  --csv "$scratch/convergence.csv"
draw pvpython Plugin/Examples/PlotConvergence.py "$scratch/convergence.csv" \
  "$pictures/convergence.png"
echo "-- $pictures/thin.png"
draw pvpython Plugin/Examples/ThinParts.py Data/neuron/n16_{x,y,z}.vtp "$pictures/thin.png" \
  "$plugin" 1200
echo "-- $pictures/sparse.png"
draw pvpython Plugin/Examples/SparseSlices.py Data/heart/truth.vtp "$pictures/sparse.png" \
  "$plugin" 1200
echo "-- $pictures/gallery.png"
draw pvpython Plugin/Examples/Gallery.py Data "$pictures/gallery.png" "$plugin"
ls -l "$pictures"
