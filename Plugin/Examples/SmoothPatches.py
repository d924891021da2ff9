# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
r"""Reconstruct an object with fans and with smooth patches, and save a picture of both:

    pvpython SmoothPatches.py x.vtp y.vtp z.vtp picture.png [OrthogonalSlices.so [width]]

The files hold contours on planes of constant x, y and z. Highlights show the slightest bend of a
surface: on the left, with the paper's fans, they show the grid of the slices; on the right, with
smooth patches (the default), only the object. ParaView needs a display; without one, put xvfb-run -a
-s -noreset in front.
"""

import sys

from paraview import simple

import ReconstructFiles as example


def main(x, y, z, picture, plugin=None, width=1600):
    example.load_plugin(plugin)
    _, fans = example.reconstruct((x, y, z))
    fans.PatchType = "Fan"
    fans.UpdatePipeline()
    _, smooth = example.reconstruct((x, y, z))
    layout = simple.CreateLayout("Smooth patches")
    size = [int(width), int(width) // 2]
    views = [example.make_view() for _ in range(2)]
    for surface, view in zip((fans, smooth), views):
        example.show(surface, view, example.SURFACE, Specular=0.8, SpecularPower=30.0, Ambient=0.1)
        view.CenterAxesVisibility = 0
        view.CameraPosition = [1.0, -2.0, 0.8]
        view.CameraFocalPoint = [0.0, 0.0, 0.0]
        view.CameraViewUp = [0.0, 0.0, 1.0]
    layout.AssignView(0, views[0])
    layout.SplitHorizontal(0, 0.5)
    layout.AssignView(2, views[1])
    layout.SetSize(*size)
    for view in views:
        simple.ResetCamera(view)
        view.GetActiveCamera().Zoom(1.4)
    example.save_screenshot(picture, layout, size)


if __name__ == "__main__":
    if len(sys.argv) not in (5, 6, 7):
        sys.exit(__doc__)
    main(*sys.argv[1:])
