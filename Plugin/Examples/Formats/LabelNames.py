# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Names and colours of the labels of an image, from a file beside it: label descriptions of ITK-SNAP
(Segmentation > Save Label Descriptions), whose rows are

    IDX  R G B  A VIS MSH  "LABEL"

and color tables of 3D Slicer (.ctbl), whose rows are

    IDX  LABEL  R G B A

Rows that begin with # are left out. Labels are whole numbers, red, green and blue from 0 to 255.
"""

import re

from .Structures import FormatError

SNAP = re.compile(r'\s*(\d+)\s+(\d+)\s+(\d+)\s+(\d+)\s+[\d.]+\s+[01]\s+[01]\s+"(.*)"\s*$')
SLICER = re.compile(r"\s*(\d+)\s+(\S+)\s+(\d+)\s+(\d+)\s+(\d+)\s+\d+\s*$")


def read_label_names(path):
    """{label: (name, (red, green, blue))}"""
    found = {}
    try:
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
    except (OSError, UnicodeDecodeError):
        raise FormatError(f"{path} cannot be read.") from None
    for number, line in enumerate(lines, 1):
        if not line.strip() or line.startswith("#"):
            continue
        snap, slicer = SNAP.match(line), SLICER.match(line)
        if snap:
            label, *color, name = snap.groups()
        elif slicer:
            label, name, *color = slicer.groups()
            name = name.replace("_", " ")
        else:
            raise FormatError(f"{path}, line {number}: no label with its name and color.")
        found[int(label)] = (name, tuple(int(value) for value in color))
    return found


def name_structures(structures, names):
    """Gives structures the names and colours of their labels, where these have some."""
    for structure in structures:
        if structure.label in names:
            structure.name, structure.color = names[structure.label]
