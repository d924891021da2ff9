# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Contours as arrays of NumPy, for filters that take vtkPolyData."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Union

import numpy
from numpy.typing import ArrayLike
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkPolyData

#: The cell array that the labels of a mapping get.
LABEL_ARRAY = "Label"

#: One contour (n x 3), or several of them.
Loops = Union[ArrayLike, Sequence[ArrayLike]]
#: What `reconstruct` takes for a family of slices.
Contours = Union[vtkDataObject, Loops, Mapping[Union[str, int], Loops]]


def polydata_of(contours: Contours, closed: bool = True) -> vtkDataObject:
    """Contours as a data set of VTK.

    contours  one contour, which is an array of n points (n x 3); a sequence of them; or a mapping
              from labels, texts or whole numbers, to the contours of each structure. A data set of
              VTK is returned as it is.
    closed    whether the last point of each array is joined to the first one, which may be repeated
              or not. Else arrays are polylines, in pieces of any size.

    A mapping gives the data set the cell array "Label". Points keep float as such; all else becomes
    double. Raises ValueError for arrays of other shapes, TypeError for labels of other types.
    """
    if isinstance(contours, vtkDataObject):
        return contours
    labels = None
    if isinstance(contours, Mapping):
        sets = [loops_of(loops) for loops in contours.values()]
        labels = [label for label, loops in zip(contours, sets) for _ in loops]
        loops = [loop for loops in sets for loop in loops]
    else:
        loops = loops_of(contours)
    data = polylines(loops, closed)
    if labels is not None:
        data.GetCellData().AddArray(label_array(labels))
    return data


def loops_of(contours: Loops) -> list[numpy.ndarray]:
    """One array of points or several of them, checked, as a list of arrays (n x 3)."""
    if isinstance(contours, numpy.ndarray) and contours.ndim == 2 and contours.dtype != object:
        return [points_of(contours)]
    if isinstance(contours, (str, bytes)) or not isinstance(contours, Iterable):
        raise TypeError(f"contours are arrays or data sets of VTK, not {type(contours).__name__}")
    return [points_of(loop) for loop in contours]


def points_of(loop: ArrayLike) -> numpy.ndarray:
    """The points of one contour, in single precision if it has that, else in double precision."""
    points = numpy.asarray(loop)
    if points.dtype != numpy.float32:
        points = points.astype(numpy.float64)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"a contour is an array of n x 3 coordinates, not of shape {points.shape}")
    return points


def polylines(loops: Sequence[numpy.ndarray], closed: bool) -> vtkPolyData:
    """One polyline for each array; closed ones end with the point that they start with."""
    dtype = numpy.result_type(*loops) if loops else numpy.float64
    stacked = numpy.concatenate(loops) if loops else numpy.zeros((0, 3))
    cells, start = [], 0
    for loop in loops:
        cell = numpy.arange(start, start + len(loop), dtype=numpy.int64)
        start += len(loop)
        # What has one or two points bounds nothing; the filter says so.
        if closed and len(loop) > 2 and not numpy.array_equal(loop[0], loop[-1]):
            cell = numpy.append(cell, cell[:1])
        cells.append(cell)
    ends = numpy.cumsum([0] + [len(cell) for cell in cells], dtype=numpy.int64)
    ids = numpy.concatenate(cells) if cells else numpy.zeros(0, dtype=numpy.int64)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(stacked, dtype=dtype), deep=True))
    lines = vtkCellArray()
    lines.SetData(numpy_to_vtkIdTypeArray(ends, deep=True), numpy_to_vtkIdTypeArray(ids, deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    return data


def label_array(labels: Sequence[Union[str, int]]):
    """The cell array "Label" with one value for each contour."""
    if all(isinstance(label, str) for label in labels):
        array = vtkStringArray()
        for label in labels:
            array.InsertNextValue(label)
    elif all(isinstance(label, (int, numpy.integer)) for label in labels):
        array = numpy_to_vtk(numpy.array(labels, dtype=numpy.int32), deep=True)
    else:
        raise TypeError("labels are all texts, or all whole numbers")
    array.SetName(LABEL_ARRAY)
    return array
