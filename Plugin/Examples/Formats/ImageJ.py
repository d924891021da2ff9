# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Selections of ImageJ and Fiji: a .roi file, or a .zip of the ROI Manager (More >> Save).

Polygons, freehand and traced outlines, rectangles and ovals are contours; so are polylines and
freehand lines, which stay open. Each lies on the slice that its selection is on (z position, else
position); pixels become lengths with the size of a voxel, and slice 1 lies at z = 0. All selections
are one structure.

The layout of the file is that of ij.io.RoiDecoder: numbers are big-endian; a header of 64 bytes,
the coordinates, and a second header that the first one points to.
"""

import math
import struct
import zipfile

import numpy

from .Structures import FormatError, Structure

POLYGON, RECTANGLE, OVAL, LINE, FREELINE, POLYLINE, NONE, FREEHAND, TRACED, ANGLE, POINT = range(11)
CLOSED = (POLYGON, FREEHAND, TRACED)
OPEN = (FREELINE, POLYLINE)
SUB_PIXEL = 128
OVAL_POINTS = 64


def read_imagej(path, voxel=(1.0, 1.0, 1.0)):
    structure = Structure("contours")
    for name, data in selections(path):
        decoded = decode(data, name)
        if decoded:
            points, position, closed = decoded
            if position < 1:
                raise FormatError(f"The selection {name!r} in {path} is on no slice of a stack: "
                                  "give it a position in ImageJ (Properties, Position).")
            z = numpy.full(len(points), position - 1.0)
            structure.add(numpy.column_stack((points, z)) * voxel, closed)
    if not structure.loops:
        raise FormatError(f"{path} has no outlines.")
    return [structure]


def selections(path):
    if not zipfile.is_zipfile(path):
        with open(path, "rb") as file:
            return [(path, file.read())]
    with zipfile.ZipFile(path) as archive:
        return [(name, archive.read(name)) for name in archive.namelist()
                if name.lower().endswith(".roi")]


def decode(data, name):
    """Points in pixels, the slice from 1 and whether the contour is closed; None for marks."""
    if len(data) < 64 or data[:4] != b"Iout":
        raise FormatError(f"{name} is no selection of ImageJ.")
    kind = data[6]
    top, left, bottom, right, count = struct.unpack_from(">4hH", data, 8)
    count = count or struct.unpack_from(">i", data, 18)[0] # of many points
    options, = struct.unpack_from(">H", data, 50)
    position, second = struct.unpack_from(">2i", data, 56)
    if second > 0 and len(data) >= second + 12:
        position = struct.unpack_from(">i", data, second + 8)[0] or position
    if struct.unpack_from(">i", data, 36)[0] > 0:
        raise FormatError(f"The selection {name!r} is made of several outlines: split it in ImageJ "
                          "(Edit > Selection, or More >> Split in the ROI Manager).")
    if kind in (RECTANGLE, OVAL):
        box = (left, top, right, bottom)
        if options & SUB_PIXEL:
            x, y, width, height = struct.unpack_from(">4f", data, 18)
            box = (x, y, x + width, y + height)
        return outline(kind, box), position, True
    if kind not in CLOSED + OPEN:
        return None
    size = 12 if options & SUB_PIXEL else 4
    if len(data) < 64 + size * count:
        raise FormatError(f"The selection {name!r} ends too early.")
    if options & SUB_PIXEL:
        numbers = numpy.frombuffer(data, ">f4", 2 * count, 64 + 4 * count)
        points = numbers.reshape(2, count).T.astype(float)
    else:
        numbers = numpy.frombuffer(data, ">i2", 2 * count, 64)
        points = numbers.reshape(2, count).T.astype(float) + (left, top)
    return points, position, kind in CLOSED


def outline(kind, box):
    left, top, right, bottom = box
    if kind == RECTANGLE:
        corners = [(left, top), (right, top), (right, bottom), (left, bottom)]
        return numpy.array(corners, dtype=float)
    angles = 2 * math.pi / OVAL_POINTS * numpy.arange(OVAL_POINTS)
    return numpy.column_stack(((left + right + (right - left) * numpy.cos(angles)) / 2,
                               (top + bottom + (bottom - top) * numpy.sin(angles)) / 2))
