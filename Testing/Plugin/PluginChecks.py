# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the plugin has to do wherever it is loaded: shared by the tests of pvpython, pvbatch and
pvserver. Every check raises AssertionError with a sentence."""

import math
import os

import numpy
from paraview import servermanager, simple
from paraview.vtk.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties


def check(condition, sentence):
    if not condition:
        raise AssertionError(sentence)


def load_plugin(path, remote):
    """Loads the plugin and gives paraview.simple its functions."""
    simple.LoadPlugin(path, remote=remote, ns=simple.__dict__)
    for name in ("OrthogonalSlicer", "OrthogonalSliceReconstruction"):
        check(hasattr(simple, name), f"the plugin gave paraview.simple no {name}")


def reconstruct(x, y, z, **properties):
    return simple.OrthogonalSliceReconstruction(XSlices=x, YSlices=y, ZSlices=z, **properties)


def reconstruct_sliced(slicer, **properties):
    ports = [simple.OutputPort(slicer, name) for name in ("XSlices", "YSlices", "ZSlices")]
    return reconstruct(*ports, **properties)


def sphere(radius=1.0):
    return simple.Sphere(Radius=radius, ThetaResolution=64, PhiResolution=64)


def fetch(proxy, port=0):
    """An output of all processes; the pieces of a surface are joined at the points that they have
    in common."""
    data = servermanager.Fetch(proxy, idx=port)
    has_ids = data.IsA("vtkPolyData") and data.GetPointData().GetGlobalIds() is not None
    return weld(data) if has_ids else data


def weld(pieces):
    """A surface of triangles with one point for each global id."""
    source = dataset_adapter.WrapDataObject(pieces)
    ids = numpy.asarray(pieces.GetPointData().GetGlobalIds())
    _, first, places = numpy.unique(ids, return_index=True, return_inverse=True)
    surface = dataset_adapter.WrapDataObject(vtkPolyData())
    surface.Points = source.Points[first]
    for name in source.PointData.keys():
        surface.PointData.append(source.PointData[name][first], name)
    if "Normals" in source.PointData.keys():
        surface.VTKObject.GetPointData().SetActiveNormals("Normals")
    triangles = numpy.asarray(source.Polygons).reshape(-1, 4).copy()
    triangles[:, 1:] = places[triangles[:, 1:]]
    cells = vtkCellArray()
    cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True))
    surface.VTKObject.SetPolys(cells)
    surface.VTKObject.GetCellData().ShallowCopy(pieces.GetCellData())
    surface.VTKObject.SetFieldData(pieces.GetFieldData())
    return surface.VTKObject


def field_value(data, name):
    array = data.GetFieldData().GetArray(name)
    check(array is not None, f"the surface has no field data {name}")
    return array.GetValue(0)


def check_closed(surface, components, genus=0):
    """A closed 2-manifold with the Euler number of so many components and handles."""
    check(surface.GetNumberOfCells() > 0, "the surface is empty")
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    loose = edges.GetOutput().GetNumberOfCells()
    check(loose == 0, f"{loose} edges of the surface are open or have more than two triangles")

    used, pairs = set(), set()
    for cell in range(surface.GetNumberOfCells()):
        ids = surface.GetCell(cell).GetPointIds()
        check(ids.GetNumberOfIds() == 3, f"cell {cell} is no triangle")
        corners = [ids.GetId(k) for k in range(3)]
        used.update(corners)
        for k in range(3):
            pair = (corners[k], corners[(k + 1) % 3])
            check(pair not in pairs, f"triangles on both sides of {pair} disagree on outside")
            pairs.add(pair)
    euler = len(used) - len(pairs) // 2 + surface.GetNumberOfCells()
    check(euler == 2 * components - 2 * genus, f"Euler number {euler}")
    found = field_value(surface, "NumberOfComponents")
    check(found == components, f"NumberOfComponents is {found}, not {components}")


def volume(surface):
    mass = vtkMassProperties()
    mass.SetInputData(surface)
    return mass.GetVolume()


def check_sphere():
    """From a source to the surface with nothing but defaults."""
    slicer = simple.OrthogonalSlicer(Input=sphere())
    surface = fetch(reconstruct_sliced(slicer))
    check_closed(surface, components=1)
    error = volume(surface) / (4 / 3 * math.pi) - 1
    check(abs(error) < 0.01, f"the sphere's volume is off by {100 * error:.2f} %")
    check(surface.GetPointData().GetNormals() is not None, "the surface has no normals")
    for name in ("ComponentId", "GridCell", "PolygonSize"):
        check(surface.GetCellData().HasArray(name), f"the surface has no cell data {name}")
    return surface


def check_heart(data):
    """Real contours from three files: the ventricles of a heart, one piece with one handle."""
    files = [os.path.join(data, "heart", f"n32_{axis}.vtp") for axis in "xyz"]
    readers = [simple.XMLPolyDataReader(FileName=[name]) for name in files]
    check_closed(fetch(reconstruct(*readers)), components=1, genus=1)
