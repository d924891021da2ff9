# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pvbatch TestBatch.py <plugin> <Data> <picture>, in one process or in several: the same surfaces,
and a picture of one."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview import simple

from PluginChecks import check, check_heart, check_sphere, load_plugin


def main(plugin, data, picture):
    load_plugin(plugin, remote=False)
    check_sphere()
    check_heart(data)

    if os.path.exists(picture):
        os.remove(picture)
    view = simple.CreateView("RenderView", ViewSize=[400, 300])
    simple.Show(simple.FindSource("OrthogonalSliceReconstruction2"), view)
    simple.ResetCamera(view)
    simple.SaveScreenshot(picture, view)
    check(os.path.getsize(picture) > 5000, "the picture is blank")
    print("batch: all checks passed")


main(*sys.argv[1:4])
