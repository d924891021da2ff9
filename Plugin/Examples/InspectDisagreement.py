# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Find the badly drawn slice: which contours disagree with the orthogonal ones, and where.

    pvpython InspectDisagreement.py x.vtp y.vtp z.vtp picture.png [options]

    --plugin FILE             OrthogonalSlices.so; without it, PV_PLUGIN_PATH has to name its folder
    --top N                   how many slices are listed (default 8)
    --shift AXIS INDEX DU DV  first move slice INDEX (from 0, ascending) of AXIS (x, y or z) within its
                              plane, by DU and DV along the two other axes in cyclic order: a patient who
                              moved, for demonstration

Prints the slices that agree least and draws the picture: on the left the surface with a ball at every
node point where contours disagree, larger and darker the more they do, and the worst slice in blue; on
the right the disagreement of all slices, and the worst slice as it was drawn and as the orthogonal
slices have it. ParaView needs a display; without one, put xvfb-run -a -s "-noreset -screen 0
1280x1024x24" in front.
"""

import argparse
import math
import sys

from paraview import servermanager, simple

from ReconstructFiles import load_plugin, make_view, save_screenshot, show

AXES = "xyz"
SURFACE = [0.78, 0.76, 0.72]
WORST = [0.05, 0.35, 0.85]
OTHERS = [0.95, 0.55, 0.05]
SERIES = [[0.80, 0.22, 0.18], [0.16, 0.55, 0.25], [0.18, 0.36, 0.72]]
TEXT = [0.1, 0.1, 0.1]
SIZE = [1120, 640]
COLUMNS = ("SliceAxis", "SlicePlane", "PlaneCoordinate", "NodePoints", "RmsDisagreement",
           "MaxDisagreement", "ShiftX", "ShiftY", "ShiftZ")


# --------------------------------------------------------------------------------------------------
# Reconstruction and table

def reconstruct(sources, **properties):
    result = simple.OrthogonalSliceReconstruction(
        XSlices=sources[0], YSlices=sources[1], ZSlices=sources[2], **properties)
    result.UpdatePipeline()
    return result


def slice_table(result):
    """The slices as dictionaries, those that agree least first."""
    table = servermanager.Fetch(result, idx=4)
    rows = [{name: table.GetValueByName(row, name).ToDouble() for name in COLUMNS}
            for row in range(table.GetNumberOfRows())]
    for row in rows:
        row["SliceAxis"], row["SlicePlane"] = int(row["SliceAxis"]), int(row["SlicePlane"])
    return sorted(rows, key=lambda row: -row["RmsDisagreement"])


def name_of(row):
    return f"{AXES[row['SliceAxis']]} = {row['PlaneCoordinate']:.6g}"


def print_table(rows):
    print(f"{'slice':<16}{'plane':>6}{'node points':>13}{'RMS':>12}{'greatest':>12}   shift that fits best")
    for row in rows:
        shift = ", ".join(f"{row['Shift' + axis]:.4g}" for axis in "XYZ")
        print(f"{name_of(row):<16}{row['SlicePlane']:>6}{row['NodePoints']:>13.0f}"
              f"{row['RmsDisagreement']:>12.4g}{row['MaxDisagreement']:>12.4g}   ({shift})")


def move_slice(source, rows, axis, index, du, dv):
    """A copy of the source with one slice moved within its plane."""
    row = next((r for r in rows if (r["SliceAxis"], r["SlicePlane"]) == (axis, index)), None)
    if not row:
        sys.exit(f"There is no {AXES[axis]}-slice {index}.")
    first, second = "ijk"[(axis + 1) % 3], "ijk"[(axis + 2) % 3]
    here = f"(abs(coords{AXES[axis].upper()} - ({row['PlaneCoordinate']!r})) < {thickness(rows)!r})"
    moved = calculate(source, f"coords + if({here}, {du!r}, 0) * {first}Hat"
                              f" + if({here}, {dv!r}, 0) * {second}Hat")
    moved.CoordinateResults = 1
    return moved


def calculate(source, function, name="Result"):
    calculator = simple.Calculator(Input=source)
    calculator.AttributeType = "Point Data"
    calculator.ResultArrayName = name
    calculator.Function = function
    return calculator


def thickness(rows):
    """A small length: a thousandth of the least distance of two planes."""
    planes = sorted((row["SliceAxis"], row["PlaneCoordinate"]) for row in rows)
    gaps = [b[1] - a[1] for a, b in zip(planes, planes[1:]) if a[0] == b[0]]
    return 1e-3 * min(gaps, default=1e-3)


# --------------------------------------------------------------------------------------------------
# Parts of the data

def with_value(source, kind, name, low, high):
    return simple.Threshold(Input=source, Scalars=[kind, name], LowerThreshold=low,
                            UpperThreshold=high, ThresholdMethod="Between")


def contours_of(source, row, rows):
    """The contours of one slice as they were drawn."""
    axis = AXES[row["SliceAxis"]].upper()
    offset = calculate(source, f"coords{axis} - ({row['PlaneCoordinate']!r})", "Offset")
    return with_value(offset, "POINTS", "Offset", -thickness(rows), thickness(rows))


def arcs_of(result, row):
    """The same contours as the reconstruction has them."""
    part = with_value(simple.OutputPort(result, 1), "CELLS", "Kind", 1, 1)
    for name in ("SliceAxis", "SlicePlane"):
        part = with_value(part, "CELLS", name, row[name], row[name])
    return part


def node_points(result, least):
    """Node points whose contours are at least so far apart, with Disagreement as point data."""
    nodes = with_value(simple.OutputPort(result, 1), "CELLS", "Kind", 0, 0)
    nodes = with_value(nodes, "CELLS", "Disagreement", least, 1e300)
    return simple.CellDatatoPointData(Input=nodes)


# --------------------------------------------------------------------------------------------------
# Picture

def write_text(view, text, size, position="Upper Center"):
    display = simple.Show(simple.Text(Text=text), view)
    display.WindowLocation = position
    display.FontSize = size
    display.Color = TEXT


def color_by_disagreement(display, view, greatest):
    """From light to dark red, with a colour bar."""
    simple.ColorBy(display, ("POINTS", "Disagreement"))
    colors = simple.GetColorTransferFunction("Disagreement")
    colors.RGBPoints = [0.0, 1.0, 0.90, 0.55, 0.35 * greatest, 0.98, 0.55, 0.24,
                        0.7 * greatest, 0.85, 0.10, 0.11, greatest, 0.45, 0.0, 0.10]
    colors.ColorSpace = "RGB"
    bar = simple.GetScalarBar(colors, view)
    bar.Title, bar.ComponentTitle = "distance of the two contours at a node point", ""
    bar.TitleColor = bar.LabelColor = TEXT
    bar.TitleFontSize, bar.LabelFontSize = 13, 11
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Lower Center"
    bar.ScalarBarLength = 0.55
    bar.RangeLabelFormat = bar.LabelFormat = "%-#.3g"
    bar.AutomaticLabelFormat = 0
    display.SetScalarBarVisibility(view, True)


def draw_space(view, result, worst, rows, drawn):
    """The surface, the worst slice and the balls."""
    bounds = servermanager.Fetch(result, idx=0).GetBounds()
    diagonal = math.dist(bounds[0::2], bounds[1::2])
    greatest = max(row["MaxDisagreement"] for row in rows)
    show(result, view, SURFACE, Opacity=0.35)
    show(tube(drawn, 0.003 * diagonal), view, WORST)
    if greatest > 0.0:
        nodes = node_points(result, 0.1 * greatest)
        balls = simple.Glyph(Input=nodes, GlyphType="Sphere", GlyphMode="All Points",
                             ScaleArray=["POINTS", "Disagreement"],
                             ScaleFactor=0.024 * diagonal / greatest)
        balls.GlyphType.ThetaResolution = balls.GlyphType.PhiResolution = 12
        color_by_disagreement(simple.Show(balls, view), view, greatest)
    look_at(view, worst["SliceAxis"])


def tube(source, radius):
    return simple.Tube(Input=simple.ExtractSurface(Input=source), Radius=radius, NumberofSides=8)


def look_at(view, axis):
    """Obliquely, and so that slices of this axis are seen from the side a little."""
    view.CameraPosition = [[1.0, -1.3, 0.7], [1.3, -1.0, 0.7], [0.8, -1.5, 0.45]][axis]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]


def draw_plane(view, worst, drawn, expected):
    """The worst slice from the positive end of its axis."""
    axis = worst["SliceAxis"]
    show(drawn, view, WORST, LineWidth=3.0)
    show(expected, view, OTHERS, LineWidth=3.0)
    view.CameraPosition = [float(i == axis) for i in range(3)]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [float(i == (axis + 2) % 3) for i in range(3)]
    view.CameraParallelProjection = 1


def draw_chart(view, result, rows):
    """RMS disagreement of every slice against its plane."""
    view.LeftAxisUseCustomRange = 1
    view.LeftAxisRangeMinimum = 0.0
    view.LeftAxisRangeMaximum = 1.25 * rows[0]["RmsDisagreement"] or 1.0
    view.ChartTitle = "RMS disagreement of each slice"
    view.ChartTitleFontSize = 14
    view.BottomAxisTitle = "plane"
    view.BottomAxisTitleFontSize = 12
    view.LeftAxisTitle = ""
    for axis, name in enumerate(AXES):
        part = simple.ThresholdTable(Input=simple.OutputPort(result, 4), Mode="Between",
                                     Column=["ROWS", "SliceAxis"], MinValue=axis - 0.5, MaxValue=axis + 0.5)
        display = simple.Show(part, view)
        display.UseIndexForXAxis = 0
        display.XArrayName = "SlicePlane"
        display.SeriesVisibility = ["RmsDisagreement"]
        display.SeriesLabel = ["RmsDisagreement", f"{name}-slices"]
        display.SeriesColor = ["RmsDisagreement"] + [str(c) for c in SERIES[axis]]
        display.SeriesLineThickness = ["RmsDisagreement", "3"]


def compose(title, result, worst, rows, drawn, expected, picture):
    space, chart, plane = make_view(), simple.CreateView("XYChartView"), make_view()
    draw_space(space, result, worst, rows, drawn)
    draw_chart(chart, result, rows)
    draw_plane(plane, worst, drawn, expected)
    write_text(space, title, 16)
    write_text(plane, "this slice as drawn (blue) and as the others have it (orange)", 12)
    layout = simple.CreateLayout("Disagreement")
    layout.AssignView(0, space)
    layout.SplitHorizontal(0, 0.62)
    layout.AssignView(2, chart)
    layout.SplitVertical(2, 0.4)
    layout.AssignView(6, plane)
    layout.SetSize(*SIZE)
    for view, zoom in ((space, 1.25), (plane, 1.15)):
        simple.ResetCamera(view)
        view.GetActiveCamera().Zoom(zoom)
    save_screenshot(picture, layout, SIZE)


# --------------------------------------------------------------------------------------------------

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
    sources = [simple.XMLPolyDataReader(FileName=[name])
               for name in (arguments.x, arguments.y, arguments.z)]
    result = reconstruct(sources)
    rows = slice_table(result)
    if arguments.shift:
        axis, index = AXES.index(arguments.shift[0]), int(arguments.shift[1])
        du, dv = map(float, arguments.shift[2:])
        sources[axis] = move_slice(sources[axis], rows, axis, index, du, dv)
        result = reconstruct(sources)
        rows = slice_table(result)
    print_table(rows[:arguments.top])
    worst = rows[0]
    weights = [float(axis != worst["SliceAxis"]) for axis in range(3)]
    expected = arcs_of(reconstruct(sources, AxisWeights=weights), worst)
    drawn = contours_of(sources[worst["SliceAxis"]], worst, rows)
    shift = ", ".join(f"{worst['Shift' + axis]:.2g}" for axis in "XYZ")
    title = (f"Slice {name_of(worst)} (plane {worst['SlicePlane']}) agrees least: RMS "
             f"{worst['RmsDisagreement']:.2g}\nIt would fit best if it were moved by ({shift})")
    compose(title, result, worst, rows, drawn, expected, arguments.picture)


if __name__ == "__main__":
    main()
