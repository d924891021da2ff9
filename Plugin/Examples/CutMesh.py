# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
r"""How many slices does my model need? Cuts a closed mesh on x-, y- and z-planes, makes the surface of
the cuts, and says how far it is from the mesh:

    python3 CutMesh.py model.stl surface.stl --slices 12 24 48

    --slices N [N ...]  planes on each axis; with several numbers a line for each of them, and the
                        surface of the last one (default 16 32)
    --stack AXIS        only the planes across x, y or z

Meshes are read from .stl, .obj, .ply and .vtp, surfaces written as the same. Points that an .stl
has several times are merged.
"""

import os
import sys

import numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkCellLocator, vtkGenericCell
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from Formats import Surfaces
from Formats.Command import parser_of, status_of
from Formats.Filter import load_filters, load_package
from Formats.Structures import FormatError, run

READERS = {".stl": vtkSTLReader, ".obj": vtkOBJReader, ".ply": vtkPLYReader,
           ".vtp": vtkXMLPolyDataReader}


def read_mesh(path):
    """The triangles of a file."""
    end = os.path.splitext(path)[1].lower()
    if end not in READERS:
        raise FormatError(f"{path}: meshes are read from {', '.join(READERS)}.")
    reader = READERS[end]()
    reader.SetFileName(path)
    run(reader)
    clean = vtkCleanPolyData()
    clean.SetInputData(reader.GetOutput())
    clean.SetTolerance(0.0)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(clean.GetOutputPort())
    run(triangles)
    return triangles.GetOutput()


def cut(mesh, planes):
    """Contours across x, y and z, on so many planes each."""
    slicer = load_filters().vtkOrthogonalSlicer()
    slicer.SetInputData(mesh)
    slicer.SetNumberOfSlices(planes, planes, planes)
    run(slicer)
    return [slicer.GetOutput(axis) for axis in range(3)]


def distances(points, mesh):
    """How far points are from a mesh."""
    locator = vtkCellLocator()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    nearest, cell = [0.0] * 3, vtkGenericCell()
    found = []
    for point in points:
        square = reference(0.0)
        locator.FindClosestPoint(point, nearest, cell, reference(0), reference(0), square)
        found.append(float(square) ** 0.5)
    return numpy.array(found)


def main(arguments):
    parser = parser_of(arguments, "CutMesh.py MESH OUT [options]", __doc__)
    parser.add_argument("mesh")
    parser.add_argument("out")
    parser.add_argument("--slices", type=int, nargs="+", default=[16, 32])
    parser.add_argument("--stack", choices=("x", "y", "z"))
    options = parser.parse_args(arguments)

    def compare():
        reconstruct = load_package().reconstruct
        mesh = read_mesh(options.mesh)
        diagonal = mesh.GetLength()
        print("planes  triangles  components  genus  RMS / diagonal  greatest / diagonal")
        for planes in options.slices:
            slices = dict(zip("xyz", cut(mesh, planes)))
            if options.stack:
                slices = {options.stack: slices[options.stack]}
            points, triangles, report = reconstruct(**slices)
            off = distances(points, mesh) / diagonal
            print(f"{planes:6} {len(triangles):10} {report.fields['NumberOfComponents']:11} "
                  f"{report.fields['TotalGenus']:6} {numpy.sqrt(numpy.mean(off**2)):15.2e} "
                  f"{off.max():20.2e}")
        Surfaces.write(report.surface, options.out)

    return status_of(compare)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
