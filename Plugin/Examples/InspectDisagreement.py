# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Find the badly drawn slice: which contours disagree with the orthogonal ones, and where.

    pvpython InspectDisagreement.py x.vtp y.vtp z.vtp picture.png [options]

    --plugin FILE             OrthogonalSlices.so; without it, the one that ParaView lists, or
                              that of a build folder of the repository
    --top N                   how many slices are listed (default 8)
    --shift AXIS INDEX DU DV  first move slice INDEX (from 0, ascending) of AXIS (x, y or z) within its
                              plane, by DU and DV along the two other axes in cyclic order: a patient who
                              moved, for demonstration

Prints the slices that agree least and draws the picture with the inspection view that the plugin brings
along (in ParaView's window, the macro Inspect Slices opens it): on the left the surface with a ball at every
node point where contours disagree, larger and darker the more they do, and the worst slice in blue; on
the right the disagreement of all slices, and the worst slice as it was drawn and as the orthogonal
slices have it. ParaView needs a display; without one, put xvfb-run -a -s "-noreset -screen 0
1280x1024x24" in front.
"""

import argparse
import sys

from paraview import simple

from ReconstructFiles import load_plugin, save_screenshot

AXES = "xyz"
SIZE = [960, 560]


def reconstruct(sources):
    result = simple.OrthogonalSliceReconstruction(
        XSlices=sources[0], YSlices=sources[1], ZSlices=sources[2])
    result.UpdatePipeline()
    return result


def move_slice(source, rows, axis, index, du, dv):
    """A copy of the source with one slice moved within its plane."""
    import inspectslices

    row = next((r for r in rows if (r["SliceAxis"], r["SlicePlane"]) == (axis, index)), None)
    if not row:
        sys.exit(f"There is no {AXES[axis]}-slice {index}.")
    first, second = "ijk"[(axis + 1) % 3], "ijk"[(axis + 2) % 3]
    here = (f"(abs(coords{AXES[axis].upper()} - ({row['PlaneCoordinate']!r})) < "
            f"{inspectslices.thickness(rows)!r})")
    moved = inspectslices.calculate(source, f"coords + if({here}, {du!r}, 0) * {first}Hat"
                                            f" + if({here}, {dv!r}, 0) * {second}Hat")
    moved.CoordinateResults = 1
    return moved


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("x", "y", "z", "picture"):
        parser.add_argument(name)
    parser.add_argument("--plugin")
    parser.add_argument("--top", type=int, default=8)
    parser.add_argument("--shift", nargs=4, metavar=("AXIS", "INDEX", "DU", "DV"))
    arguments = parser.parse_args()
    if arguments.shift and arguments.shift[0] not in ("x", "y", "z"):
        parser.error("--shift: the axis is x, y or z")
    return arguments


def main():
    arguments = parse_arguments()
    load_plugin(arguments.plugin)
    import inspectslices  # of the plugin

    sources = [simple.XMLPolyDataReader(FileName=[name])
               for name in (arguments.x, arguments.y, arguments.z)]
    result = reconstruct(sources)
    if arguments.shift:
        axis, index = AXES.index(arguments.shift[0]), int(arguments.shift[1])
        du, dv = map(float, arguments.shift[2:])
        sources[axis] = move_slice(sources[axis], inspectslices.slice_table(result), axis, index, du, dv)
        result = reconstruct(sources)
    layout = inspectslices.inspect(result, arguments.top)
    layout.SetSize(*SIZE)
    inspectslices.frame(layout)
    save_screenshot(arguments.picture, layout, SIZE)


if __name__ == "__main__":
    main()
