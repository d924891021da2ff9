# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
r"""Reconstruct a surface from three files of contours, save it and a picture of it:

    pvpython ReconstructFiles.py x.vtp y.vtp z.vtp surface.vtp picture.png \
        [OrthogonalSlices.so [width]]

The files hold contours on planes of constant x, y and z. The picture shows the contours on the left
and the surface on the right; it is 1600 pixels wide, or as wide as is said. Without the path of the
plugin, it is the one that ParaView lists (PV_PLUGIN_PATH names its folder), or that of a build folder of
the repository. ParaView needs a display; without one, put xvfb-run -a -s -noreset in front.
"""

import pathlib
import sys

from paraview import servermanager, simple

BACKGROUND = [1.0, 1.0, 1.0]
SURFACE = [0.89, 0.80, 0.66]
AXES = [[0.80, 0.22, 0.18], [0.16, 0.55, 0.25], [0.18, 0.36, 0.72]]
ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILDS = ("build/paraview", "build/demo/paraview")


def find_plugin():
    """The plugin in the build folders of the repository that this file lies in; None if there is none."""
    found = (path for build in BUILDS for path in (ROOT / build / "lib").rglob("OrthogonalSlices.so"))
    return next(found, None)


def load_plugin(path=None):
    """The plugin at the path, the one that ParaView lists, or that of a build folder."""
    if not path and hasattr(simple, "OrthogonalSliceReconstruction"):
        return
    if not path:
        try:
            simple.LoadDistributedPlugin("OrthogonalSlices", remote=False, ns=simple.__dict__)
            return
        except RuntimeError:  # ParaView lists none
            path = find_plugin()
            if not path:
                raise
    simple.LoadPlugin(str(path), remote=False, ns=simple.__dict__)


def reconstruct(files):
    readers = [simple.XMLPolyDataReader(FileName=[name]) for name in files]
    surface = simple.OrthogonalSliceReconstruction(
        XSlices=readers[0], YSlices=readers[1], ZSlices=readers[2])
    surface.UpdatePipeline()
    return readers, surface


def report(surface):
    data = servermanager.Fetch(surface, idx=0)
    print(f"{data.GetNumberOfPoints()} points, {data.GetNumberOfCells()} triangles")
    fields = data.GetFieldData()
    for index in range(fields.GetNumberOfArrays()):
        array = fields.GetArray(index)
        if array and array.GetNumberOfTuples() == 1:
            print(f"{array.GetName()}: {array.GetValue(0)}")


def make_view():
    view = simple.CreateRenderView()
    view.UseColorPaletteForBackground = 0
    view.Background = BACKGROUND
    view.OrientationAxesVisibility = 0
    return view


def show(source, view, color, **properties):
    display = simple.Show(simple.OutputPort(source, 0), view)
    display.SetScalarColoring(None, 0)
    display.AmbientColor = display.DiffuseColor = color
    for name, value in properties.items():
        setattr(display, name, value)


def save_screenshot(picture, layout, size):
    options = {"CompressionLevel": "9"} if picture.endswith(".png") else {}
    simple.SaveScreenshot(picture, layout, ImageResolution=size, **options)


def save_picture(readers, surface, picture, size):
    """Both views look from the same place: obliquely, with z upwards."""
    contours, result = make_view(), make_view()
    for reader, color in zip(readers, AXES):
        show(reader, contours, color, LineWidth=2.0)
    show(surface, result, SURFACE, Specular=0.2)
    for view in (contours, result):
        view.CameraPosition = [1.0, -2.0, 0.8]
        view.CameraFocalPoint = [0.0, 0.0, 0.0]
        view.CameraViewUp = [0.0, 0.0, 1.0]
        simple.ResetCamera(view)
        view.CenterAxesVisibility = 0

    layout = simple.CreateLayout("Picture")
    layout.AssignView(0, contours)
    layout.SplitHorizontal(0, 0.5)
    layout.AssignView(2, result)
    layout.SetSize(*size)
    for view in (contours, result):
        simple.ResetCamera(view)
        view.GetActiveCamera().Zoom(1.4)
    save_screenshot(picture, layout, size)


def main(x, y, z, surface_file, picture, plugin=None, width=1600):
    load_plugin(plugin)
    readers, surface = reconstruct((x, y, z))
    report(surface)
    # Appended data, the default, cannot be read again by Debian's ParaView with today's expat.
    options = {"DataMode": "Binary"} if surface_file.endswith(".vtp") else {}
    simple.SaveData(surface_file, proxy=simple.OutputPort(surface, 0), **options)
    save_picture(readers, surface, picture, [int(width), int(width) // 2])


if __name__ == "__main__":
    if len(sys.argv) not in (6, 7, 8):
        sys.exit(__doc__)
    main(*sys.argv[1:])
