#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Includes run downwards: a file may include files of its own room and of the rooms below.

TestLayers.py ROOT          checks the project in ROOT, prints what is wrong, ends with 1 if anything
TestLayers.py --self-test   checks trees made up for the purpose, right and wrong ones
"""

import pathlib
import re
import sys
import tempfile
import unittest

# The order of the rooms. Each may include itself, the rooms named here and all that these may
# include. A room is a folder; its name is the path below Filters or, of the tests, below the root.
ROOMS_BELOW = {
    "Core/Base": [],
    "Core/Planar": ["Core/Base"],
    "Core/Slices": ["Core/Planar"],
    "Core/Loops": ["Core/Slices"],
    "Core/Frames": ["Core/Base"],
    "Core/Pieces": ["Core/Planar"],
    "Core/Slicing": ["Core/Slices"],
    "Core/Correspondence": ["Core/Planar"],
    "Core/Crossings": ["Core/Slices"],
    "Core/Graph": ["Core/Crossings"],
    "Core/Cells": ["Core/Graph", "Core/Correspondence"],
    "Core/Slabs": ["Core/Cells"],
    "Core/Patches": ["Core/Cells"],
    "Core/Surface": ["Core/Slabs", "Core/Patches"],
    "Core/Sparse": ["Core/Surface", "Core/Slicing"],
    "Core/Improve": ["Core/Surface"],
    "Core/Labels": ["Core/Sparse", "Core/Improve", "Core/Loops"],
    "Core": ["Core/Labels", "Core/Improve", "Core/Pieces", "Core/Frames"],
    "Bridge": ["Core"],
    ".": ["Bridge"],
    "Testing/Support": ["Core"],
    "Testing/Core": ["Testing/Support"],
    "Testing/Support/Vtk": ["Testing/Support", "."],
}

# Rooms that are compiled where there is no VTK. The rooms inside them count too.
WITHOUT_VTK = ["Core", "Testing/Support", "Testing/Core"]
# Files of these rooms that need VTK for all that.
NEED_VTK = ["Testing/Support/Vtk", "Testing/Support/FilterRun.h", "Testing/Support/FilterRun.cxx"]

SUFFIXES = {".h", ".cxx", ".txx"}
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)


def name_of(path, root):
    """The path of a file as includes write it: below Filters, or below the root."""
    relative = path.relative_to(root)
    return relative.relative_to("Filters") if relative.parts[0] == "Filters" else relative


def is_in(name, folders):
    return any(name == folder or name.startswith(folder + "/") for folder in folders)


def room_of(name):
    """The innermost room that holds the file; none of a file that no rule is about."""
    if is_in(name.as_posix(), NEED_VTK):
        return "Testing/Support/Vtk"
    for folder in name.parents:
        if folder.as_posix() in ROOMS_BELOW:
            # The root of the tests' own programs is no room, that of Filters is.
            return None if folder.as_posix() == "." and len(name.parts) > 1 else folder.as_posix()
    return None


def rooms_within_reach(room):
    reached = {room}
    front = [room]
    while front:
        for below in ROOMS_BELOW[front.pop()]:
            if below not in reached:
                reached.add(below)
                front.append(below)
    return reached


class Checker:
    """Reads the sources of a project and lists what is wrong with their includes."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.files = {}
        for folder in ("Filters", "Testing"):
            for path in sorted((self.root / folder).rglob("*")):
                if path.suffix in SUFFIXES:
                    self.files[name_of(path, self.root).as_posix()] = path
        self.includes = {name: self.read_includes(name) for name in self.files}

    def read_includes(self, name):
        """Pairs of what an include names and the project's file that is meant, if it is one."""
        text = self.files[name].read_text(encoding="utf-8")
        pairs = []
        for _, target in INCLUDE.findall(text):
            # Tests write paths below Testing, all others paths below Filters.
            candidates = [target, f"Testing/{target}"]
            pairs.append((target, next((c for c in candidates if c in self.files), None)))
        return pairs

    def complaints(self):
        found = []
        for name in self.files:
            found += self.check_file(name)
        return found + self.find_circles()

    def check_file(self, name):
        path = pathlib.PurePosixPath(name)
        room = room_of(path)
        if room is None:
            return [f"{name} is in no known room"] if is_in(name, ["Core", "Bridge"]) else []
        if room == "Core" and path.parent.as_posix() != "Core":
            return [f"{name} is in no known room"]
        found = []
        without_vtk = is_in(name, WITHOUT_VTK) and not is_in(name, NEED_VTK)
        reach = rooms_within_reach(room)
        for target, file in self.includes[name]:
            if without_vtk and self.needs_vtk(target, file):
                found.append(f"{name} includes {target}, but has to do without VTK")
            elif file is None:
                if target.startswith(("Core/", "Bridge/", "Support/")) or target.startswith("."):
                    found.append(f"{name} includes {target}, which there is not")
            elif room_of(pathlib.PurePosixPath(file)) not in reach | {None}:
                found.append(f"{name} includes {target}, upwards")
        return found

    @staticmethod
    def needs_vtk(target, file):
        if file is None:
            return target.startswith("vtk")
        return file.startswith("Bridge/") or "/" not in file or is_in(file, NEED_VTK)

    def find_circles(self):
        """One complaint for each circle that is met on a walk in the order of the names."""
        found = []
        done = set()

        def walk(name, trail):
            if name in trail:
                found.append("circle: " + " -> ".join(trail[trail.index(name):] + [name]))
            elif name not in done:
                for _, file in self.includes[name]:
                    if file is not None:
                        walk(file, trail + [name])
                done.add(name)

        for name in self.files:
            walk(name, [])
        return found


class SelfTest(unittest.TestCase):
    """What is wrong in made-up trees is found, and what is right is not complained of."""

    RIGHT = {
        "Filters/Core/Base/Types.h": "#include <vector>\n",
        "Filters/Core/Graph/NodeGraph.h": '#include "Core/Base/Types.h"\n',
        "Filters/Core/Graph/NodeGraph.cxx": '#include "Core/Graph/NodeGraph.h"\n',
        "Filters/Core/Reconstruct.h": '#include "Core/Graph/NodeGraph.h"\n',
        "Filters/Bridge/WriteGraph.h": '#include "Core/Reconstruct.h"\n#include "vtkPolyData.h"\n',
        "Filters/vtkFilter.h": '#include "vtkPolyDataAlgorithm.h"\n',
        "Filters/vtkFilter.cxx": '#include "vtkFilter.h"\n#include "Bridge/WriteGraph.h"\n',
        "Testing/Support/Check.h": '#include "Core/Reconstruct.h"\n',
        "Testing/Support/Vtk/Read.h": '#include "Support/Check.h"\n#include <vtkPolyData.h>\n',
        "Testing/Core/Graph/TestNodeGraph.cxx": '#include "Support/Check.h"\n',
        "Testing/TestFilter.cxx": '#include "vtkFilter.h"\n#include "Support/Vtk/Read.h"\n',
    }

    def complaints_with(self, **changes):
        """Complaints about the right tree with some of its files changed."""
        with tempfile.TemporaryDirectory() as root:
            for name, text in {**self.RIGHT, **changes.get("files", {})}.items():
                path = pathlib.Path(root) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return Checker(root).complaints()

    def expect_complaint(self, name, text, *words):
        found = self.complaints_with(files={name: text})
        self.assertEqual(len(found), 1, found)
        for word in words:
            self.assertIn(word, found[0])

    def test_right_tree_is_accepted(self):
        self.assertEqual(self.complaints_with(), [])

    def test_include_of_a_higher_room(self):
        self.expect_complaint("Filters/Core/Base/Box.h", '#include "Core/Graph/NodeGraph.h"\n',
            "Core/Base/Box.h includes Core/Graph/NodeGraph.h, upwards")

    def test_include_of_the_driver(self):
        self.expect_complaint("Filters/Core/Surface/Lay.cxx", '#  include "Core/Reconstruct.h"\n',
            "upwards")

    def test_room_beside(self):
        self.expect_complaint("Filters/Core/Slicing/Cut.h", '#include "Core/Graph/NodeGraph.h"\n',
            "upwards")

    def test_filter_in_the_bridge(self):
        self.expect_complaint("Filters/Bridge/Read.cxx", '#include "vtkFilter.h"\n', "upwards")

    def test_vtk_in_the_core(self):
        for text in ('#include "vtkPolyData.h"\n', "#include <vtkPolyData.h>\n",
                     '#include "Bridge/WriteGraph.h"\n', '#include "vtkFilter.h"\n'):
            self.expect_complaint("Filters/Core/Graph/EmbedArcs.cxx", text, "do without VTK")

    def test_vtk_in_the_tests_of_the_core(self):
        self.expect_complaint("Testing/Core/Graph/TestEmbedArcs.cxx",
            '#include "Support/Vtk/Read.h"\n', "do without VTK")
        self.expect_complaint("Testing/Support/Cut.cxx", '#include "vtkCutter.h"\n',
            "do without VTK")

    def test_unknown_room(self):
        self.expect_complaint("Filters/Core/Attic/Old.h", "", "no known room")

    def test_missing_and_relative_files(self):
        self.expect_complaint("Filters/Core/Base/Box.h", '#include "Core/Base/None.h"\n',
            "which there is not")
        self.expect_complaint("Filters/Core/Base/Box.h", '#include "../Base/Types.h"\n',
            "which there is not")

    def test_circles(self):
        found = self.complaints_with(files={
            "Filters/Core/Base/A.h": '#include "Core/Base/B.h"\n',
            "Filters/Core/Base/B.h": '#include "Core/Base/A.h"\n'})
        self.assertEqual(found, ["circle: Core/Base/A.h -> Core/Base/B.h -> Core/Base/A.h"])


def main(arguments):
    if arguments == ["--self-test"]:
        return unittest.main(argv=["TestLayers.py"], exit=False).result.wasSuccessful()
    if len(arguments) != 1:
        sys.exit(__doc__)
    checker = Checker(arguments[0])
    if not checker.files:
        sys.exit(f"No sources below {arguments[0]}")
    found = checker.complaints()
    for complaint in found:
        print(complaint)
    print(f"{len(checker.files)} files, {len(found)} complaints")
    return not found


if __name__ == "__main__":
    sys.exit(0 if main(sys.argv[1:]) else 1)
