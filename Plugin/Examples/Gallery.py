# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The surfaces of all data sets in one picture, each from its contours on 32 planes of each axis:

    pvpython Gallery.py Data picture.png [OrthogonalSlices.so]

Each folder of Data with n32_x.vtp, n32_y.vtp and n32_z.vtp is one. Without the path of the plugin, it is
the one that ParaView lists, or that of a build folder of the repository. ParaView needs a display; without one, put xvfb-run
-a -s "-noreset -screen 0 1280x1024x24" in front.
"""

import math
import pathlib
import sys

from paraview import servermanager, simple

from ReconstructFiles import SURFACE, load_plugin, make_view, reconstruct, save_screenshot, show

COLUMNS = 3
CELL = 200  # pixels


def numbers(surface):
    """Components and handles of a surface, as a caption."""
    fields = servermanager.Fetch(surface, idx=0).GetFieldData()
    components, genus = (fields.GetArray(name).GetValue(0)
                         for name in ("NumberOfComponents", "TotalGenus"))
    parts = "1 part" if components == 1 else f"{components} parts"
    return parts + ("" if genus == 0 else f", {genus} handle" + ("s" if genus > 1 else ""))


def draw(folder, view):
    """One surface, seen obliquely with z upwards, with its name."""
    _, surface = reconstruct([str(folder / f"n32_{axis}.vtp") for axis in "xyz"])
    show(surface, view, SURFACE, Specular=0.2)
    text = simple.Show(simple.Text(Text=f"{folder.name}: {numbers(surface)}"), view)
    text.WindowLocation, text.FontSize, text.Color = "Lower Center", 11, [0.1, 0.1, 0.1]
    view.CameraPosition, view.CameraFocalPoint = [1.0, -2.0, 0.8], [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CenterAxesVisibility = 0


def split(layout, cell, count, down):
    """Divides a cell of the layout into `count` equal ones, one after another; their numbers."""
    cells = []
    for left in range(count, 1, -1):
        halve = layout.SplitVertical if down else layout.SplitHorizontal
        first = halve(cell, 1.0 / left)
        cells.append(first)
        cell = first + 1
    return cells + [cell]


def main(data, picture, plugin=None):
    load_plugin(plugin)
    folders = sorted(path.parent for path in pathlib.Path(data).glob("*/n32_x.vtp"))
    rows = math.ceil(len(folders) / COLUMNS)
    size = [COLUMNS * CELL, rows * CELL]
    layout = simple.CreateLayout("Gallery")
    cells = [cell for row in split(layout, 0, rows, True) for cell in split(layout, row, COLUMNS, False)]
    views = []
    for cell, folder in zip(cells, folders):
        views.append(make_view())
        layout.AssignView(cell, views[-1])
        draw(folder, views[-1])
    for cell in cells[len(folders):]:
        layout.AssignView(cell, make_view())
    layout.SetSize(*size)
    for view in views:
        simple.ResetCamera(view)
        view.GetActiveCamera().Zoom(1.1)
    save_screenshot(picture, layout, size)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
