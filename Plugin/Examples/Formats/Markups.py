# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Curves of 3D Slicer: .mrk.json (closed curves and curves) and .fcsv (points, taken for one
contour).

A curve is given by its control points. Slicer draws a smooth curve through them by default; here
they are joined by straight lines, so that a curve with few points should be resampled in Slicer
first (Markups > Resample). All curves of the files that are read together are one structure.
Coordinates become left, posterior, superior, whatever the file says they are.
"""

import csv
import json

import numpy

from .Structures import FormatError, Structure

TO_LPS = {"LPS": (1, 1, 1), "RAS": (-1, -1, 1), "1": (1, 1, 1), "0": (-1, -1, 1)}
CURVES = ("ClosedCurve", "Curve")


def signs_of(path, system):
    if system not in TO_LPS:
        raise FormatError(f"{path} has an unknown coordinate system {system!r}.")
    return TO_LPS[system]


def read_markups(path):
    with open(path, encoding="utf-8") as file:
        try:
            markups = json.load(file).get("markups", [])
        except ValueError as error:
            raise FormatError(f"{path} is no valid JSON: {error}.") from None
    structure = Structure("contours")
    for markup in markups:
        if markup.get("type") not in CURVES:
            continue
        signs = signs_of(path, markup.get("coordinateSystem", "LPS"))
        points = [point["position"] for point in markup.get("controlPoints", ())
                  if point.get("positionStatus", "defined") == "defined"]
        structure.add(numpy.reshape(points, (-1, 3)) * numpy.array(signs, dtype=float),
                      closed=markup["type"] == "ClosedCurve")
    if not structure.loops:
        raise FormatError(f"{path} has no curves.")
    return [structure]


def read_fcsv(path):
    signs = TO_LPS["RAS"]
    columns = ["id", "x", "y", "z"]
    points = []
    with open(path, encoding="utf-8") as file:
        for line in file:
            key, _, value = line.strip().partition("=")
            if not line.startswith("#"):
                if line.strip():
                    row = next(csv.reader([line]))
                    points.append([float(row[columns.index(axis)]) for axis in "xyz"])
            elif key.strip("# ") == "CoordinateSystem":
                signs = signs_of(path, value.strip())
            elif key.strip("# ") == "columns":
                columns = [name.strip() for name in value.split(",")]
    if not points:
        raise FormatError(f"{path} has no points.")
    structure = Structure("contours")
    structure.add(numpy.array(points) * numpy.array(signs, dtype=float))
    return [structure]
