# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
r"""Reconstruct a thin object twice, by the paper's rule and by evidence, and save a picture of it:

    pvpython ThinParts.py x.vtp y.vtp z.vtp picture.png [OrthogonalSlices.so [width]]

The files hold contours on planes of constant x, y and z. On the left, cells with several cycles are
filled by discs only and contours that meet no other family are left out: what is thinner than the
slices are apart falls into pieces. On the right, the default. The table of undecided places is
printed: where the slices leave open what belongs together, and which slice to add. ParaView needs a
display; without one, put xvfb-run -a -s -noreset in front.
"""

import sys

from paraview import servermanager, simple

import ReconstructFiles as example

MOST_ROWS = 10


def print_undecided(surface):
    table = servermanager.Fetch(surface, idx=5)
    names = [table.GetColumnName(i) for i in range(table.GetNumberOfColumns())]
    print("  ".join(f"{name:>15}" for name in names))
    for row in range(min(MOST_ROWS, table.GetNumberOfRows())):
        values = [table.GetValue(row, i).ToDouble() for i in range(len(names))]
        print("  ".join(f"{value:15.4g}" for value in values))
    print(f"({table.GetNumberOfRows()} undecided places)")


def main(x, y, z, picture, plugin=None, width=1600):
    example.load_plugin(plugin)
    _, joined = example.reconstruct((x, y, z))
    _, discs = example.reconstruct((x, y, z))
    discs.SeveralCycles = "Discs"
    discs.MinimumIsolatedContourSize = 1.0
    discs.UpdatePipeline()
    print_undecided(joined)
    layout = simple.CreateLayout("Thin parts")
    size = [int(width), int(width) // 2]
    for place, surface in enumerate((discs, joined)):
        view = example.make_view()
        example.show(surface, view, example.SURFACE, Specular=0.2)
        view.CameraPosition = [1.0, -2.0, 0.8]
        view.CameraFocalPoint = [0.0, 0.0, 0.0]
        view.CameraViewUp = [0.0, 0.0, 1.0]
        view.CenterAxesVisibility = 0
        if place == 0:
            layout.AssignView(0, view)
            layout.SplitHorizontal(0, 0.5)
        else:
            layout.AssignView(2, view)
    layout.SetSize(*size)
    for view in simple.GetViewsInLayout(layout):
        # The same look at both: the pieces of the left one do not fill its view.
        view.CameraPosition = [0.62, -1.24, 0.5]
        view.CameraFocalPoint = [0.0, 0.0, -0.05]
        view.CameraViewAngle = 29.0
    example.save_screenshot(picture, layout, size)


if __name__ == "__main__":
    if len(sys.argv) not in (5, 6, 7):
        sys.exit(__doc__)
    main(*sys.argv[1:])
