# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces written as STL, OBJ, PLY or VTP, or drawn into a label image on a given grid."""

import os
import re

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from .Images import first_sample, make_image, samples_of, steps_of
from .Stencil import samples_inside
from .Structures import FormatError

ENDINGS = (".stl", ".obj", ".ply", ".vtp")
MOST_SAMPLES = 2**31
WHITE = (255, 255, 255)


def write_surfaces(surfaces, path):
    """Writes pairs of a structure and its surface; returns the names of the files. A .vtp has all
    of them, told apart by the cell array Label; of the others each surface gets a file of its own,
    with the structure's name in the file's if there are several."""
    end = os.path.splitext(path)[1].lower()
    if end == ".vtp":
        write(labelled(surfaces), path)
        return [path]
    if len(surfaces) == 1:
        write(surfaces[0][1], path)
        return [path]
    names = []
    for structure, surface in surfaces:
        name = re.sub(r"[^\w.+-]+", "_", structure.name).strip("_") or str(structure.label)
        name = os.path.splitext(path)[0] + "-" + name + end
        name = name if name not in names else f"{os.path.splitext(name)[0]}-{structure.label}{end}"
        write(surface, name)
        names.append(name)
    return names


def write_contours(structures, path):
    """The contours of all structures in one .vtp, with the cell array Label."""
    write(labelled([(structure, piece) for structure in structures
                    for piece in structure.contours() if piece.GetNumberOfLines() > 0]), path)


def write(surface, path):
    end = os.path.splitext(path)[1].lower()
    writers = {".stl": vtkSTLWriter, ".obj": vtkOBJWriter, ".ply": vtkPLYWriter,
               ".vtp": vtkXMLPolyDataWriter}
    if end not in writers:
        raise FormatError(f"{path}: surfaces are written as {', '.join(ENDINGS)}.")
    writer = writers[end]()
    if end in (".stl", ".ply"):
        writer.SetFileTypeToBinary()
    if end == ".vtp":
        writer.SetDataModeToBinary() # ParaView 5.11 of Debian cannot read appended data back
    writer.SetFileName(path)
    writer.SetInputData(surface)
    if not writer.Write():
        raise FormatError(f"{path} cannot be written.")


def labelled(surfaces):
    """All surfaces in one, with the cell array Label (and Color, if the file has colours), and the
    labels and names as field data. A structure may come several times."""
    append = vtkAppendPolyData()
    labels, names = vtkIntArray(), vtkStringArray()
    labels.SetName("Labels")
    names.SetName("Names")
    for structure, surface in surfaces:
        part = vtkPolyData()
        part.ShallowCopy(surface)
        add_constant(part, "Label", numpy.int32(structure.label))
        if any(one.color for one, _ in surfaces):
            add_constant(part, "Color", numpy.array(structure.color or WHITE, dtype=numpy.uint8))
        append.AddInputData(part)
    for label, name in {structure.label: structure.name for structure, _ in surfaces}.items():
        labels.InsertNextValue(label)
        names.InsertNextValue(name)
    append.Update()
    result = append.GetOutput()
    if len(surfaces) == 1:
        result.SetFieldData(surfaces[0][1].GetFieldData())
    result.GetFieldData().AddArray(labels)
    result.GetFieldData().AddArray(names)
    return result


def add_constant(data, name, value):
    """A cell array with the same value everywhere."""
    values = numpy.repeat(numpy.atleast_2d(value), data.GetNumberOfCells(), axis=0)
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.GetCellData().AddArray(array)


# --------------------------------------------------------------------------------------------------
# Label images

def make_grid(surfaces, spacing):
    """An empty grid of cubes around all surfaces, with a sample more than needed on each side."""
    boxes = numpy.array([surface.GetBounds() for _, surface in surfaces]).reshape(-1, 3, 2)
    low, high = boxes[:, :, 0].min(axis=0) - spacing, boxes[:, :, 1].max(axis=0) + spacing
    counts = numpy.ceil((high - low) / spacing).astype(numpy.int64) + 1
    if counts.prod() > MOST_SAMPLES:
        raise FormatError(f"A grid of {spacing:g} has {' x '.join(map(str, counts))} samples: too "
                          "many.")
    return make_image(numpy.zeros(counts[::-1], dtype=numpy.uint8), spacing * numpy.eye(3), low)


def draw_labels(surfaces, grid):
    """A label image on the grid of another image: samples inside a surface get its label. Where two
    surfaces overlap, the later one is drawn over the earlier."""
    steps, origin = steps_of(grid), first_sample(grid)
    highest = max(structure.label for structure, _ in surfaces)
    kind = numpy.uint8 if highest < 256 else numpy.uint16 if highest < 65536 else numpy.int32
    labels = numpy.zeros(samples_of(grid).shape, dtype=kind)
    to_indices = numpy.linalg.inv(steps)
    for structure, surface in surfaces:
        inside = samples_inside(moved(surface, to_indices, origin), labels.shape)
        labels[inside] = structure.label
    return make_image(labels, steps, origin)


def moved(surface, matrix, origin):
    """The triangles alone, with `origin` moved to 0 and then multiplied by a matrix."""
    points = (vtk_to_numpy(surface.GetPoints().GetData()) - origin) @ matrix.T
    data, places = vtkPolyData(), vtkPoints()
    places.SetData(numpy_to_vtk(numpy.ascontiguousarray(points), deep=True))
    data.SetPoints(places)
    data.SetPolys(surface.GetPolys())
    return data
