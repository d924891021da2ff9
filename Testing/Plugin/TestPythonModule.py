# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestPythonModule.py: the wrapped classes beside vtkmodules, without ParaView."""

from vtkmodules.vtkFiltersCore import vtkFeatureEdges
from vtkmodules.vtkFiltersSources import vtkSphereSource

from orthogonalslices.vtkFiltersOrthogonalSlices import (
    vtkOrthogonalSliceReconstruction,
    vtkOrthogonalSlicer,
)


def main():
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(48)
    sphere.SetPhiResolution(48)

    slicer = vtkOrthogonalSlicer()
    slicer.SetInputConnection(sphere.GetOutputPort())
    slicer.SetNumberOfSlices(16, 16, 16)

    reconstruction = vtkOrthogonalSliceReconstruction()
    for axis in range(3):
        reconstruction.SetInputConnection(axis, slicer.GetOutputPort(axis))
    reconstruction.SetOrientationToAsDrawn()
    assert reconstruction.GetOrientation() == reconstruction.ORIENT_AS_DRAWN

    edges = vtkFeatureEdges()
    edges.SetInputConnection(reconstruction.GetOutputPort())
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()

    surface = reconstruction.GetOutput()
    assert surface.GetNumberOfPolys() > 0, "the surface is empty"
    assert edges.GetOutput().GetNumberOfCells() == 0, "the surface is not closed"
    assert surface.GetFieldData().GetArray("NumberOfComponents").GetValue(0) == 1
    assert reconstruction.GetGraphOutput().GetNumberOfVerts() > 0
    assert reconstruction.GetHistogramOutput().GetNumberOfRows() > 0


main()
