# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Which samples of a grid lie inside a closed surface.

VTK's vtkPolyDataToImageStencil says so where there is one. ParaView of Debian comes without it:
there the surface is cut on the planes of the samples and the cuts on their rows, here.
"""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

from .Images import make_image, samples_of

try:
    from vtkmodules.vtkImagingStencil import vtkImageStencil, vtkPolyDataToImageStencil
except ImportError:
    vtkPolyDataToImageStencil = None


def samples_inside(surface, shape):
    """An array [k, j, i] of the given shape: true inside. The surface is in indices."""
    inside = inside_by_rows if vtkPolyDataToImageStencil is None else inside_by_stencil
    return inside(surface, shape)


def inside_by_stencil(surface, shape):
    grid = make_image(numpy.zeros(shape, dtype=numpy.uint8), numpy.eye(3), (0, 0, 0))
    stencil = vtkPolyDataToImageStencil()
    stencil.SetInputData(surface)
    stencil.SetOutputWholeExtent(grid.GetExtent())
    paint = vtkImageStencil()
    paint.SetInputData(grid)
    paint.SetStencilConnection(stencil.GetOutputPort())
    paint.ReverseStencilOn() # the background is what lies inside
    paint.SetBackgroundValue(1)
    paint.Update()
    return samples_of(paint.GetOutput()) == 1


def inside_by_rows(surface, shape):
    """A sample is inside if the surface crosses its row an odd number of times before it. A point
    that lies on a plane or row counts as above, everywhere: no crossing is missed or counted
    twice."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    planes, starts, ends = cut_on_planes(points, triangles, shape[0])
    which, rows = crossed(starts[:, 1], ends[:, 1], shape[1])
    start, end = starts[which], ends[which]
    share = (rows - start[:, 1]) / (end[:, 1] - start[:, 1])
    column = numpy.ceil(start[:, 0] + share * (end[:, 0] - start[:, 0]))
    column = numpy.clip(column, 0, shape[2]).astype(numpy.int64)
    turns = numpy.zeros((shape[0], shape[1], shape[2] + 1), dtype=numpy.uint32)
    numpy.add.at(turns, (planes[which], rows, column), 1)
    return numpy.cumsum(turns, axis=2)[:, :, :-1] % 2 == 1


def crossed(low, high, count):
    """Whole numbers from 0 to `count` - 1 between pairs of numbers, the upper end included: the
    index of the pair, and the number."""
    low, high = numpy.minimum(low, high), numpy.maximum(low, high)
    first = numpy.clip(numpy.floor(low) + 1, 0, count).astype(numpy.int64)
    last = numpy.clip(numpy.floor(high), -1, count - 1).astype(numpy.int64)
    counts = numpy.maximum(last - first + 1, 0)
    which = numpy.repeat(numpy.arange(len(counts)), counts)
    before = numpy.cumsum(counts) - counts
    return which, first[which] + numpy.arange(len(which)) - before[which]


def cut_on_planes(points, triangles, count):
    """The segments that planes of whole k cut out of triangles: the planes, and the ends."""
    heights = points[triangles, 2]
    which, planes = crossed(heights.min(axis=1), heights.max(axis=1), count)
    corners = triangles[which]
    above = points[corners, 2] >= planes[:, None]
    # One corner is alone on its side; the segment runs between the edges to the two others.
    alone = numpy.where(above.sum(axis=1) == 1, above.argmax(axis=1), (~above).argmax(axis=1))
    pairs = numpy.arange(len(corners))
    ends = [cut_edge(points, corners[pairs, alone], corners[pairs, (alone + step) % 3], planes)
            for step in (1, 2)]
    return planes, ends[0], ends[1]


def cut_edge(points, one, other, planes):
    """Where edges pass planes; the same from both of the triangles at an edge."""
    start, end = points[numpy.minimum(one, other)], points[numpy.maximum(one, other)]
    share = (planes - start[:, 2]) / (end[:, 2] - start[:, 2])
    return start[:, :2] + share[:, None] * (end[:, :2] - start[:, :2])
