# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestHelp.py <OrthogonalSlices.qch>: the archive of help pages has what ParaView's help button
looks for, a page for each filter with pictures that are there, and texts for all of their parts."""

import re
import sqlite3
import sys
import zlib

FILTERS = {"OrthogonalSliceReconstruction": 3, "ParallelSliceReconstruction": 1, "OrthogonalSlicer": 1}


def read_archive(path):
    """Name space and folder, and all files by name. A qch file is a database of SQLite, in which Qt
    keeps each file packed, after four bytes with its size."""
    database = sqlite3.connect(path)
    (space,), = database.execute("SELECT Name FROM NamespaceTable")
    (folder,), = database.execute("SELECT Name FROM FolderTable")
    rows = database.execute("SELECT n.Name, d.Data FROM FileNameTable n, FileDataTable d "
                            "WHERE n.FileId = d.Id AND d.Data NOT NULL")
    return space, folder, {name: zlib.decompress(data[4:]) for name, data in rows}


def check(condition, sentence):
    if not condition:
        raise AssertionError(sentence)


def main(path):
    space, folder, files = read_archive(path)
    # pqHelpReaction: qthelp://NAMESPACE/BASENAME/GROUP.NAME.html, BASENAME that of the name space.
    check((space, folder) == ("OrthogonalSlices.org", "OrthogonalSlices"), f"{space}, {folder}")
    for name, least in FILTERS.items():
        check(f"filters.{name}.html" in files, f"no page of {name}: {sorted(files)}")
        page = files[f"filters.{name}.html"].decode()
        pictures = re.findall(r'<img src="([^"]+)"', page)
        check(len(pictures) >= least, f"{name} has the pictures {pictures}")
        for picture in pictures:
            check(files.get(picture, b"").startswith(b"\x89PNG"), f"{picture} is no picture")
        for heading in ("Inputs", "Outputs"):
            check(f"<h2>{heading}</h2>" in page, f"{name} has no {heading}")
        rows = re.findall(r"<tr>.*?</tr>", page, re.S)
        check(len(rows) >= 9, f"{name} explains {len(rows)} properties")
        empty = [row for row in rows if "<p>" not in row]
        check(not empty, f"{name} says nothing of {empty}")
    print("help: all checks passed")


main(sys.argv[1])
