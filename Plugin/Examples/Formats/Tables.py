# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of points (.csv, .tsv, .txt, .xyz): one row for each point, in the order along the
contours.

Columns are separated by commas, semicolons, tabs or blanks. With a header they are found by name,
in upper or lower case, with or without units and numbers ("X [mm]", "pos_x", "Points:0",
"Slice_ID"):

    x, y, z (or l, p, s; or r, a, s, as 3D Slicer exports)   the point
    contour..., loop..., polyline..., curve..., roi..., id   a new contour begins where it changes
    slice..., section..., plane..., frame..., layer...       the same; without z also the plane
    structure..., organ..., object..., body..., label...,    what the contour belongs to
    name

Without a header, three columns are x, y, z, four are contour, x, y, z, and two are x, y, as in the
"XY Coordinates" of ImageJ, which has one file for each contour: its slice is the last number in the
file's name.

An empty line ends a contour, and so do a contour that comes back to its first point (but for one
that has a number of its own) and points that leave the plane of constant x, y or z that three or
more have been on. Pixels become lengths with the size of a voxel; slice 1 lies at z = 0.
"""

import csv
import os
import re

import numpy

from .Structures import FormatError, Structure

# How the names of columns begin.
CONTOUR_NAMES = ("contour", "loop", "polyline", "polygon", "curve", "roi")
SLICE_NAMES = ("slice", "section", "plane", "frame", "layer")
STRUCTURE_NAMES = ("structure", "organ", "object", "body", "label", "name")
# Names of three coordinates, and the signs that turn them into left, posterior, superior.
POINT_NAMES = ((("x", "y", "z"), (1, 1, 1)), (("0", "1", "2"), (1, 1, 1)),
               (("l", "p", "s"), (1, 1, 1)), (("r", "a", "s"), (-1, -1, 1)), (("x", "y"), (1, 1)))
COORDINATE = r"(?:pos|position|coord|coordinate|point|points|vertex)?(%s)" \
             r"(?:mm|cm|um|m|px|pos|position|coord|coordinate|coordinates)?"


def read_table(path, voxel=(1.0, 1.0, 1.0)):
    """The structures of a table; `voxel` is the distance of samples along x, y and z."""
    rows = split_rows(path)
    if not any(rows):
        raise FormatError(f"{path} has no points.")
    first = next(row for row in rows if row)
    if all(is_number(cell) for cell in first):
        columns = columns_without_header(path, len(first))
    else:
        columns = columns_of_header(path, first)
        rows[rows.index(first)] = []
    return structures_of(path, rows, columns, numpy.asarray(voxel, dtype=float))


def split_rows(path):
    """Lists of cells, an empty one for each empty line; what follows # is left out."""
    with open(path, encoding="utf-8-sig", newline=None) as file:
        lines = [line.partition("#")[0].strip() for line in file]
    text = "\n".join(lines)
    separator = next((mark for mark in ";\t," if mark in text), None)
    if separator == ";" and "," in text and "." not in text:
        lines = [line.replace(",", ".") for line in lines] # decimal commas
    if separator:
        rows = csv.reader(lines, delimiter=separator, skipinitialspace=True)
        return [[cell.strip() for cell in row] if any(row) else [] for row in rows]
    return [line.split() for line in lines]


def is_number(cell):
    try:
        float(cell)
        return True
    except ValueError:
        return False


def plain(name):
    """A column's name without units, blanks and marks, in lower case."""
    return re.sub(r"[^a-z0-9]", "", re.sub(r"[\[(].*", "", name.lower()))


class Columns:
    """Where the columns of a table are: indices, or None."""

    def __init__(self, point, signs=(1, 1, 1), contour=None, section=None, structure=None):
        self.point = point
        self.signs = signs
        self.contour = contour
        self.section = section
        self.structure = structure

    def count(self):
        return 1 + max(index for index in (*self.point, self.contour, self.section, self.structure)
                       if index is not None)


def columns_without_header(path, count):
    if count == 4:
        return Columns((1, 2, 3), contour=0)
    if count in (2, 3):
        return Columns(tuple(range(count)), signs=(1,) * count)
    raise FormatError(f"{path} has {count} columns and no header that names them.")


def columns_of_header(path, header):
    names = [plain(cell) for cell in header]

    def place(pattern):
        return next((i for i, name in enumerate(names) if re.fullmatch(pattern, name)), None)

    def beginning(starts):
        return next((i for start in starts for i, name in enumerate(names)
                     if name.startswith(start)), None)

    for coordinates, signs in POINT_NAMES:
        point = tuple(place(COORDINATE % name) for name in coordinates)
        if None not in point:
            contour = beginning(CONTOUR_NAMES)
            return Columns(point, signs, place("id") if contour is None else contour,
                           beginning(SLICE_NAMES), beginning(STRUCTURE_NAMES))
    raise FormatError(f"{path} has no columns named x, y and z, but {', '.join(header)}.")


def structures_of(path, rows, columns, voxel):
    """Goes through the rows and begins a contour where one of the columns says so."""
    structures = {}
    for (name, contour, section), points in groups_of(path, rows, columns):
        points = numpy.asarray(points, dtype=float) * columns.signs
        if points.shape[1] == 2:
            points = with_plane(path, points, section)
        points = points * voxel
        structure = structures.setdefault(
            name, Structure(name or "contours", label_of(name, len(structures) + 1)))
        for loop in split_loops(points, closing=contour == ""):
            structure.add(loop)
    return list(structures.values())


def groups_of(path, rows, columns):
    """Points that follow each other and have the same structure, contour and slice."""
    groups = []
    last = None
    for number, row in enumerate(rows, 1):
        if not row:
            last = None
            continue
        if len(row) < columns.count() or not all(is_number(row[i]) for i in columns.point):
            raise FormatError(f"{path}: line {number} has no point: {' '.join(row)}")
        key = tuple("" if index is None else row[index]
                    for index in (columns.structure, columns.contour, columns.section))
        if key != last:
            groups.append((key, []))
        groups[-1][1].append([float(row[i]) for i in columns.point])
        last = key
    return groups


def with_plane(path, points, section):
    """Points of an image with the number of their slice, which counts from 1, for z."""
    if section == "":
        numbers = re.findall(r"\d+", os.path.splitext(os.path.basename(path))[0])
        if not numbers:
            raise FormatError(f"{path} has x and y only: give z or slice as a column, or the "
                              "number of the slice at the end of the file's name.")
        section = numbers[-1]
    if not is_number(section):
        raise FormatError(f"{path} has no z, and its slice {section!r} is no number.")
    return numpy.column_stack((points, numpy.full(len(points), float(section) - 1)))


def label_of(name, default):
    return int(float(name)) if is_number(name) and float(name) > 0 else default


def split_loops(points, closing):
    """Contours that follow each other without a mark between them. They end where they leave their
    plane, if all of them have three points or more then; with `closing`, where they close, too."""
    parts = [part for plane in split_planes(points)
             for part in (split_closed(plane) if closing else [plane])]
    if min(len(part) for part in parts) >= 3:
        return parts
    return split_closed(points) if closing else [points]


def split_planes(points):
    """Runs of points, each as long as possible, on one plane of constant x, y or z."""
    begins = [0]
    constant = numpy.ones(3, dtype=bool) # coordinates that all points of the run share
    for i in range(1, len(points)):
        constant = constant & (points[i] == points[begins[-1]])
        if not constant.any():
            begins.append(i)
            constant = numpy.ones(3, dtype=bool)
    return [points[begin:end] for begin, end in zip(begins, begins[1:] + [len(points)])]


def split_closed(points):
    """Runs of points, each of which ends with its first point; the last one may stay open."""
    parts, begin = [], 0
    for i in range(len(points)):
        if i - begin > 2 and numpy.array_equal(points[i], points[begin]):
            parts.append(points[begin:i + 1])
            begin = i + 1
    return parts + ([points[begin:]] if begin < len(points) else [])
