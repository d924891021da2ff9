# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
r"""Geological bodies from interpreted sections: a fence of vertical sections through wells or along
seismic lines, with maps at some depths or without:

    python3 FenceSections.py sections.csv bodies.stl --exaggerate 10

The table has the columns x, y, z, section, and body if there are several; the outline of a body on a
section is a closed contour. Sections along two directions, and maps, are three families; they need
not be at right angles, nor along x and y.

    --exaggerate F    stretch z by F while the surface is made, if bodies are flat and sections far
                      apart: about the distance of the sections divided by the thickness (default 1)

Printed are volume and area of each body, and the section that would settle most of what the
sections leave open. The surfaces lie where the sections do, in the unit of the table.
"""

import sys

import numpy

from Formats import Surfaces, read_structures
from Formats.Command import parser_of, status_of
from Formats.Filter import load_package
from Formats.Structures import polylines


def stretched(loops, factor):
    return [loop * (1.0, 1.0, factor) for loop in loops]


def area_of(points, triangles):
    a, b, c = (points[triangles[:, side]].astype(float) for side in range(3))
    return numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2


def unstretch(surface, points, factor):
    """Moves the points of a surface back; its normals go, as others would be right."""
    moved = polylines([points * (1.0, 1.0, 1.0 / factor)]).GetPoints()
    surface.SetPoints(moved)
    surface.GetPointData().SetNormals(None)


def next_section(report, factor):
    """The section to draw next, in words; empty if nothing is open."""
    if len(report.undecided["PlaneRank"]) == 0:
        return ""
    first = numpy.argmin(report.undecided["PlaneRank"])
    axis = report.undecided["PlaneAxis"][first]
    place = report.undecided["PlaneCoordinate"][first] / (factor if axis == 2 else 1.0)
    return f"; next section: {'xyz'[axis]} = {place:.6g}"


def main(arguments):
    parser = parser_of(arguments, "FenceSections.py TABLE OUT [--exaggerate F]", __doc__)
    parser.add_argument("table")
    parser.add_argument("out")
    parser.add_argument("--exaggerate", type=float, default=1.0)
    options = parser.parse_args(arguments)
    factor = options.exaggerate

    def make_bodies():
        surfaces = []
        reconstruct = load_package().reconstruct
        for body in read_structures(options.table):
            points, triangles, report = reconstruct(contours=stretched(body.loops, factor))
            # Volumes shrink with z; areas have to be measured.
            volume = report.components["Volume"].sum() / factor
            unstretch(report.surface, points, factor)
            area = area_of(points * (1.0, 1.0, 1.0 / factor), triangles)
            print(f"{body.name}: {len(body.loops)} contours, volume {volume:.6g}, area {area:.6g}"
                  + next_section(report, factor))
            surfaces.append((body, report.surface))
        Surfaces.write_surfaces(surfaces, options.out)

    return status_of(make_bodies)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
