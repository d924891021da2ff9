# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestReconstruct.py: the function of the Python package, for arrays of NumPy."""

import contextlib
import inspect
import io
import os
import re
import typing
import unittest
import warnings
import xml.etree.ElementTree

import numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

import orthogonalslices
from orthogonalslices import (
    ReconstructionError,
    ReconstructionWarning,
    contours,
    polydata_of,
    reconstruct,
    reconstruction,
)
from orthogonalslices.vtkFiltersOrthogonalSlices import vtkOrthogonalSliceReconstruction

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
PROXIES = os.path.join(ROOT, "Plugin", "OrthogonalSliceReconstruction.xml")
PAGE = os.path.join(ROOT, "Filters", "Python", "README.md")


def circles(axis, count=9, radius=1.0, center=(0.0, 0.0, 0.0), corners=90):
    """Sections of a ball across an axis, counter-clockwise, without the first point again."""
    angles = numpy.arange(corners) * 2 * numpy.pi / corners
    loops = []
    for height in numpy.linspace(-radius, radius, count + 2)[1:-1]:
        width = (radius**2 - height**2)**0.5
        loop = numpy.empty((corners, 3))
        loop[:, (axis + 1) % 3] = width * numpy.cos(angles)
        loop[:, (axis + 2) % 3] = width * numpy.sin(angles)
        loop[:, axis] = height
        loops.append(loop + center)
    return loops


def ball(**arguments):
    return [circles(axis, **arguments) for axis in range(3)]


def volume_of(points, triangles):
    """Positive if the triangles are counter-clockwise seen from outside."""
    a, b, c = (points[triangles[:, side]].astype(float) for side in range(3))
    return numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6


def loose_edges(triangles):
    """Edges that do not run once in each direction."""
    edges = numpy.concatenate([triangles[:, [side, (side + 1) % 3]] for side in range(3)])
    there, back = ({tuple(edge) for edge in order.tolist()} for order in (edges, edges[:, ::-1]))
    return len(there ^ back) + len(edges) - len(there)


BALL = 4 / 3 * numpy.pi


class Surfaces(unittest.TestCase):
    def setUp(self):
        # No test expects a warning that it does not ask for.
        self.filters = warnings.catch_warnings()
        self.filters.__enter__()
        self.addCleanup(self.filters.__exit__, None, None, None)
        warnings.simplefilter("error")

    def test_ball_from_arrays(self):
        points, triangles, report = reconstruct(*ball())
        self.assertEqual(points.shape, (points.shape[0], 3))
        self.assertEqual(points.dtype, numpy.float64)
        self.assertEqual(loose_edges(triangles), 0)
        self.assertAlmostEqual(volume_of(points, triangles) / BALL, 1.0, delta=0.01)
        self.assertEqual(report.warnings, ())
        self.assertEqual((report.fields["NumberOfComponents"], report.fields["TotalGenus"]), (1, 0))
        self.assertEqual(report.fields["NumberOfContours"], 27)
        self.assertEqual(report.point_data["Normals"].shape, points.shape)
        self.assertEqual(len(report.cell_data["ComponentId"]), len(triangles))
        self.assertEqual(len(report.slices["RmsDisagreement"]), 27)
        self.assertEqual(len(report.contours["Port"]), 27)
        self.assertEqual(len(report.undecided["PlaneRank"]), 0)
        self.assertEqual(len(report.problems["Kind"]), 0)
        self.assertAlmostEqual(report.components["Volume"][0], volume_of(points, triangles))
        self.assertEqual(report.surface.GetNumberOfPolys(), len(triangles))
        self.assertEqual(report.graph.GetNumberOfVerts(), report.fields["NumberOfNodePoints"])
        # Each arc is a side of two patches.
        sides = (report.histogram["PolygonSize"] * report.histogram["Count"]).sum()
        isolated = report.fields["NumberOfIsolatedContours"]
        self.assertEqual(sides, 2 * (report.graph.GetNumberOfLines() - isolated))

    def test_same_surface_from_every_form_of_the_contours(self):
        x, y, z = ball()
        expected = reconstruct(x, y, z)
        repeated = [[numpy.vstack((loop, loop[:1])) for loop in loops] for loops in (x, y, z)]
        lists = [[loop.tolist() for loop in loops] for loops in (x, y, z)]
        stacked = [numpy.array(loops) for loops in (x, y, z)]
        forms = (
            dict(zip("xyz", repeated)),
            dict(zip("xyz", repeated), closed=False),
            dict(zip("xyz", lists)),
            dict(zip("xyz", stacked)),
            dict(zip("xyz", map(tuple, (x, y, z)))),
            dict(x=polydata_of(x), y=y, z=z),
            dict(x=x, contours=polydata_of(y + z)),
        )
        for form in forms:
            points, triangles, _ = reconstruct(**form)
            with self.subTest(form=list(form)):
                self.assertEqual(len(points), len(expected.points))
                self.assertAlmostEqual(volume_of(points, triangles),
                                       volume_of(*expected[:2]), delta=1e-9)
        halves = [half for loop in z for half in (loop[:46], numpy.vstack((loop[45:], loop[:1])))]
        report = reconstruct(z=halves, closed=False).report
        self.assertEqual(report.fields["NumberOfContours"], 9)

    def test_one_stack_and_one_contour(self):
        surface = reconstruct(z=circles(2))
        self.assertEqual(loose_edges(surface.triangles), 0)
        self.assertAlmostEqual(volume_of(*surface[:2]) / BALL, 1.0, delta=0.02)
        plate = reconstruct(z=circles(2, count=1)[0], end_caps="Half Slice")
        self.assertAlmostEqual(numpy.ptp(plate.points[:, 2]), 1.0, delta=0.05)

    def test_precision_is_that_of_the_contours(self):
        single = [[loop.astype(numpy.float32) for loop in loops] for loops in ball()]
        self.assertEqual(reconstruct(*single).points.dtype, numpy.float32)
        double = reconstruct(*single, output_points_precision="Double")
        self.assertEqual(double.points.dtype, numpy.float64)

    def test_structures_by_name_and_by_number(self):
        for labels in (("left", "right"), (3, 7)):
            sets = [dict(zip(labels, pair)) for pair in
                    zip(ball(), ball(center=(3.0, 0.0, 0.0), radius=0.5))]
            points, triangles, report = reconstruct(*sets)
            self.assertEqual(report.fields["NumberOfComponents"], 2)
            found = report.cell_data["Label"]
            for number, volume in zip(numpy.unique(found), (BALL, BALL / 8)):
                part = triangles[found == number]
                self.assertEqual(loose_edges(part), 0)
                self.assertAlmostEqual(volume_of(points, part) / volume, 1.0, delta=0.01)
            self.assertEqual(report.fields["LabelNames"].tolist(), [str(label) for label in labels])
        data = polydata_of({"a": circles(0)[:2], "b": circles(0)[2:]})
        self.assertEqual([data.GetCellData().GetAbstractArray("Label").GetValue(cell)
                          for cell in range(9)], ["a"] * 2 + ["b"] * 7)
        named = reconstruct(contours=data, label_array="None").report
        self.assertEqual(named.fields["NumberOfContours"], 9)

    def test_results_outlive_the_filter(self):
        points, _, report = reconstruct(*ball())
        copy, normals = points.copy(), report.point_data["Normals"].copy()
        reconstruct(*ball(radius=2.0))
        numpy.testing.assert_array_equal(points, copy)
        numpy.testing.assert_array_equal(report.point_data["Normals"], normals)

    def test_warnings_of_the_filter(self):
        x, y, z = ball()
        y[4] = y[4] + (0.05, 0.0, 0.0)
        with self.assertWarnsRegex(ReconstructionWarning, "contradict"):
            surface = reconstruct(x, y, z)
        self.assertEqual(len(surface.report.warnings), 1)
        table = surface.report.slices
        worst = numpy.argmax(table["RmsDisagreement"])
        self.assertEqual((table["SliceAxis"][worst], table["SlicePlane"][worst]), (1, 4))


class Mistakes(unittest.TestCase):
    def test_what_the_filter_refuses_is_an_exception_with_its_text(self):
        with self.assertRaisesRegex(ReconstructionError, "contours"):
            reconstruct()
        with self.assertRaisesRegex(ReconstructionError, "contours"):
            reconstruct(z=[])
        with self.assertRaisesRegex(ReconstructionError, '"Structure"'):
            reconstruct(z=circles(2), label_array="Structure")
        loose = [loop[:60] for loop in circles(2)]
        with self.assertRaisesRegex(ReconstructionError, "open"):
            reconstruct(z=loose, closed=False, invalid_contours="Refuse")
        with self.assertRaisesRegex(ReconstructionError, "[Ww]eight"):
            reconstruct(*ball(), axis_weights=(1, -1, 1))

    def test_arguments_that_are_none(self):
        for wrong, error, text in (
                (dict(z=numpy.zeros((5, 2))), ValueError, r"n x 3 .* \(5, 2\)"),
                (dict(z=[numpy.zeros(3)]), ValueError, r"n x 3"),
                (dict(z="contours.vtp"), TypeError, "not str"),
                (dict(z=3.0), TypeError, "not float"),
                (dict(z={1: circles(2), "b": circles(2)}), TypeError, "all texts"),
                (dict(patch_type="Fans"), ValueError, "none of 'Smooth', 'Fan', 'Coons'"),
                (dict(patch_type=3), ValueError, "patch_type=3 is out of range"),
                (dict(edge_length=50), ValueError, "edge_length=50 .* nearest value is 10"),
                (dict(smoothing="a"), TypeError, "smoothing"),
                (dict(axis_weights=(1, 2)), TypeError, "axis_weights"),
                (dict(colour=1), TypeError, "colour")):
            with self.subTest(wrong=list(wrong)), self.assertRaisesRegex(error, text):
                reconstruct(**{"z": circles(2), **wrong})


class Properties(unittest.TestCase):
    def names_of_the_filter(self):
        """What is set and read under one name, by the class itself."""
        own = set(dir(vtkOrthogonalSliceReconstruction))
        own -= set(dir(vtkOrthogonalSliceReconstruction.__mro__[1]))
        names = {name[3:] for name in own if name.startswith("Set") and "Get" + name[3:] in own}
        names.remove("Controller")  # of parallel programs; arrays are of one process
        self.assertGreater(len(names), 30)
        return names

    def keywords(self):
        parameters = inspect.signature(reconstruct).parameters.values()
        return [one.name for one in parameters if one.kind == one.KEYWORD_ONLY
                and one.name != "closed"]

    def test_every_property_is_a_keyword(self):
        self.assertEqual({reconstruction.property_name(name) for name in self.keywords()},
                         self.names_of_the_filter())

    def test_every_keyword_reaches_the_filter(self):
        for keyword in self.keywords():
            default = vtkOrthogonalSliceReconstruction()
            name = reconstruction.property_name(keyword)
            value = getattr(default, "Get" + name)()
            if isinstance(value, tuple):
                value = [number + 0.5 for number in value]
            elif isinstance(value, bool):
                value = not value
            elif isinstance(value, int):
                value = 0 if value else 1
            elif isinstance(value, float):
                value = value / 2 or 0.25
            else:
                value = "Label"
            reconstruction.set_property(default, keyword, value)
            found = getattr(default, "Get" + name)()
            self.assertEqual(list(found) if isinstance(found, tuple) else found, value, keyword)

    def test_values_of_numpy(self):
        filter_ = vtkOrthogonalSliceReconstruction()
        for keyword, value, found in (("edge_length", numpy.float32(0.5), 0.5),
                                      ("expected_components", numpy.int64(3), 3),
                                      ("compute_normals", numpy.bool_(False), False),
                                      ("patch_type", numpy.int32(2), 2),
                                      ("axis_weights", numpy.array([1, 2, 3]), (1.0, 2.0, 3.0)),
                                      ("frame_normals", numpy.eye(3), tuple(numpy.eye(3).flat))):
            reconstruction.set_property(filter_, keyword, value)
            name = reconstruction.property_name(keyword)
            self.assertEqual(getattr(filter_, "Get" + name)(), found)

    def test_texts_of_enumerations_are_those_of_the_panel(self):
        root = xml.etree.ElementTree.parse(PROXIES).getroot()
        proxy, = root.findall(".//SourceProxy[@name='OrthogonalSliceReconstruction']")
        listed = {}
        for element in proxy.iter("IntVectorProperty"):
            entries = element.findall("./EnumerationDomain/Entry")
            if entries:
                listed[element.get("name")] = {
                    entry.get("text"): int(entry.get("value")) for entry in entries}
        here = {reconstruction.property_name(keyword): {
                    text: number for number, text in enumerate(typing.get_args(texts))}
                for keyword, texts in reconstruction.ENUMERATIONS.items()}
        self.assertEqual(here, listed)

    def test_type_hints(self):
        hints = typing.get_type_hints(reconstruct)
        self.assertEqual(set(hints), {*inspect.signature(reconstruct).parameters, "return"})
        for keyword, texts in reconstruction.ENUMERATIONS.items():
            self.assertIn(texts, typing.get_args(hints[keyword]))
        folder = os.path.dirname(orthogonalslices.__file__)
        self.assertTrue(os.path.exists(os.path.join(folder, "py.typed")))
        for function in (reconstruct, polydata_of, contours.loops_of, orthogonalslices.Report):
            self.assertTrue(function.__doc__)

    def test_what_is_no_array_is_left_as_it_is(self):
        data = vtkPolyData()
        self.assertIs(polydata_of(data), data)
        self.assertRegex(orthogonalslices.__version__, r"^\d+\.\d+\.\d+$")


class Page(unittest.TestCase):
    def test_blocks_run_and_say_what_is_true(self):
        with open(PAGE, encoding="utf-8") as page:
            blocks = re.findall("^```python\n(.*?)^```", page.read(), re.DOTALL | re.MULTILINE)
        self.assertGreater(len(blocks), 5)
        folder = os.getcwd()
        self.addCleanup(os.chdir, folder)
        os.chdir(ROOT)
        names = {}
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            for block in blocks:
                exec(compile(block, PAGE, "exec"), names)  # pylint: disable=exec-used
        self.assertAlmostEqual(volume_of(names["points"], names["triangles"]) / BALL, 1, delta=0.01)
        self.assertEqual(loose_edges(names["left"]), 0)
        self.assertRegex(said.getvalue(), "(?s)left.*right.*contradict")
        self.assertEqual(len(names["normals"]), len(names["points"]))
        self.assertEqual(loose_edges(names["knot"].triangles), 0)


if __name__ == "__main__":
    unittest.main()
