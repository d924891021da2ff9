# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
r"""Volumes and ejection fractions from contours of cardiac MR: short-axis slices, with long-axis ones
or without:

    python3 CardiacVolumes.py diastole.csv systole.csv [--out surfaces.vtp]

Each file is a phase, of any number of phases, in any format that ReconstructAny.py reads contours
from; in tables, the columns are x, y, z in millimetres, contour, and structure. Planes may be turned
as the scanner has them. Short-axis slices alone count as plates of one spacing each, as in
Simpson's rule; long-axis slices show apex and base instead.

Printed are the volume of each structure in each phase, its ejection fraction, and, if there are
structures endo and epi, the mass of the muscle between them.

    --out FILE.vtp    all surfaces, with the cell array Label and a part for each phase
"""

import os
import sys

from Formats import Surfaces, read_structures
from Formats.Command import parser_of, status_of
from Formats.Filter import load_package
from Formats.Structures import Structure

# Of heart muscle, in grams per millilitre.
DENSITY = 1.05
MILLILITRE = 1000.0  # in cubic millimetres


def volumes_of(path, surfaces):
    """The volume of each structure of a phase, in millilitres."""
    structures = read_structures(path)
    reconstruct = load_package().reconstruct
    volumes = {}
    for structure in structures:
        # With long axes, end_caps says nothing: they show where the structure ends.
        result = reconstruct(contours=structure.contours()[0], end_caps="Half Slice")
        volumes[structure.name] = float(result.report.components["Volume"].sum()) / MILLILITRE
        name = f"{os.path.splitext(os.path.basename(path))[0]} {structure.name}"
        surfaces.append((Structure(name, len(surfaces) + 1), result.report.surface))
    return volumes


def describe(phases):
    """Lines about volumes in the order of the phases."""
    names = list(dict.fromkeys(name for volumes in phases for name in volumes))
    for name in names:
        found = [volumes[name] for volumes in phases if name in volumes]
        text = f"{name}: " + ", ".join(f"{volume:.1f}" for volume in found) + " ml"
        if len(found) > 1:
            text += f", ejection fraction {100 * (1 - min(found) / max(found)):.1f} %"
        yield text
    masses = [DENSITY * (volumes["epi"] - volumes["endo"]) for volumes in phases
              if {"endo", "epi"} <= set(volumes)]
    if masses:
        yield "muscle: " + ", ".join(f"{mass:.1f}" for mass in masses) + " g"


def main(arguments):
    parser = parser_of(arguments, "CardiacVolumes.py PHASE [PHASE ...] [--out FILE.vtp]", __doc__)
    parser.add_argument("phases", nargs="+")
    parser.add_argument("--out")
    options = parser.parse_args(arguments)

    def measure():
        surfaces = []
        for line in describe([volumes_of(path, surfaces) for path in options.phases]):
            print(line)
        if options.out:
            Surfaces.write_surfaces(surfaces, options.out)

    return status_of(measure)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
