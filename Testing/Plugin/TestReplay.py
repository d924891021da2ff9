# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pvpython TestReplay.py <plugin> <Macros>: what ParaView records gives the same surface when it is
played again: traces, state files, states as scripts; and animations give that of each time. At last
the inspection view of turned slices, of one stack, and of a pipeline without any."""

import os
import pathlib
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview import servermanager, simple, smstate, smtrace
from vtkmodules.util.numpy_support import vtk_to_numpy

from PluginChecks import check, field_value, load_plugin, reconstruct_sliced, sphere

SLICES = [7, 8, 9]


def fingerprint(proxy):
    """All bytes of the points and triangles of a surface."""
    data = servermanager.Fetch(proxy, idx=0)
    check(data.GetNumberOfCells() > 0, "the surface is empty")
    return (vtk_to_numpy(data.GetPoints().GetData()).tobytes(),
            vtk_to_numpy(data.GetPolys().GetConnectivityArray()).tobytes())


def pipeline():
    slicer = simple.OrthogonalSlicer(Input=sphere(), NumberOfSlices=SLICES)
    result = reconstruct_sliced(slicer, PatchType="Coons", AxisWeights=[1.0, 2.0, 0.5])
    result.UpdatePipeline()
    return result


def reconstruction():
    found = [proxy for proxy in simple.GetSources().values()
             if proxy.SMProxy.GetXMLName() == "OrthogonalSliceReconstruction"]
    check(len(found) == 1, f"{len(found)} reconstructions are back")
    return found[0]


def check_again(expected, how):
    """The pipeline as it has come back, and its reset for the next way."""
    result = reconstruction()
    check(list(result.AxisWeights) == [1.0, 2.0, 0.5], f"{how}: weights {result.AxisWeights}")
    check(fingerprint(result) == expected, f"{how}: another surface")
    simple.ResetSession()


def check_trace(plugin):
    smtrace.start_trace()
    expected = fingerprint(pipeline())
    text = smtrace.stop_trace()
    simple.ResetSession()
    check("OrthogonalSliceReconstruction(" in text, f"the trace is\n{text}")
    exec(text, {})
    check_again(expected, "trace")
    return expected


def check_state(expected):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "state.pvsm")
        pipeline()
        simple.SaveState(path)
        simple.ResetSession()
        simple.LoadState(path)
        check_again(expected, "state file")
    pipeline()
    text = smstate.get_state()
    simple.ResetSession()
    exec(text, {})
    check_again(expected, "state as a script")


def check_animation():
    """Contours of a ball that grows: at each time of the animation, the surface of that time."""
    radii = (1.0, 1.5, 2.0)
    with tempfile.TemporaryDirectory() as folder:
        entries = []
        for time, radius in enumerate(radii):
            slicer = simple.OrthogonalSlicer(Input=sphere(radius), NumberOfSlices=SLICES)
            group = simple.MergeBlocks(Input=simple.GroupDatasets(
                Input=[simple.OutputPort(slicer, port) for port in range(3)]), OutputDataSetType="Polygonal Mesh")
            name = f"{time}.vtp"
            simple.SaveData(os.path.join(folder, name), group, DataMode="Binary")
            entries.append(f'<DataSet timestep="{time}" file="{name}"/>')
        path = pathlib.Path(folder) / "ball.pvd"
        path.write_text('<VTKFile type="Collection" version="0.1"><Collection>'
                        + "".join(entries) + "</Collection></VTKFile>")
        simple.ResetSession()
        result = simple.OrthogonalSliceReconstruction(Contours=simple.PVDReader(FileName=str(path)))
        simple.CreateRenderView()
        simple.Show(result)
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        check(list(scene.TimeKeeper.TimestepValues) == [0.0, 1.0, 2.0],
              f"the time steps are {scene.TimeKeeper.TimestepValues}")
        for time in (0, 1, 2, 1, 0):
            scene.AnimationTime = time
            bounds = result.GetDataInformation(0).GetBounds()
            check(abs(bounds[1] - radii[time]) < 0.1 * radii[time],
                  f"at time {time} the ball reaches to {bounds[1]}")
    simple.ResetSession()


def check_inspection(macros):
    """The macro opens its view for turned slices and for one stack, and says if there is nothing."""
    code = (pathlib.Path(macros) / "Inspect Slices.py").read_text()
    try:
        exec(code, {})
    except RuntimeError as error:
        check("There is no" in str(error), f"an empty pipeline: {error}")
    else:
        check(False, "an empty pipeline can be inspected")
    slicer = simple.OrthogonalSlicer(Input=sphere(), NumberOfSlices=SLICES)
    turned = simple.Transform(Input=simple.GroupDatasets(
        Input=[simple.OutputPort(slicer, port) for port in range(3)]))
    turned.Transform.Rotate = [10.0, 20.0, 30.0]
    for result in (simple.OrthogonalSliceReconstruction(Contours=turned),
                   simple.ParallelSliceReconstruction(Input=simple.OutputPort(slicer, 2))):
        result.UpdatePipeline()
        simple.SetActiveSource(result)
        before = len(simple.GetViews())
        exec(code, {})
        check(len(simple.GetViews()) == before + 3, "the inspection view has not three views")
        drawn = simple.FindSource("WorstSliceAsDrawn")
        check(servermanager.Fetch(drawn).GetNumberOfCells() == 1, "the worst slice is not one contour")
        simple.Delete(drawn)


def main(plugin, macros):
    load_plugin(plugin, remote=False)
    expected = check_trace(plugin)
    check_state(expected)
    check_animation()
    check_inspection(macros)
    print("replay: all checks passed")


main(*sys.argv[1:3])
