# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
r"""Reconstruct an object from few slices, with and without virtual slices, and save a picture of it:

    pvpython SparseSlices.py closed-surface.vtp picture.png [OrthogonalSlices.so [width]]

The surface is cut into one stack of slices, the same stack with two long-axis slices across, and two
families. Above, each cell between the slices is filled by itself (Virtual Slices: Off); below, the
default: the surface bends as little as the contours allow, and virtual slices of it carry the shape
from one slice to the next. Each of the two slices across, in the middle of x and y, has to meet the
object. ParaView needs a display; without one, put xvfb-run -a -s -noreset in front.
"""

import sys

from paraview import servermanager, simple

import ReconstructFiles as example

CHOICES = [
    ("one stack: 16 z-slices", (0, 0, 16)),
    ("16 z-slices and 2 across", (1, 1, 16)),
    ("two families: 16 x, 16 z", (16, 0, 16)),
]
MODES = ["Off", "Automatic"]


def reconstruct(model, numbers, mode):
    """The contours that there are, and the surface from them. A family that is left out has none."""
    slicer = simple.OrthogonalSlicer(Input=model, NumberOfSlices=numbers)
    ports = {axis: simple.OutputPort(slicer, port)
             for port, axis in enumerate("XYZ") if numbers[port] > 0}
    inputs = {axis + "Slices": port for axis, port in ports.items()}
    surface = simple.OrthogonalSliceReconstruction(**inputs, VirtualSlices=mode)
    surface.UpdatePipeline()
    return ports, surface


def report(title, mode, surface):
    fields = servermanager.Fetch(surface, idx=0).GetFieldData()
    components, genus = (fields.GetArray(name).GetValue(0)
                         for name in ("NumberOfComponents", "TotalGenus"))
    print(f"{title}, virtual slices {mode}: {components} components, genus {genus}")


def split_evenly(layout, rows, columns):
    """Places for views, row by row: each split leaves the first part and goes on with the rest."""
    places = []
    rest = 0
    for row in range(rows):
        if row + 1 < rows:
            cell = layout.SplitVertical(rest, 1.0 / (rows - row))
            row_place, rest = cell, cell + 1
        else:
            row_place = rest
        for column in range(columns):
            if column + 1 < columns:
                cell = layout.SplitHorizontal(row_place, 1.0 / (columns - column))
                places.append(cell)
                row_place = cell + 1
            else:
                places.append(row_place)
    return places


def draw(ports, surface, title):
    view = example.make_view()
    example.show(surface, view, example.SURFACE, Specular=0.6, SpecularPower=30.0)
    for axis, port in ports.items():
        lines = simple.Show(port, view)
        lines.SetScalarColoring(None, 0)
        lines.AmbientColor = lines.DiffuseColor = example.AXES["XYZ".index(axis)]
        lines.Opacity = 0.4
    if title:
        text = simple.Text(Text=title)
        simple.Show(text, view, FontSize=20, Color=[0.1, 0.1, 0.1], WindowLocation="Upper Center")
    view.CenterAxesVisibility = 0
    return view


def look_at(bounds, view):
    """Obliquely, with z upwards, and alike for all, whatever sticks out."""
    low, high = bounds[0::2], bounds[1::2]
    distance = 0.6 * sum((b - a) ** 2 for a, b in zip(low, high)) ** 0.5
    view.CameraFocalPoint = [0.5 * (a + b) for a, b in zip(low, high)]
    view.CameraPosition = [
        f + distance * d for f, d in zip(view.CameraFocalPoint, (1.0, -2.0, 0.8))]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraViewAngle = 30.0


def main(surface_file, picture, plugin=None, width=1600):
    example.load_plugin(plugin)
    model = simple.XMLPolyDataReader(FileName=[surface_file])
    model.UpdatePipeline()
    bounds = model.GetDataInformation().GetBounds()
    views = []
    for mode in MODES:
        for title, numbers in CHOICES:
            ports, surface = reconstruct(model, numbers, mode)
            report(title, mode, surface)
            views.append(draw(ports, surface, title if mode == MODES[0] else ""))
    layout = simple.CreateLayout("Sparse slices")
    for place, view in zip(split_evenly(layout, len(MODES), len(CHOICES)), views):
        layout.AssignView(place, view)
    size = [int(width), int(width) * len(MODES) // len(CHOICES)]
    layout.SetSize(*size)
    for view in views:
        look_at(bounds, view)
    example.save_screenshot(picture, layout, size)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4, 5):
        sys.exit(__doc__)
    main(*sys.argv[1:])
