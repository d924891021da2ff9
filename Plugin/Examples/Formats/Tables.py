# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of points (.csv, .tsv, .txt, .xyz): one row for each point, in the order along the contours.

Columns are separated by commas, semicolons, tabs or blanks. With a header they are found by name, in
upper or lower case and with or without units ("X [mm]"):

    x, y, z (or l, p, s; or r, a, s, as 3D Slicer exports)   the point
    contour, contour_id, loop, polyline, roi, id             a new contour begins where it changes
    slice, section, plane, frame                             the same; without z also the plane
    structure, name, organ, label                            what the contour belongs to

Without a header, three columns are x, y, z, four are contour, x, y, z, and two are x, y, as in the
"XY Coordinates" of ImageJ, which has one file for each contour: its slice is the last number in the
file's name.

Where no column tells contours apart, an empty line does; else a contour ends where it comes back to
its first point, and where it leaves its plane. Pixels become lengths with the size of a voxel.
"""

import csv
import os
import re

import numpy

from .Structures import FormatError, Structure

CONTOUR_NAMES = ("contour", "contourid", "contourindex", "loop", "loopid", "polyline", "polylineid",
                 "roi", "roiid", "id")
SLICE_NAMES = ("slice", "sliceid", "sliceindex", "slicenumber", "section", "plane", "frame")
STRUCTURE_NAMES = ("structure", "structurename", "name", "organ", "label")
# Names of three coordinates, and the signs that turn them into left, posterior, superior.
POINT_NAMES = ((("x", "y", "z"), (1, 1, 1)), (("l", "p", "s"), (1, 1, 1)),
               (("r", "a", "s"), (-1, -1, 1)), (("x", "y"), (1, 1)))


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
    return re.sub(r"[^a-z]", "", re.sub(r"[\[(].*", "", name.lower()))


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

    def find(wanted):
        return next((names.index(name) for name in wanted if name in names), None)

    for point, signs in POINT_NAMES:
        if all(name in names for name in point):
            return Columns(tuple(names.index(name) for name in point), signs,
                           find(CONTOUR_NAMES), find(SLICE_NAMES), find(STRUCTURE_NAMES))
    raise FormatError(f"{path} has no columns named x, y and z, but {', '.join(header)}.")


def structures_of(path, rows, columns, voxel):
    """Goes through the rows and begins a contour where one of the columns says so."""
    structures = {}
    for key, points in groups_of(path, rows, columns):
        name, section, has_contours = key[0], key[2], key[1] != "" or key[2] != ""
        points = numpy.asarray(points, dtype=float) * columns.signs
        if points.shape[1] == 2:
            points = with_plane(path, points, section)
        points = points * voxel
        structure = structures.setdefault(
            name, Structure(name or "contours", label_of(name, len(structures) + 1)))
        for loop in [points] if has_contours else split_loops(points):
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
            raise FormatError(f"{path} has x and y only: give z or slice as a column, or the number "
                              "of the slice at the end of the file's name.")
        section = numbers[-1]
    if not is_number(section):
        raise FormatError(f"{path} has no z, and its slice {section!r} is no number.")
    return numpy.column_stack((points, numpy.full(len(points), float(section) - 1)))


def label_of(name, default):
    return int(float(name)) if is_number(name) and float(name) > 0 else default


def split_loops(points):
    """Contours that follow each other without a mark between them."""
    loops = []
    begin = 0
    while begin < len(points):
        end = end_of_loop(points, begin)
        loops.append(points[begin:end])
        begin = end
    return loops


def end_of_loop(points, begin):
    """Behind the last point of the contour that starts at `begin`."""
    constant = numpy.ones(3, dtype=bool) # coordinates that all points so far share
    on_plane = True                      # of constant x, y or z
    for end in range(begin + 1, len(points)):
        constant &= points[end] == points[begin]
        if on_plane and not constant.any():
            if end > begin + 1:
                return end
            on_plane = False
        if end - begin > 2 and numpy.array_equal(points[end], points[begin]):
            return end + 1
    return len(points)
