# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The inspection view: where the slices of a reconstruction disagree, and which one is at fault.

The plugin brings this module along. In ParaView's window, the macro Inspect Slices opens the view for
what is selected in the pipeline browser; in a script

    LoadPlugin("OrthogonalSlices.so", remote=False, ns=globals())
    import inspectslices
    layout = inspectslices.inspect(surface)    # an Orthogonal or Parallel Slice Reconstruction

The layout has on the left the surface with a ball at every node point where contours disagree, larger
and darker the more they do, repairs in purple, the worst slice in blue, and the places that the slices
leave open in green with the outline of the slice that would settle most of them; on the right the RMS
disagreement of each slice over its plane, and the worst slice as it was drawn and as the other families
have it.
"""

import math

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkObject

AXES = "xyz"
INPUTS = ("XSlices", "YSlices", "ZSlices", "Contours", "Input")
FILTERS = ("OrthogonalSliceReconstruction", "ParallelSliceReconstruction")
SURFACE = [0.78, 0.76, 0.72]
WORST = [0.05, 0.35, 0.85]
OTHERS = [0.95, 0.55, 0.05]
REPAIRS = [0.55, 0.10, 0.55]
UNDECIDED = [0.10, 0.55, 0.30]
SERIES = [[0.80, 0.22, 0.18], [0.16, 0.55, 0.25], [0.18, 0.36, 0.72]]
TEXT = [0.1, 0.1, 0.1]
BACKGROUND = [1.0, 1.0, 1.0]
LAYOUT = "Slices"
# Contours that are closer than this, as a share of the diagonal of the surface, differ by the rounding
# of their coordinates to float.
ROUNDING = 1e-6
COLUMNS = ("SliceAxis", "SlicePlane", "PlaneCoordinate", "NodePoints", "RmsDisagreement",
           "MaxDisagreement", "ShiftX", "ShiftY", "ShiftZ")


# --------------------------------------------------------------------------------------------------
# Tables and copies

def slice_table(result):
    """The real slices as dictionaries, those that agree least first."""
    table = servermanager.Fetch(result, idx=4)
    rows = []
    for row in range(table.GetNumberOfRows()):
        value = table.GetValueByName(row, "Virtual")
        if not (value.IsValid() and value.ToInt()):
            rows.append({name: table.GetValueByName(row, name).ToDouble() for name in COLUMNS})
            rows[-1]["SliceName"] = table.GetValueByName(row, "SliceName").ToString()
    for row in rows:
        row["SliceAxis"], row["SlicePlane"] = int(row["SliceAxis"]), int(row["SlicePlane"])
    return sorted(rows, key=lambda row: -row["RmsDisagreement"])


def diagonal_of(result):
    bounds = servermanager.Fetch(result, idx=0).GetBounds()
    return math.dist(bounds[0::2], bounds[1::2])


def agree(result, rows):
    """Whether no two contours are farther apart than rounding explains."""
    return max(row["MaxDisagreement"] for row in rows) <= ROUNDING * diagonal_of(result)


def print_table(rows):
    """The slices with their axes, what they disagree by, and the shift that would fit best."""
    print(f"{'slice':<16}{'plane':>6}{'node points':>13}{'RMS':>12}{'greatest':>12}   shift that fits best")
    for row in rows:
        shift = ", ".join(f"{row['Shift' + axis]:.4g}" for axis in "XYZ")
        print(f"{row['SliceName']:<16}{row['SlicePlane']:>6}{row['NodePoints']:>13.0f}"
              f"{row['RmsDisagreement']:>12.4g}{row['MaxDisagreement']:>12.4g}   ({shift})")


def inputs_of(result):
    """The inputs that are connected, by their names."""
    given = {name: getattr(result, name) for name in INPUTS
             if result.GetProperty(name) is not None}
    return {name: source for name, source in given.items() if source is not None}


def without_family(result, axis):
    """The same reconstruction, in which the slices of one axis yield to the others."""
    kind = getattr(simple, result.SMProxy.GetXMLName())
    values = {name: result.GetPropertyValue(name) for name in result.ListProperties()
              if name not in INPUTS + ("CellArrayNames", "AxisWeights")}
    weights = [0.0 if i == axis else weight for i, weight in enumerate(result.AxisWeights)]
    copy = kind(registrationName="WithoutFamily", AxisWeights=weights, **inputs_of(result))
    for name, value in values.items():
        setattr(copy, name, value)
    # Its messages are those of the reconstruction itself, which has said them.
    shown = vtkObject.GetGlobalWarningDisplay()
    vtkObject.SetGlobalWarningDisplay(0)
    try:
        copy.UpdatePipeline()
    finally:
        vtkObject.SetGlobalWarningDisplay(shown)
    return copy


def normal_of(result, axis):
    """The normal of a family: an axis of the world, unless the families are turned."""
    normals = servermanager.Fetch(result, idx=0).GetFieldData().GetArray("FamilyNormals")
    return normals.GetTuple3(axis) if normals else tuple(float(i == axis) for i in range(3))


# --------------------------------------------------------------------------------------------------
# Parts of the data

def calculate(source, function, name="Result"):
    calculator = simple.Calculator(Input=source)
    calculator.AttributeType = "Point Data"
    calculator.ResultArrayName = name
    calculator.Function = function
    return calculator


def thickness(rows):
    """A small length: a thousandth of the least distance of two planes."""
    planes = sorted((row["SliceAxis"], row["PlaneCoordinate"]) for row in rows)
    gaps = [b[1] - a[1] for a, b in zip(planes, planes[1:]) if a[0] == b[0] and b[1] > a[1]]
    return 1e-3 * min(gaps, default=1e-3)


def with_value(source, kind, name, low, high):
    return simple.Threshold(Input=source, Scalars=[kind, name], LowerThreshold=low,
                            UpperThreshold=high, ThresholdMethod="Between")


def contours_of(sources, row, rows, normal):
    """The contours of one slice as they were drawn."""
    drawn = simple.AppendDatasets(Input=list(sources)) if len(sources) > 1 else sources[0]
    height = " + ".join(f"coords{axis} * ({part!r})" for axis, part in zip("XYZ", normal))
    offset = calculate(drawn, f"{height} - ({row['PlaneCoordinate']!r})", "Offset")
    part = with_value(offset, "POINTS", "Offset", -thickness(rows), thickness(rows))
    simple.RenameSource("WorstSliceAsDrawn", part)
    return part


def arcs_of(result, row):
    """The same contours as a reconstruction has them."""
    part = with_value(simple.OutputPort(result, 1), "CELLS", "Kind", 1, 1)
    for name in ("SliceAxis", "SlicePlane"):
        part = with_value(part, "CELLS", name, row[name], row[name])
    simple.RenameSource("WorstSliceAsTheOthersHaveIt", part)
    return part


def node_points(result, least):
    """Node points whose contours are at least so far apart, with Disagreement as point data."""
    nodes = with_value(simple.OutputPort(result, 1), "CELLS", "Kind", 0, 0)
    nodes = with_value(nodes, "CELLS", "Disagreement", least, 1e300)
    return simple.CellDatatoPointData(Input=nodes)


# --------------------------------------------------------------------------------------------------
# Views

def make_view():
    view = simple.CreateRenderView()
    view.UseColorPaletteForBackground = 0
    view.Background = BACKGROUND
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    return view


def show(source, view, color, **properties):
    display = simple.Show(simple.OutputPort(source, 0), view)
    display.SetScalarColoring(None, 0)
    display.AmbientColor = display.DiffuseColor = color
    for name, value in properties.items():
        setattr(display, name, value)


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


def tube(source, radius):
    return simple.Tube(Input=simple.ExtractSurface(Input=source), Radius=radius, NumberofSides=8)


def draw_disagreement(view, result, greatest, diagonal):
    """A ball at each node point where contours are at least a tenth of the greatest distance apart."""
    nodes = node_points(result, 0.1 * greatest)
    balls = simple.Glyph(registrationName="Disagreement", Input=nodes, GlyphType="Sphere",
                         GlyphMode="All Points", ScaleArray=["POINTS", "Disagreement"],
                         ScaleFactor=0.024 * diagonal / greatest)
    balls.GlyphType.ThetaResolution = balls.GlyphType.PhiResolution = 12
    color_by_disagreement(simple.Show(balls, view), view, greatest)


def draw_undecided(view, result, bounds, turned):
    """Places that the slices leave open, and the outline of the slice that would settle most."""
    table = servermanager.Fetch(result, idx=5)
    if table.GetNumberOfRows() == 0:
        return
    places = simple.TableToPoints(registrationName="Undecided", Input=simple.OutputPort(result, 5),
                                  XColumn="X", YColumn="Y", ZColumn="Z")
    show(places, view, UNDECIDED, PointSize=9.0, RenderPointsAsSpheres=1)
    axis = table.GetValueByName(0, "PlaneAxis").ToInt()
    if axis < 0 or turned:
        return
    at = table.GetValueByName(0, "PlaneCoordinate").ToDouble()
    corners = []
    for first, second in ((0, 0), (1, 0), (0, 1)):
        corner = [0.0, 0.0, 0.0]
        corner[axis] = at
        corner[(axis + 1) % 3] = bounds[2 * ((axis + 1) % 3) + first]
        corner[(axis + 2) % 3] = bounds[2 * ((axis + 2) % 3) + second]
        corners.append(corner)
    plane = simple.Plane(registrationName="SliceToAdd", Origin=corners[0], Point1=corners[1],
                         Point2=corners[2])
    show(plane, view, UNDECIDED, Representation="Feature Edges", LineWidth=3.0)


def draw_repairs(view, result):
    """Places where the slices contradicted each other so much that one had to give way."""
    repairs = servermanager.Fetch(result, idx=0).GetFieldData().GetArray("NumberOfRepairs")
    if repairs is not None and repairs.GetValue(0) > 0:
        places = with_value(simple.OutputPort(result, 1), "CELLS", "Kind", 3, 255)
        simple.RenameSource("Repairs", places)
        show(places, view, REPAIRS, PointSize=5.0, RenderPointsAsSpheres=1)


def draw_space(view, result, worst, rows, drawn):
    """The surface, the worst slice, the balls and the open places."""
    surface = servermanager.Fetch(result, idx=0)
    bounds, diagonal = surface.GetBounds(), diagonal_of(result)
    greatest = max(row["MaxDisagreement"] for row in rows)
    show(result, view, SURFACE, Opacity=0.35)
    draw_repairs(view, result)
    draw_undecided(view, result, bounds, surface.GetFieldData().HasArray("FamilyNormals"))
    if not agree(result, rows):
        show(tube(drawn, 0.003 * diagonal), view, WORST)
        draw_disagreement(view, result, greatest, diagonal)
    look_at(view, worst["SliceAxis"])


def look_at(view, axis):
    """Obliquely, and so that slices of this axis are seen from the side a little."""
    view.CameraPosition = [[1.0, -1.3, 0.7], [1.3, -1.0, 0.7], [0.8, -1.5, 0.45]][axis]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]


def draw_plane(view, worst, normal, drawn, expected):
    """The worst slice from the positive end of its axis."""
    show(drawn, view, WORST, LineWidth=3.0)
    show(expected, view, OTHERS, LineWidth=3.0)
    view.CameraPosition = list(normal)
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [float(i == (worst["SliceAxis"] + 2) % 3) for i in range(3)]
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
    for axis in sorted({row["SliceAxis"] for row in rows}):
        name = AXES[axis]
        part = simple.ThresholdTable(Input=simple.OutputPort(result, 4), Mode="Between",
                                     Column=["ROWS", "SliceAxis"], MinValue=axis - 0.5, MaxValue=axis + 0.5)
        display = simple.Show(part, view)
        display.UseIndexForXAxis = 0
        display.XArrayName = "SlicePlane"
        display.SeriesVisibility = ["RmsDisagreement"]
        display.SeriesLabel = ["RmsDisagreement", f"{name}-slices"]
        display.SeriesColor = ["RmsDisagreement"] + [str(c) for c in SERIES[axis]]
        display.SeriesLineThickness = ["RmsDisagreement", "3"]


def title_of(result, rows):
    worst = rows[0]
    lines = ["The slices agree wherever two of them meet"]
    if not agree(result, rows):
        shift = ", ".join(f"{worst['Shift' + axis]:.2g}" for axis in "XYZ")
        lines = [f"Slice {worst['SliceName']} (plane {worst['SlicePlane']}) agrees least: RMS "
                 f"{worst['RmsDisagreement']:.2g}", f"It would fit best if it were moved by ({shift})"]
    open_places = servermanager.Fetch(result, idx=5)
    if open_places.GetNumberOfRows() > 0:
        slice_to_add = open_places.GetValueByName(0, "PlaneName").ToString()
        lines.append("Green: what the slices leave open"
                     + (f"; a slice at {slice_to_add} would tell most" if slice_to_add else ""))
    return "\n".join(lines)


# --------------------------------------------------------------------------------------------------
# What the macro does

def find_reconstruction():
    """The filter that is selected, or that what is selected comes from; else the last one made."""
    def is_one(proxy):
        return proxy is not None and proxy.SMProxy.GetXMLName() in FILTERS

    all_sources = list(simple.GetSources().values())
    source = simple.GetActiveSource()
    while source is not None and source in all_sources:
        if is_one(source):
            return source
        origin = getattr(source, "Input", None)
        source = servermanager._getPyProxy(origin.SMProxy) if hasattr(origin, "SMProxy") else None
    found = [proxy for proxy in all_sources if is_one(proxy)]
    return found[-1] if found else None


def inspect(result=None, listed=8):
    """Opens the layout for a reconstruction, or without one for that of the pipeline, and prints so many
    of the slices that agree least. The layout."""
    result = result or find_reconstruction()
    if result is None:
        raise RuntimeError("There is no Orthogonal or Parallel Slice Reconstruction to inspect: "
                           "make one, and press Apply.")
    result.UpdatePipeline()
    rows = slice_table(result)
    if not rows:
        raise RuntimeError("The reconstruction has no slices: see its messages.")
    print_table(rows[:listed])
    worst = rows[0]
    sources = list(inputs_of(result).values())
    normal = normal_of(result, worst["SliceAxis"])
    drawn = contours_of(sources, worst, rows, normal)
    has_families = result.GetProperty("AxisWeights") is not None
    other = without_family(result, worst["SliceAxis"]) if has_families else result
    layout = compose(result, rows, normal, drawn, arcs_of(other, worst))
    simple.SetActiveSource(result)
    return layout


def compose(result, rows, normal, drawn, expected):
    """The three views: space on the left, chart and worst slice on the right."""
    worst = rows[0]
    layout = simple.CreateLayout(LAYOUT)
    space, chart, plane = make_view(), simple.CreateView("XYChartView"), make_view()
    draw_space(space, result, worst, rows, drawn)
    draw_chart(chart, result, rows)
    draw_plane(plane, worst, normal, drawn, expected)
    write_text(space, title_of(result, rows), 12)
    write_text(plane, "blue: this slice as drawn\norange: as the others have it", 12)
    for view in (space, chart, plane):
        if layout.GetViewLocation(view) >= 0:
            layout.RemoveView(view)
    layout.AssignView(0, space)
    layout.SplitHorizontal(0, 0.62)
    layout.AssignView(2, chart)
    layout.SplitVertical(2, 0.4)
    layout.AssignView(6, plane)
    frame(layout)
    simple.SetActiveView(space)
    return layout


def frame(layout):
    """Has both render views show all that is in them; once more after the layout has another size."""
    for cell, zoom in ((1, 1.25), (6, 0.95)):
        view = layout.GetView(cell)
        view = servermanager._getPyProxy(view)
        simple.ResetCamera(view)
        view.GetActiveCamera().Zoom(zoom)
