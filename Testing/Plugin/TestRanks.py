# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""mpirun -np N pvbatch --mpi TestRanks.py <plugin> <Data> <folder>: the pieces of N processes are
the surface of one, and filters and writers after it work on them."""

import os
import shutil
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import numpy
from paraview import servermanager, simple
from paraview.vtk.numpy_interface import dataset_adapter
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from PluginChecks import check, check_closed, fetch, load_plugin, reconstruct


def arrays_of(attributes):
    """The values of all arrays by their names."""
    return {name: numpy.asarray(attributes[name]) for name in attributes.keys()}


def triangles_of(surface):
    return numpy.asarray(surface.Polygons).reshape(-1, 4)[:, 1:]


def read_pieces(path):
    """What each process has written of a surface."""
    folder = os.path.splitext(path)[0]
    pieces = []
    for name in sorted(os.listdir(folder), key=lambda n: int(n.rsplit("_", 1)[1].split(".")[0])):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(os.path.join(folder, name))
        reader.Update()
        pieces.append(dataset_adapter.WrapDataObject(reader.GetOutput()))
    return pieces


def unite(pieces, whole):
    """Puts points, triangles and their arrays in the places that their global ids name, and checks
    that this gives the whole."""
    seen_points = numpy.zeros(whole.GetNumberOfPoints(), int)
    seen_cells = numpy.zeros(whole.GetNumberOfCells(), int)
    of_points, of_cells = arrays_of(whole.PointData), arrays_of(whole.CellData)
    triangles = triangles_of(whole)
    for piece in pieces:
        if piece.GetNumberOfCells() == 0:
            continue
        points = numpy.asarray(piece.PointData["GlobalPointIds"])
        cells = numpy.asarray(piece.CellData["GlobalCellIds"])
        own = numpy.asarray(piece.PointData["vtkGhostType"]) == 0
        seen_points[points[own]] += 1
        seen_cells[cells] += 1
        same = numpy.array_equal(piece.Points, whole.Points[points])
        check(same, "a point of a piece is another one")
        same = numpy.array_equal(points[triangles_of(piece)], triangles[cells])
        check(same, "a triangle of a piece is another one")
        for name, values in of_points.items():
            same = numpy.array_equal(piece.PointData[name], values[points])
            check(same, f"{name} of points differs")
        for name, values in of_cells.items():
            same = numpy.array_equal(piece.CellData[name], values[cells])
            check(same, f"{name} of triangles differs")
    check((seen_points == 1).all(), "a point belongs to no piece, or to several")
    check((seen_cells == 1).all(), "a triangle is in no piece, or in several")


def divided(files, folder):
    """Readers of the same contours in several pieces of unequal size, which each process reads some
    of."""
    readers = []
    for axis, name in zip("xyz", files):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(name)
        reader.Update()
        whole = reader.GetOutput()
        count = whole.GetNumberOfLines()
        ends = [0, count // 7, count // 2, count // 2, count]
        path = os.path.join(folder, f"divided_{axis}.pvtp")
        names = []
        for number, (first, last) in enumerate(zip(ends, ends[1:])):
            names.append(f"divided_{axis}_{number}.vtp")
            part = vtkPolyData()
            part.SetPoints(whole.GetPoints())
            cells = vtkCellArray()
            ids = vtkIdList()
            for line in range(first, last):
                whole.GetLines().GetCellAtId(line, ids)
                cells.InsertNextCell(ids)
            part.SetLines(cells)
            writer = vtkXMLPolyDataWriter()
            writer.SetFileName(os.path.join(folder, names[-1]))
            writer.SetInputData(part)
            writer.Write()
        kind = {10: "Float32", 11: "Float64"}[whole.GetPoints().GetDataType()]
        with open(path, "w", encoding="ascii") as file:
            file.write('<VTKFile type="PPolyData" version="1.0" byte_order="LittleEndian" '
                'header_type="UInt32"><PPolyData GhostLevel="0"><PPoints>'
                f'<PDataArray type="{kind}" NumberOfComponents="3"/></PPoints>'
                + "".join(f'<Piece Source="{name}"/>' for name in names)
                + "</PPolyData></VTKFile>")
        readers.append(simple.XMLPartitionedPolydataReader(FileName=[path]))
    return readers


def check_downstream(surface, whole):
    """Filters that work process by process, and those that redistribute, with the whole's results."""
    area = fetch(simple.IntegrateVariables(Input=surface)).GetCellData().GetArray("Area").GetValue(0)
    points, triangles = numpy.asarray(whole.Points, float), triangles_of(whole)
    corners = [points[triangles[:, k]] for k in range(3)]
    sides = numpy.cross(corners[1] - corners[0], corners[2] - corners[0])
    expected = 0.5 * numpy.linalg.norm(sides, axis=1).sum()
    check(abs(area / expected - 1) < 1e-9, f"the area is {area}, not {expected}")

    spread = simple.RedistributeDataSet(Input=surface)
    spread.UpdatePipeline()
    cells = spread.GetDataInformation().GetNumberOfCells()
    check(cells == len(triangles), f"{cells} triangles after redistribution")

    if servermanager.ActiveConnection.GetNumberOfDataPartitions() > 1:
        ghosts = simple.GhostCellsGenerator(Input=surface)
        ghosts.UpdatePipeline()
        check(ghosts.GetDataInformation().GetNumberOfCells() > len(triangles), "no ghost cells")


def main(plugin, data, folder):
    """The run with one process leaves the surface that the others are compared with."""
    load_plugin(plugin, remote=False)
    count = servermanager.ActiveConnection.GetNumberOfDataPartitions()
    files = [os.path.join(data, "heart", f"n32_{axis}.vtp") for axis in "xyz"]
    surface = reconstruct(*[simple.XMLPolyDataReader(FileName=[name]) for name in files])
    surface.UpdatePipeline()
    shutil.rmtree(os.path.join(folder, f"ranks{count}"), ignore_errors=True)
    path = os.path.join(folder, f"ranks{count}.pvtp")
    simple.SaveData(path, proxy=surface)
    whole = read_pieces(os.path.join(folder, "ranks1.pvtp"))[0]
    if count > 1:
        pieces = read_pieces(path)
        check(len(pieces) == count, f"{len(pieces)} pieces of {count} processes")
        unite(pieces, whole)
        check_closed(fetch(surface), components=1, genus=1)
        # A piece of the file for each process: the same surface from contours that are divided.
        again = reconstruct(*divided(files, folder))
        again.UpdatePipeline()
        simple.SaveData(os.path.join(folder, f"again{count}.pvtp"), proxy=again)
        unite(read_pieces(os.path.join(folder, f"again{count}.pvtp")), whole)
    check_downstream(surface, whole)
    print(f"{count} processes: all checks passed")


main(*sys.argv[1:4])
