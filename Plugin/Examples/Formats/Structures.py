# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What all readers return: structures, each with a name and its contours.

Coordinates are those of the file, in its unit. Medical formats come in one frame, DICOM's: x to the
patient's left, y to the back, z to the head (LPS), in millimetres.
"""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCommand, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


class FormatError(Exception):
    """A file that cannot be read, in one sentence for the user."""


def run(algorithm):
    """Updates an algorithm of VTK. Its errors become an exception; warnings go where VTK's do."""
    errors = []

    def collect(_caller, _event, text):
        errors.append(" ".join((text.partition("): ")[2] or text).split()))

    collect.CallDataType = "string0"
    senders = (algorithm, algorithm.GetExecutive())
    tags = [sender.AddObserver(vtkCommand.ErrorEvent, collect) for sender in senders]
    algorithm.Update()
    for sender, tag in zip(senders, tags):
        sender.RemoveObserver(tag)
    if errors:
        raise FormatError(errors[0])


class Structure:
    """One object to be reconstructed.

    name     as the file has it
    label    a positive integer, its value in label images
    color    red, green and blue from 0 to 255, or None
    loops    its contours: arrays of points (n x 3); a closed contour ends with its first point
    slices   instead of loops: what vtkOrthogonalSlicer makes, three vtkPolyData
    """

    def __init__(self, name, label=1, color=None, loops=(), slices=None):
        self.name = name
        self.label = label
        self.color = color
        self.loops = list(loops)
        self.slices = slices

    def add(self, points, closed=True):
        """Adds a contour, of which a closed one may repeat its first point or not."""
        points = numpy.asarray(points, dtype=float).reshape(-1, 3)
        if closed and len(points) > 2 and not numpy.array_equal(points[0], points[-1]):
            points = numpy.vstack((points, points[:1]))
        if len(points) > 0:
            self.loops.append(points)

    def take(self, other):
        """Adds the contours of another file to those of this one."""
        if self.slices is not None or other.slices is not None:
            raise FormatError(f"Two label images have a structure {self.name!r}: reconstruct each "
                              "by itself.")
        self.loops += other.loops

    def contours(self):
        """The contours as vtkPolyData: one with all of them, or three with those of each port."""
        return self.slices or [polylines(self.loops)]

    def number_of_contours(self):
        return len(self.loops) or sum(piece.GetNumberOfLines() for piece in self.slices or ())


def polylines(loops):
    """A vtkPolyData with one polyline for each array of points; closed ones end where they
    start."""
    data = vtkPolyData()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    stacked = numpy.vstack(loops) if loops else numpy.zeros((0, 3))
    points.SetData(numpy_to_vtk(stacked, deep=True))
    data.SetPoints(points)
    offsets = numpy.concatenate(([0], numpy.cumsum([len(loop) for loop in loops])))
    lines = vtkCellArray()
    lines.SetData(numpy_to_vtkIdTypeArray(offsets.astype(numpy.int64), deep=True),
                  numpy_to_vtkIdTypeArray(numpy.arange(offsets[-1], dtype=numpy.int64), deep=True))
    data.SetLines(lines)
    return data


def loops_of(data):
    """The lines and polygons of a vtkPolyData as arrays of points; polygons end where they
    start."""
    if data.GetNumberOfPoints() == 0:
        return []
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    loops = []
    for cells, closed in ((data.GetLines(), False), (data.GetPolys(), True)):
        offsets = vtk_to_numpy(cells.GetOffsetsArray())
        ids = vtk_to_numpy(cells.GetConnectivityArray())
        for begin, end in zip(offsets[:-1], offsets[1:]):
            cell = ids[begin:end]
            loops.append(points[numpy.append(cell, cell[:1]) if closed else cell])
    return loops


# --------------------------------------------------------------------------------------------------
# Several files

def merged(files):
    """Structures of several files, a list for each of them, as one list. Those of the same name
    become one; within one file they stay apart. Each gets a label of its own."""
    found = []
    for structures in files:
        known = {structure.name: structure for structure in found}
        for structure in structures:
            if structure.name in known:
                known[structure.name].take(structure)
            else:
                found.append(structure)
    used = set()
    for structure in found:
        while structure.label in used:
            structure.label += 1
        used.add(structure.label)
    return found
