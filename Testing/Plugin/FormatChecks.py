# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of formats share: a folder for files, and measures of surfaces and contours."""

import math
import os
import sys
import tempfile
import unittest

import numpy
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "Plugin", "Examples"))

from Formats.Filter import reconstruct
from Formats.Structures import loops_of

BALL = 4 / 3 * math.pi * 10**3
# Axes of an image that are turned by 30 degrees around x and flipped: no coordinate axis but x.
OBLIQUE = numpy.array([[0, 1, 0], [math.sqrt(0.75), 0, -0.5], [-0.5, 0, -math.sqrt(0.75)]])
# The same coordinate axes in another order, one of them reversed: left-handed.
PERMUTED = numpy.array([[0, 0, 1], [-1, 0, 0], [0, 1, 0.0]])
SPACING = numpy.array([0.8, 1.0, 1.25])
ORIGIN = numpy.array([-20.0, 35.0, 7.0])


def volume_of(surface):
    mass = vtkMassProperties()
    mass.SetInputData(surface)
    return mass.GetVolume()


def loose_edges(surface):
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


def points_of(structure):
    """All points of a structure's contours."""
    return numpy.vstack([loop for piece in structure.contours() for loop in loops_of(piece)])


class FormatTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def check_ball(self, structure, center=(0, 0, 0), tolerance=0.02):
        """A closed ball of radius 10 around a place."""
        surface = reconstruct(structure)
        self.assertEqual(loose_edges(surface), 0)
        self.assertAlmostEqual(volume_of(surface) / BALL, 1.0, delta=tolerance)
        numpy.testing.assert_allclose(surface.GetCenter(), center, atol=0.25)
        return surface

    def check_loops(self, structure, loops, tolerance=1e-9):
        self.assertEqual(len(structure.loops), len(loops))
        for found, loop in zip(structure.loops, loops):
            numpy.testing.assert_array_equal(found[0], found[-1])
            numpy.testing.assert_allclose(found[:-1], loop, atol=tolerance)
