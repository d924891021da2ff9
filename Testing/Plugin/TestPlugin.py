# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pvpython TestPlugin.py <plugin> <Data>: both filters, their properties and outputs."""

import os
import pathlib
import shutil
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview import servermanager, simple

from PluginChecks import (
    check,
    check_closed,
    check_heart,
    check_sphere,
    fetch,
    field_value,
    load_plugin,
    reconstruct,
    reconstruct_sliced,
    sphere,
)


def check_defaults():
    slicer = simple.OrthogonalSlicer(Input=sphere())
    expected = {
        "PlaneMode": "By Number",
        "NumberOfSlices": [32, 32, 32],
        "Spacing": [1.0, 1.0, 1.0],
        "XCoordinates": [],
        "YCoordinates": [],
        "ZCoordinates": [],
        "UseLabel": 0,
        "LabelValue": 1,
        "EveryLabel": 0,
        "BackgroundLabel": 0,
        "OutputPointsPrecision": "Same as input",
    }
    compare_defaults(slicer, expected)
    expected = {
        "LabelArray": "None",
        "Orientation": "By Nesting",
        "InvalidContours": "Mend",
        "BorderContours": "Close Along Border",
        "BorderBounds": [0.0, -1.0, 0.0, -1.0, 0.0, -1.0],
        "InsertMissingContours": 1,
        "Frame": "Automatic",
        "FrameNormals": [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
        "VirtualSlices": "Automatic",
        "VirtualSliceSpacing": 0.0,
        "FollowField": 1,
        "EndCaps": "Dome",
        "PlaneTolerance": 1e-5,
        "PatchType": "Smooth",
        "EdgeLength": 0.25,
        "ChordTolerance": 0.0,
        "Accuracy": 0.0,
        "AutomaticAccuracy": 1,
        "KeepContourVertices": 0,
        "CornerAngle": 60.0,
        "Smoothing": 0.0,
        "ContourTolerance": 0.0,
        "ComputeCurvatures": 0,
        "PassCellArrays": 1,
        "CentralPoint": "Least Squares",
        "ComputeNormals": 1,
        "WarnOfMissingFamilies": 1,
        "OutputPointsPrecision": "Same as input",
    }
    compare_defaults(reconstruct_sliced(slicer), expected)


def compare_defaults(proxy, expected):
    for name, value in expected.items():
        found = proxy.GetPropertyValue(name)
        found = list(found) if isinstance(value, list) else found
        check(found == value, f"{name} is {found}, not {value}")


def check_documentation():
    """Each property says in the panel what it does, and its default or that it is required."""
    slicer = simple.OrthogonalSlicer(Input=sphere())
    parallel = simple.ParallelSliceReconstruction(Input=simple.OutputPort(slicer, 2))
    for proxy in (slicer, reconstruct_sliced(slicer), parallel):
        for name in proxy.ListProperties():
            text = proxy.GetProperty(name).SMProperty.GetDocumentation()
            text = text.GetDescription() if text else ""
            check("Default" in text or "Required" in text or "Must" in text,
                f"{name} is documented as '{text}'")


def check_outputs():
    slicer = simple.OrthogonalSlicer(Input=sphere(), NumberOfSlices=[9, 10, 11])
    rec = reconstruct_sliced(slicer)
    for proxy, names in ((slicer, ("XSlices", "YSlices", "ZSlices")),
                         (rec, ("Surface", "Graph", "Histogram", "Contours", "Slices", "Undecided",
                                "Input problems", "Components"))):
        found = tuple(proxy.SMProxy.GetOutputPortName(k)
                      for k in range(proxy.SMProxy.GetNumberOfOutputPorts()))
        check(found == names, f"the outputs are named {found}")
    for port, planes in enumerate((9, 10, 11)):
        contours = fetch(slicer, port).GetNumberOfLines()
        check(contours == planes, f"{contours} contours on {planes} planes of a sphere")

    surface, graph, histogram = (fetch(rec, port) for port in range(3))
    check(field_value(surface, "NumberOfContours") == 30, "the number of contours is wrong")
    nodes = field_value(surface, "NumberOfNodePoints")
    check(graph.GetNumberOfVerts() == nodes, "the graph has other node points than the surface")
    check(graph.GetCellData().HasArray("Disagreement"), "the graph has no Disagreement")
    sizes, counts = (histogram.GetColumnByName(name) for name in ("PolygonSize", "Count"))
    sides = sum(sizes.GetValue(k) * counts.GetValue(k) for k in range(sizes.GetNumberOfTuples()))
    arcs = graph.GetNumberOfLines() - field_value(surface, "NumberOfIsolatedContours")
    check(sides == 2 * arcs, f"{sides} sides of polygons on {arcs} arcs")


def check_properties_reach_the_filters():
    slicer = simple.OrthogonalSlicer(Input=sphere())
    slicer.PlaneMode = "By Spacing"
    slicer.Spacing = [0.25, 0.25, 0.5]
    contours = [fetch(slicer, port).GetNumberOfLines() for port in range(3)]
    check(contours == [8, 8, 4], f"by spacing: {contours} contours")
    slicer.PlaneMode = "By Coordinates"
    slicer.XCoordinates = [-0.5, 0.0, 0.5]
    slicer.YCoordinates = [0.5, -0.25]
    slicer.ZCoordinates = [0.1]
    contours = [fetch(slicer, port).GetNumberOfLines() for port in range(3)]
    check(contours == [3, 2, 1], f"by coordinates: {contours} contours")

    slicer.PlaneMode = "By Number"
    rec = reconstruct_sliced(slicer, ComputeNormals=0, OutputPointsPrecision="Double")
    surface = fetch(rec)
    check(surface.GetPointData().GetNormals() is None, "normals though switched off")
    check(surface.GetPoints().GetDataType() == 11, "the points are not double")
    smooth = surface.GetCenter(), surface.GetLength()
    rec.CentralPoint = "Centroid"
    rec.Orientation = "As Drawn"
    surface = fetch(rec)
    check_closed(surface, components=1)
    check(smooth != (surface.GetCenter(), surface.GetLength()) or surface.GetNumberOfPoints() > 0,
        "no surface with the other modes")


def check_views():
    """Apply shows the surface in the view that is there, and opens none for the other outputs."""
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    slicer = simple.OrthogonalSlicer(Input=sphere())
    parallel = simple.ParallelSliceReconstruction(Input=simple.OutputPort(slicer, 2))
    for proxy in (reconstruct_sliced(slicer), parallel):
        proxy.UpdatePipeline()
        for port in range(proxy.SMProxy.GetNumberOfOutputPorts()):
            view = controller.GetPreferredViewType(proxy.SMProxy, port)
            expected = "None" if port > 0 else None
            check(view == expected, f"output {port} of {proxy.GetXMLLabel()} asks for {view}")


def check_inputs_left_out():
    """An input that a script leaves out stays out, whatever the active source is."""
    slicer = simple.OrthogonalSlicer(Input=sphere(), NumberOfSlices=[9, 10, 11])
    ports = [simple.OutputPort(slicer, port) for port in range(3)]
    names = ("XSlices", "YSlices", "ZSlices")
    planes = (9, 10, 11)
    for given in ((1, 2), (0, 2), (0, 1), (0,), (1,), (2,)):
        for active in (slicer, ports[0], ports[2]):
            simple.SetActiveSource(active)
            inputs = {names[axis]: ports[axis] for axis in given}
            rec = simple.OrthogonalSliceReconstruction(**inputs)
            for axis in range(3):
                connected = getattr(rec, names[axis]) is not None
                check(connected == (axis in given), f"{names[axis]} with {list(inputs)}: {connected}")
            count = field_value(fetch(rec), "NumberOfContours")
            expected = sum(planes[axis] for axis in given)
            check(count == expected, f"{count} contours of {list(inputs)}, not {expected}")
    rec = reconstruct(*ports)
    check(field_value(fetch(rec), "NumberOfContours") == 30, "not all contours")
    rec.XSlices = None
    check(field_value(fetch(rec), "NumberOfContours") == 21, "an input cannot be taken out again")


def check_one_input_for_all():
    """Slices of all families in one group, also turned."""
    slicer = simple.OrthogonalSlicer(Input=sphere(), NumberOfSlices=[9, 10, 11])
    group = simple.GroupDatasets(Input=[simple.OutputPort(slicer, port) for port in range(3)])
    turned = simple.Transform(Input=group)
    turned.Transform.Rotate = [10.0, 20.0, 30.0]
    for source in (group, turned):
        rec = simple.OrthogonalSliceReconstruction(Contours=source)
        for name in ("XSlices", "YSlices", "ZSlices"):
            check(getattr(rec, name) is None, f"{name} is connected")
        surface = fetch(rec)
        check_closed(surface, components=1)
        check(field_value(surface, "NumberOfContours") == 30, "not all contours of the group")
        has_frame = surface.GetFieldData().HasArray("FamilyNormals") == 1
        check(has_frame == (source is turned), f"normals of the families: {has_frame}")


def check_solid_cells():
    """A mesh of solid cells is sliced as its surface is."""
    box = simple.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3])
    volume = simple.Tetrahedralize(Input=box)
    slicer = simple.OrthogonalSlicer(Input=volume, NumberOfSlices=[8, 8, 8])
    check_closed(fetch(reconstruct_sliced(slicer)), components=1)


def check_composite():
    """A group of models is sliced block by block, and its slices make one surface."""
    balls = [sphere(), simple.Transform(Input=sphere())]
    balls[1].Transform.Translate = [5.0, 0.0, 0.0]
    group = simple.GroupDatasets(Input=balls)
    slicer = simple.OrthogonalSlicer(Input=group, NumberOfSlices=[8, 8, 8])
    for port in range(3):
        contours = servermanager.Fetch(simple.OutputPort(slicer, port))
        check(contours.IsA("vtkCompositeDataSet"), f"port {port} is a {contours.GetClassName()}")
        check(contours.GetNumberOfCells() == 16, f"{contours.GetNumberOfCells()} contours")
    rec = reconstruct_sliced(slicer)
    check_closed(fetch(rec), components=2)
    blocks = fetch(rec, 3).GetColumnByName("Block")
    check(blocks is not None and len({blocks.GetValue(row) for row in range(48)}) == 2,
          "the table of contours does not tell blocks apart")
    parallel = simple.ParallelSliceReconstruction(Input=simple.OutputPort(slicer, 1))
    check_closed(fetch(parallel), components=2)


def check_parallel():
    """One family of slices, with the defaults and another criterion."""
    slicer = simple.OrthogonalSlicer(Input=sphere())
    parallel = simple.ParallelSliceReconstruction(Input=simple.OutputPort(slicer, 2))
    check_closed(fetch(parallel), components=1)
    compare_defaults(
        parallel, {"VirtualSlices": "Automatic", "VirtualSliceSpacing": 0.0, "EndCaps": "Dome"})
    smooth = fetch(parallel)
    parallel.VirtualSlices = "Off"
    check_closed(fetch(parallel), components=1)
    check(fetch(parallel).GetNumberOfPoints() != smooth.GetNumberOfPoints(), "no virtual slices")
    parallel.VirtualSlices = "Automatic"
    heights = []
    for ends in ("Flat", "Half Slice"):
        parallel.EndCaps = ends
        surface = fetch(parallel)
        check_closed(surface, components=1)
        heights.append(surface.GetBounds()[5] - surface.GetBounds()[4])
    planes = 32  # of the slicer, at equal distances
    ratio = heights[1] / heights[0]
    # Tops end up to two hundredths of a spacing before the bounds of the surface.
    check(abs(ratio - planes / (planes - 1)) < 0.05 / planes, f"half slices: {ratio} times as high")
    parallel.EndCaps = "Dome"
    parallel.Correspondence = "Spanning Tree"
    check_closed(fetch(parallel), components=1)
    parallel.ExpectedComponents = 2
    check(field_value(fetch(parallel), "NumberOfUndecidedPlaces") >= 0, "no undecided places")


def check_parallel_along_any_axis():
    """One stack takes the active source, a first argument, and slices across any direction."""
    slicer = simple.OrthogonalSlicer(Input=sphere(), NumberOfSlices=[12, 12, 12])
    ports = [simple.OutputPort(slicer, port) for port in range(3)]
    volumes = []
    for port in ports:
        simple.SetActiveSource(None if port is ports[2] else port)
        parallel = simple.ParallelSliceReconstruction(*([port] if port is ports[2] else []))
        check(parallel.Input is not None, "the active source is not taken")
        surface = fetch(parallel)
        check_closed(surface, components=1)
        check(field_value(surface, "NumberOfContours") == 12, "other contours")
        volumes.append(fetch(parallel, 7).GetColumnByName("Volume").GetValue(0))
    for turn in ([0.0, 50.0, 0.0], [35.0, 45.0, 0.0]):
        turned = simple.Transform(Input=simple.GroupDatasets(Input=[ports[2]]))
        turned.Transform.Rotate = turn
        parallel = simple.ParallelSliceReconstruction(Input=turned)
        check_closed(fetch(parallel), components=1)
        volumes.append(fetch(parallel, 7).GetColumnByName("Volume").GetValue(0))
    check(max(volumes) / min(volumes) < 1.001, f"the stacks of a ball have the volumes {volumes}")


def check_properties_of_parallel():
    """It has the same properties, texts and defaults, but those that need a second family."""
    slicer = simple.OrthogonalSlicer(Input=sphere())
    parallel = simple.ParallelSliceReconstruction(Input=simple.OutputPort(slicer, 2))
    rec = reconstruct_sliced(slicer)
    own, others = (set(proxy.ListProperties()) for proxy in (parallel, rec))
    check(own - others == {"Input"}, f"of its own: {own - others}")
    families = {"XSlices", "YSlices", "Contours", "CellArrayNames", "AxisWeights",
                "ReportTolerance", "FollowField", "SeveralCycles", "MinimumIsolatedContourSize",
                "ContourTolerance", "CentralPoint", "WarnOfMissingFamilies"}
    check(others - own == families, f"it lacks {others - own - families}, has {families & own}")
    for name in own & others - {"LabelArray", "ZSlices"}:
        values = [proxy.GetPropertyValue(name) for proxy in (parallel, rec)]
        check(str(values[0]) == str(values[1]), f"{name} is {values}")
        enums = [getattr(proxy.GetProperty(name), "Available", None) for proxy in (parallel, rec)]
        check(enums[0] == enums[1], f"{name} offers {enums}")
    smooth = fetch(parallel)
    simple.SetActiveSource(simple.Sphere())  # is no input, as ZSlices names another one
    named = simple.ParallelSliceReconstruction(ZSlices=simple.OutputPort(slicer, 2))
    check(fetch(named).GetNumberOfCells() == smooth.GetNumberOfCells(), "ZSlices is no Input")
    parallel.EdgeLength = 0.5
    check(fetch(parallel).GetNumberOfCells() < smooth.GetNumberOfCells(), "no coarser triangles")


def check_image():
    """An image with the defaults, and one of its labels."""
    wavelet = simple.Wavelet()
    wavelet.UpdatePipeline()
    slicer = simple.OrthogonalSlicer(Input=wavelet)
    bounds = wavelet.PointData["RTData"].GetRange()
    middle = (bounds[0] + bounds[1]) / 2
    check(abs(slicer.IsoValue - middle) < 1e-3, f"the iso-value starts at {slicer.IsoValue}")
    surface = fetch(reconstruct_sliced(slicer))
    check(surface.GetNumberOfCells() > 0, "no surface of the image")

    labels = simple.Calculator(Input=wavelet, ResultArrayName="Label",
        Function="(coordsX^2 + coordsY^2 + coordsZ^2 < 50) * 3")
    slicer = simple.OrthogonalSlicer(Input=labels, Scalars=["POINTS", "Label"], UseLabel=1,
        LabelValue=3)
    check_closed(fetch(reconstruct_sliced(slicer)), components=1)


RECTILINEAR = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
line = numpy.linspace(-1.0, 1.0, 21) * (0.5 + 0.5 * numpy.abs(numpy.linspace(-1.0, 1.0, 21)))
output.SetDimensions(21, 21, 21)
for name in "XYZ":
    getattr(output, f"Set{name}Coordinates")(numpy_to_vtk(line, deep=True))
z, y, x = numpy.meshgrid(line, line, line, indexing="ij")
for name, values in (("Inside", 0.5 - x * x - y * y - z * z), ("Height", z)):
    array = numpy_to_vtk(values.ravel(), deep=True)
    array.SetName(name)
    output.GetPointData().AddArray(array)
output.GetPointData().SetActiveScalars("Inside")
"""


def check_rectilinear():
    """A rectilinear grid is an input like an image, with its scalars; what points carry is passed on."""
    source = simple.ProgrammableSource(
        OutputDataSetType="vtkRectilinearGrid", Script=RECTILINEAR, ScriptRequestInformation=(
            "executive = self.GetExecutive()\n"
            "executive.GetOutputInformation(0).Set(executive.WHOLE_EXTENT(), 0, 20, 0, 20, 0, 20, )"))
    source.UpdatePipeline()
    slicer = simple.OrthogonalSlicer(Input=source, Scalars=["POINTS", "Inside"], IsoValue=0.0)
    check(slicer.SMProxy.GetProperty("Input").IsInDomains() == 1, "a rectilinear grid is no input")
    check_closed(fetch(reconstruct_sliced(slicer)), components=1)
    height = fetch(slicer, 2).GetPointData().GetArray("Height")
    # The highest plane of samples that the ball of radius 0.707 reaches.
    check(height is not None and abs(height.GetRange()[1] - 0.595) < 1e-3, "no heights on the contours")


def check_labels():
    """One surface for each label of an image, by the array that the panel lists."""
    labels = simple.Calculator(Input=simple.Wavelet(), ResultArrayName="Label",
        Function="(coordsX^2 + coordsY^2 + coordsZ^2 < 50) * if (coordsX < 0.5, 2, 5)")
    slicer = simple.OrthogonalSlicer(Input=labels, Scalars=["POINTS", "Label"], EveryLabel=1,
        NumberOfSlices=[21, 21, 21])
    slicer.UpdatePipeline()  # as Apply has, before the panel lists arrays
    rec = reconstruct_sliced(slicer)
    listed = rec.GetProperty("LabelArray").GetAvailable()
    check("Label" in listed and "None" in listed, f"Label Array offers {listed}")
    only = simple.OrthogonalSliceReconstruction(
        Contours=simple.OutputPort(slicer, 2))
    listed = only.GetProperty("LabelArray").GetAvailable()
    check("Label" in listed and "None" in listed, f"with one input, Label Array offers {listed}")
    rec.LabelArray = "Label"
    surface = fetch(rec)
    check_closed(surface, components=2)
    check(surface.GetCellData().GetArray("Label").GetRange() == (2.0, 5.0), "other labels")
    colored = surface.GetCellData().GetScalars()
    check(colored is not None and colored.GetName() == "Label", "ParaView does not color by labels")
    table = fetch(rec, 7)
    check(table.GetNumberOfRows() == 2, f"{table.GetNumberOfRows()} components in the table")
    volume = sum(table.GetColumnByName("Volume").GetValue(row) for row in range(2))
    samples = sum(x * x + y * y + z * z < 50
                  for x in range(-7, 8) for y in range(-7, 8) for z in range(-7, 8))
    check(abs(volume / samples - 1) < 0.05, f"{samples} samples, but the volume is {volume}")


def check_examples_find_the_plugin():
    """That of the build folder of the repository in which they lie."""
    example = pathlib.Path(__file__).resolve().parents[2] / "Plugin" / "Examples" / "ReconstructFiles.py"
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder).resolve()
        (root / "Plugin" / "Examples").mkdir(parents=True)
        shutil.copy(example, root / "Plugin" / "Examples")
        built = root / "build" / "demo" / "paraview" / "lib" / "plugins" / "OrthogonalSlices.so"
        built.parent.mkdir(parents=True)
        sys.path.insert(0, str(root / "Plugin" / "Examples"))
        import ReconstructFiles
        sys.path.pop(0)
        check(ReconstructFiles.find_plugin() is None, "a plugin is found where none is")
        built.touch()
        check(ReconstructFiles.find_plugin() == built, f"found: {ReconstructFiles.find_plugin()}")


def main(plugin, data):
    load_plugin(plugin, remote=False)
    check_examples_find_the_plugin()
    check_defaults()
    check_documentation()
    check_sphere()
    check_outputs()
    check_properties_reach_the_filters()
    check_views()
    check_inputs_left_out()
    check_one_input_for_all()
    check_composite()
    check_solid_cells()
    check_parallel()
    check_parallel_along_any_axis()
    check_properties_of_parallel()
    check_image()
    check_labels()
    check_heart(data)
    check_rectilinear()  # last, as ParaView's programmable sources put names of NumPy in place of ours
    print("plugin: all checks passed")


main(*sys.argv[1:3])
