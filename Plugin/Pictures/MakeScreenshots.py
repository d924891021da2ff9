# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pictures of ParaView's window that the tutorial and the help pages show.

    python3 Plugin/Pictures/MakeScreenshots.py PLUGIN [FOLDER]

Works the window as the tutorial says, on a display of its own (Xvfb), and takes the pictures from the
screen: into FOLDER, by default that of this script. PLUGIN is OrthogonalSlices.so. Needs NumPy and
ParaView's Python modules, which Debian's python3 has after Testing/install-dependencies.sh.
"""

import pathlib
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT / "Testing" / "Plugin"))

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from ParaViewWindow import PANEL, Window, apply, event, macro, menu, picture, write_png

DIALOG = "pqClientMainWindow/SelectInputDialog"
FAMILIES = ("XSlices", "YSlices", "ZSlices")
SIZE = (1180, 780)  # of the display; the window that ParaView's player opens is 1152 wide
LOOK = """
from paraview import simple
view = simple.GetActiveView()
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [1.0, -2.0, 0.8], [0, 0, 0], [0, 0, 1]
simple.ResetCamera(view)
view.GetActiveCamera().Zoom(1.3)
simple.Render(view)
"""
GRAPH = """
from paraview import simple
view = simple.GetActiveView()
result = simple.GetActiveSource()
simple.Hide(result, view)
graph = simple.OutputPort(result, 1)
simple.Show(graph, view)
simple.SetActiveSource(graph)
simple.Render(view)
"""


def move_slice(source, target, number, shift):
    """A copy of a file with one of its planes of constant y moved, as if the patient had."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(source))
    reader.Update()
    data = reader.GetOutput()
    points = data.GetPoints()
    planes = sorted({round(points.GetPoint(i)[1], 6) for i in range(points.GetNumberOfPoints())})
    for i in range(points.GetNumberOfPoints()):
        place = points.GetPoint(i)
        if round(place[1], 6) == planes[number]:
            points.SetPoint(i, [a + b for a, b in zip(place, shift)])
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(target))
    writer.SetInputData(data)
    writer.SetDataModeToBinary()
    writer.Write()


def open_file(path):
    return [menu("menu_File", "actionFileOpen"),
            event("pqClientMainWindow/FileOpenDialog", "filesSelected", str(path)), apply()]


def choose_inputs(places):
    """Fills in the dialog that asks for the three inputs: their places in its tree."""
    steps = [menu("menuFilters", "OrthogonalSliceReconstruction", "Orthogonal Slices")]
    for family, place in zip(FAMILIES, places):
        steps += [event(f"{DIALOG}/buttonFrame/{family}", "set_boolean", "true"),
                  event(f"{DIALOG}/pipelineView", "currentChanged", place)]
    return steps


def accept():
    return event(f"{DIALOG}/buttonBox/1QPushButton0", "activate")


def reconstruct_files(files):
    """From three files to the surface, its graph, the inspection view and the help page."""
    steps = [step for file in files for step in open_file(file)]
    steps += choose_inputs(("/0/0|0", "/0/1|0", "/0/2|0"))
    steps += [picture("inputs"), accept(), apply(), macro("Look"), picture("message"),
              menu("menu_View", "Output Messages"), picture("surface"), macro("Graph"), picture("graph"), macro("Inspect Slices"), picture("inspect"),
              event(f"{PANEL}/Help", "activate"), picture("help")]
    return steps, ("inputs", "message", "surface", "graph", "inspect", "help")


def slice_model(model):
    """From a model to its contours, and from one family of these to a surface."""
    steps = open_file(model)
    steps += [menu("menuFilters", "OrthogonalSlicer", "Orthogonal Slices"), apply(), macro("Look"),
              picture("slicer"),
              event("pqClientMainWindow/pipelineBrowserDock/pipelineBrowser", "currentChanged",
                    "/0/0/0/2|0"),
              menu("menuFilters", "ParallelSliceReconstruction", "Orthogonal Slices"), apply(),
              picture("stack")]
    return steps, ("slicer", "stack")


def main(plugin, folder=HERE):
    window = Window(plugin, macros=[ROOT / "Plugin" / "Macros"], size=SIZE)
    data = ROOT / "Data" / "heart"
    with tempfile.TemporaryDirectory() as scratch:
        moved = pathlib.Path(scratch) / "moved_y.vtp"
        move_slice(data / "n32_y.vtp", moved, 15, (0.012, 0.0, 0.008))
        files = [data / "n32_x.vtp", moved, data / "n32_z.vtp"]
        for steps, names in (reconstruct_files(files), slice_model(data / "truth.vtp")):
            for name, pixels in window.play(steps, names, {"Look": LOOK, "Graph": GRAPH}).items():
                path = pathlib.Path(folder) / f"{name}.png"
                write_png(path, pixels)
                print(f"{path}: {path.stat().st_size // 1000} kB")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
