# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestFormats.py: contours and labels in every format that is read, surfaces in every format
that is written, and ReconstructAny.py as a user calls it."""

import contextlib
import importlib.util
import io
import json
import math
import os
import sys
import tempfile
import unittest
import zipfile

import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
sys.path.insert(0, os.path.join(HERE, "..", "..", "Plugin", "Examples"))

import FormatFiles as files
import ReconstructAny
from Formats import Dicom, LabelMaps, Stencil, Surfaces, read_structures
from Formats.Filter import reconstruct
from Formats.Images import first_sample, samples_of, steps_of
from Formats.Structures import FormatError, Structure, loops_of
from vtkmodules.vtkFiltersCore import (
    vtkCleanPolyData,
    vtkFeatureEdges,
    vtkMassProperties,
    vtkTriangleFilter,
)
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

BALL = 4 / 3 * math.pi * 10**3
# Axes of an image that are turned by 30 degrees around x and flipped: no coordinate axis but x.
OBLIQUE = numpy.array([[0, 1, 0], [math.sqrt(0.75), 0, -0.5], [-0.5, 0, -math.sqrt(0.75)]])
# The same coordinate axes in another order, one of them reversed: left-handed.
PERMUTED = numpy.array([[0, 0, 1], [-1, 0, 0], [0, -1, 0.0]])
SPACING = numpy.array([0.8, 1.0, 1.25])
ORIGIN = numpy.array([-20.0, 35.0, 7.0])


def has(module):
    return importlib.util.find_spec(module) is not None


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


def centroid(points):
    points = numpy.asarray(points)
    return (points.max(axis=0) + points.min(axis=0)) / 2


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


class Rtstruct(FormatTest):
    def structures(self):
        """A ball, a smaller one with a piece that is open, a mark and a structure without contours."""
        ball = [("CLOSED_PLANAR", loop) for loop in files.ball_stack(center=(5, -3, 40))]
        small = [("CLOSED_PLANAR", loop) for loop in files.ball_stack(4, 1, (30, 0, 40))]
        small.append(("OPEN_PLANAR", files.circle(3, 50.0)[:9]))
        mark = [("POINT", [(1, 2, 3)])]
        return [(7, "Heart", (255, 0, 10), ball), (12, "Tumor bed 1", None, small),
                (13, "Isocenter", (0, 0, 255), mark), (14, "Empty", None, [])]

    def check_read(self, access):
        path = self.path("plan.dcm")
        files.write_rtstruct(path, self.structures())
        heart, tumor = Dicom.read_rtstruct(path, access)
        self.assertEqual((heart.name, heart.label, heart.color), ("Heart", 7, (255, 0, 10)))
        self.assertEqual((tumor.name, tumor.label, tumor.color), ("Tumor bed 1", 12, None))
        self.check_loops(heart, files.ball_stack(center=(5, -3, 40)), 0.005 + 1e-9)
        self.assertEqual(len(tumor.loops), 9)
        self.assertFalse(numpy.array_equal(tumor.loops[-1][0], tumor.loops[-1][-1]))
        self.check_ball(heart, (5, -3, 40))

    @unittest.skipUnless(has("pydicom"), "writing needs pydicom")
    def test_pydicom_reads_all_structures(self):
        self.check_read(Dicom.PydicomAccess())

    @unittest.skipUnless(has("pydicom") and has("gdcm"), "writing needs pydicom, reading GDCM")
    def test_gdcm_reads_all_structures(self):
        self.check_read(Dicom.GdcmAccess())

    @unittest.skipUnless(has("pydicom"), "writing needs pydicom")
    def test_other_modalities_are_refused(self):
        files.write_rtstruct(self.path("plan"), self.structures(), modality="CT")
        with self.assertRaisesRegex(FormatError, "no structure set .* 'CT'"):
            read_structures(self.path("plan"))

    def test_without_a_library_one_sentence_says_so(self):
        def missing():
            raise ImportError

        with self.assertRaisesRegex(FormatError, "apt-get install python3-pydicom"):
            Dicom.find_access((missing, missing))


class LabelImages(FormatTest):
    SHAPE = (22, 28, 34)
    CENTER = numpy.array([16.3, 13.6, 10.2]) # in samples, i, j, k

    def center(self, steps):
        return ORIGIN + steps @ self.CENTER

    def samples(self, steps):
        """A ball of radius 8 in the world, as labels 3; and a box of labels 5 in a corner."""
        places = numpy.indices(self.SHAPE)[::-1].reshape(3, -1) - self.CENTER[:, None]
        inside = numpy.linalg.norm(steps @ places, axis=0) <= 8.0
        samples = numpy.where(inside, 3, 0).astype(numpy.uint8).reshape(self.SHAPE)
        samples[1:5, 2:6, 1:7] = 5
        return samples

    def written(self):
        """All ways to write the same image, with the axes it has and how exact the file can be."""
        for name, axes in (("permuted", PERMUTED), ("oblique", OBLIQUE)):
            steps = axes * SPACING
            samples = self.samples(steps)
            for ending in (".nrrd", "-text.nrrd", "-ras.nrrd", ".mha", "-s.nii", "-q.nii"):
                path = self.path(name + ending)
                ras = numpy.diag([-1.0, -1.0, 1.0])
                if ending == "-ras.nrrd":
                    files.write_nrrd(path, samples, ras @ steps, ras @ ORIGIN,
                                     "right-anterior-superior", "raw")
                elif ending.endswith(".nrrd"):
                    files.write_nrrd(path, samples, steps, ORIGIN,
                                     encoding="text" if "text" in ending else "gzip")
                elif ending == ".mha":
                    files.write_mha(path, samples, steps, ORIGIN)
                else:
                    files.write_nii(path, samples, steps, ORIGIN, "sform" if "-s" in ending else "qform")
                yield path, steps, 1e-4 if ending.endswith(".nii") else 1e-9

    def check_image(self, image, samples, steps, tolerance):
        """The same labels at the same places, in whatever order the samples are."""
        found = samples_of(image)
        for label in (3, 5):
            wanted = steps @ numpy.argwhere(samples == label)[:, ::-1].T + ORIGIN[:, None]
            places = (steps_of(image) @ numpy.argwhere(found == label)[:, ::-1].T
                      + first_sample(image)[:, None])
            self.assertEqual(places.shape, wanted.shape)
            order = [numpy.lexsort(numpy.round(array, 2)) for array in (wanted, places)]
            numpy.testing.assert_allclose(places[:, order[1]], wanted[:, order[0]], atol=tolerance)

    def test_images_are_read_with_their_directions(self):
        for path, steps, tolerance in self.written():
            with self.subTest(path=os.path.basename(path)):
                (image, names), = LabelMaps.read_label_images(path)
                self.assertEqual(names, {})
                self.check_image(image, self.samples(steps), steps, tolerance)

    def test_what_is_written_is_read_back(self):
        for axes in (PERMUTED, OBLIQUE, numpy.eye(3)):
            steps = axes * SPACING
            files.write_nrrd(self.path("image.nrrd"), self.samples(steps), steps, ORIGIN)
            (image, _), = LabelMaps.read_label_images(self.path("image.nrrd"))
            for ending in LabelMaps.WRITTEN:
                with self.subTest(ending=ending, axes=axes):
                    LabelMaps.write_label_image(image, self.path("again" + ending))
                    (again, _), = LabelMaps.read_label_images(self.path("again" + ending))
                    self.check_image(again, self.samples(steps), steps,
                                     1e-4 if ending.startswith(".nii") else 1e-9)

    def test_contours_lie_in_the_world(self):
        for path, steps, tolerance in self.written():
            with self.subTest(path=os.path.basename(path)):
                ball, box = read_structures(path)
                self.assertEqual([ball.label, box.label], [3, 5])
                points = numpy.vstack([loop for piece in ball.contours() for loop in loops_of(piece)])
                distances = numpy.linalg.norm(points - self.center(steps), axis=1)
                self.assertLess(abs(distances - 8.0).max(), 0.75)
                self.assertAlmostEqual(distances.mean(), 8.0, delta=0.15)

    def test_permuted_images_make_surfaces_where_they_belong(self):
        steps = PERMUTED * SPACING
        files.write_mha(self.path("ball.mha"), self.samples(steps), steps, ORIGIN)
        ball, box = read_structures(self.path("ball.mha"))
        surface = reconstruct(ball)
        self.assertEqual(loose_edges(surface), 0)
        self.assertAlmostEqual(volume_of(surface), 4 / 3 * math.pi * 8**3, delta=0.03 * BALL)
        numpy.testing.assert_allclose(surface.GetCenter(), self.center(steps), atol=0.3)
        self.assertAlmostEqual(volume_of(reconstruct(box)), 4 * 4 * 6, delta=0.1 * 96)

    def test_blur_takes_the_steps_out(self):
        for axes in (PERMUTED, OBLIQUE):
            steps = axes * SPACING
            path = self.path("ball.nrrd")
            files.write_nrrd(path, self.samples(steps), steps, ORIGIN)
            deviations = []
            for blur in (0.0, 0.7):
                ball, _ = read_structures(path, blur=blur)
                points = numpy.vstack([loop for piece in ball.contours() for loop in loops_of(piece)])
                deviations.append(numpy.std(numpy.linalg.norm(points - self.center(steps), axis=1)))
            self.assertLess(deviations[1], 0.7 * deviations[0])

    def test_segments_of_slicer_keep_layers_and_names(self):
        first = files.ball_labels(self.SHAPE, (10, 12, 10), 6, 1)
        second = files.ball_labels(self.SHAPE, (14, 12, 10), 6, 1) # overlaps the first one
        second[1:4, 1:4, 1:4] = 2
        keys = ["Segment0_Name:=left lung", "Segment0_LabelValue:=1", "Segment0_Layer:=0",
                "Segment1_Name:=heart", "Segment1_LabelValue:=1", "Segment1_Layer:=1",
                "Segment2_Name:=node", "Segment2_LabelValue:=2", "Segment2_Layer:=1"]
        path = self.path("scan.seg.nrrd")
        files.write_nrrd(path, numpy.stack((first, second)), numpy.eye(3), ORIGIN, keys=keys)
        structures = read_structures(path)
        self.assertEqual([structure.name for structure in structures], ["left lung", "heart", "node"])
        for structure, i in zip(structures, (10, 14)):
            x = loops_of(structure.contours()[2])
            numpy.testing.assert_allclose(centroid(numpy.vstack(x)), ORIGIN + (i, 12, 10), atol=1e-3)

    def test_images_that_are_no_label_images_are_refused(self):
        path = self.path("flat.nrrd")
        files.write_nrrd(path, self.samples(numpy.eye(3)), numpy.diag([1.0, 1.0, 0.0]), ORIGIN)
        with self.assertRaisesRegex(FormatError, "lie in one plane"):
            read_structures(path)
        with open(path, "wb") as file:
            file.write(b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: 9 9 9\nencoding: raw\n\n123")
        with self.assertRaisesRegex(FormatError, "fewer samples"):
            read_structures(path)


class TextTables(FormatTest):
    def test_columns_are_found_by_name(self):
        stack = files.ball_stack()
        rows = ["Structure;Slice;Y [mm];X [mm];Z [mm]"]
        rows += [f"ball;{number};{y:.9f};{x:.9f};{z:.9f}" for number, loop in enumerate(stack)
                 for x, y, z in loop]
        rows += [f"cube;0;{y};{x};50" for x, y in ((0, 0), (9, 0), (9, 9), (0, 9))]
        ball, cube = read_structures(self.write("table.csv", "\n".join(rows)))
        self.assertEqual((ball.name, ball.label, cube.name, cube.label), ("ball", 1, "cube", 2))
        self.check_loops(ball, stack, 1e-8)
        self.check_loops(cube, [[(0, 0, 50), (9, 0, 50), (9, 9, 50), (0, 9, 50)]])
        self.check_ball(ball)

    def test_contours_are_told_apart_without_a_column(self):
        stack = files.ball_stack()
        lines = ["\n".join(f"{x:.9f} {y:.9f} {z:.9f}" for x, y, z in loop) for loop in stack]
        two = files.circle(2, 30.0), files.circle(2, 30.0, (9, 9))
        closed = "\n".join(f"{x!r} {y!r} {z!r}" for loop in two
                           for x, y, z in numpy.vstack((loop, loop[:1])).tolist())
        for name, text in (("empty", "\n\n".join(lines)), ("planes", "\n".join(lines)),
                           ("comma", "\n\n".join(lines).replace(".", ",").replace(" ", ";"))):
            with self.subTest(name=name):
                structure, = read_structures(self.write(name + ".txt", text))
                self.check_loops(structure, stack, 1e-8)
        structure, = read_structures(self.write("closed.xyz", closed))
        self.check_loops(structure, two)

    def test_slicers_tables_are_turned_to_lps(self):
        rows = ["label,r,a,s"] + [f"F,{-x:.9f},{-y:.9f},{z:.9f}" for x, y, z in files.circle(3, 5.0)]
        structure, = read_structures(self.write("curve.csv", "\n".join(rows)))
        self.check_loops(structure, [files.circle(3, 5.0)], 1e-8)

    def test_coordinates_of_imagej_take_the_slice_from_the_name(self):
        for number in (4, 5):
            text = "\n".join(f"{x:.3f}\t{y:.3f}" for x, y, _ in files.circle(20, 0, (30, 40)))
            path = self.write(f"cell_{number:03}.txt", text)
            structure, = read_structures(path, voxel=(0.5, 0.5, 3.0))
            self.check_loops(structure, [files.circle(10, 3.0 * (number - 1), (15, 20))], 1e-3)

    def test_rows_that_are_no_points_are_named(self):
        with self.assertRaisesRegex(FormatError, "line 3 has no point: 1 2 north"):
            read_structures(self.write("bad.csv", "x,y,z\n1,2,3\n1,2,north\n"))
        with self.assertRaisesRegex(FormatError, "no columns named x, y and z, but a, b, c"):
            read_structures(self.write("bad.csv", "a,b,c\n1,2,3\n"))
        with self.assertRaisesRegex(FormatError, "no points"):
            read_structures(self.write("bad.csv", "\n"))


class CrossSections(FormatTest):
    def test_csl_has_labels_and_holes(self):
        planes = []
        for z in (0.0, 2.0, 4.0):
            components = [(1, "", files.circle(10, z)), (1, "h0", files.circle(5, z)[::-1]),
                          (2, "", files.circle(4, z, (30, 0)))]
            planes.append(((0.0, 0.0, 1.0, -z), components))
        files.write_csl(self.path("pipe.csl"), planes)
        pipe, rod = read_structures(self.path("pipe.csl"))
        self.assertEqual((pipe.label, len(pipe.loops), rod.label, len(rod.loops)), (1, 6, 2, 3))
        self.check_loops(rod, [files.circle(4, z, (30, 0)) for z in (0, 2, 4)])
        surface = reconstruct(pipe)
        self.assertEqual(loose_edges(surface), 0)
        self.assertEqual(surface.GetFieldData().GetArray("TotalGenus").GetValue(0), 1)

    def test_contour_has_materials_on_both_sides_of_its_edges(self):
        planes = []
        for z in (0.0, 1.0, 2.0, 3.0):
            # Two squares, material 1 on the left and 2 on the right, with a common edge from 1 to 4.
            points = [(0, 0, z), (5, 0, z), (10, 0, z), (10, 5, z), (5, 5, z), (0, 5, z)]
            edges = [(0, 1, 1, 0), (1, 2, 2, 0), (2, 3, 2, 0), (3, 4, 2, 0), (4, 5, 1, 0),
                     (5, 0, 1, 0), (1, 4, 1, 2)]
            planes.append(((0, 0, 1, -z), points, edges))
        files.write_contour(self.path("two.contour"), planes)
        left, right = read_structures(self.path("two.contour"))
        for structure, low in ((left, 0), (right, 5)):
            self.assertEqual(len(structure.loops), 4)
            for loop in structure.loops:
                self.assertEqual(len(loop), 5)
                numpy.testing.assert_array_equal(loop[0], loop[-1])
                numpy.testing.assert_array_equal(loop[:, :2].min(axis=0), (low, 0))
                numpy.testing.assert_array_equal(loop[:, :2].max(axis=0), (low + 5, 5))
            self.assertAlmostEqual(volume_of(reconstruct(structure)), 75.0, delta=1.0)

    def test_planes_of_all_directions_are_sorted(self):
        circles = [files.circle(3, z) for z in (-1.0, 0.0, 1.0)]
        planes = [((0, 0, 0, 0), [(1, "", loop[:, order])]) for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
                  for loop in circles]
        files.write_csl(self.path("three.csl"), planes)
        structure, = read_structures(self.path("three.csl"))
        self.assertEqual([piece.GetNumberOfLines() for piece in structure.contours()], [3, 3, 3])
        for axis, piece in enumerate(structure.contours()):
            for loop in loops_of(piece):
                self.assertEqual(numpy.ptp(loop[:, axis]), 0.0)

    def test_files_that_end_early_are_refused(self):
        with self.assertRaisesRegex(FormatError, "ends too early"):
            read_structures(self.write("short.csl", "CSLC\n1 2\n1 3 1 0 0 1 0\n0 0 0\n"))
        with self.assertRaisesRegex(FormatError, "vertex 9 of a plane with 3"):
            read_structures(self.write("bad.contour", "1\n0 0 1 0\n3 1\n0 0 0\n1 0 0\n0 1 0\n0 9 1 0\n"))
        with self.assertRaisesRegex(FormatError, "does not begin with the word CSLC"):
            read_structures(self.write("bad.csl", "1 2"))


class ImageJAndSlicer(FormatTest):
    def test_selections_of_the_roi_manager(self):
        stack = [loop + (50, 60, 0) for loop in files.ball_stack(20, 2)]
        with zipfile.ZipFile(self.path("RoiSet.zip"), "w") as archive:
            for number, loop in enumerate(stack, 1):
                archive.writestr(f"{number:04}.roi", files.imagej_roi(loop[:, :2], number))
        structure, = read_structures(self.path("RoiSet.zip"), voxel=(0.5, 0.5, 1.0))
        expected = [numpy.column_stack((loop[:, :2] / 2, numpy.full(len(loop), float(number))))
                    for number, loop in enumerate(stack)]
        self.check_loops(structure, expected, 1e-5)
        self.check_ball(structure, (25, 30, 9.5))

    def test_a_selection_in_whole_pixels(self):
        square = [(3, 4), (8, 4), (8, 9), (3, 9)]
        with open(self.path("square.roi"), "wb") as file:
            file.write(files.imagej_roi(square, 6, kind=0, sub_pixel=False))
        structure, = read_structures(self.path("square.roi"))
        self.check_loops(structure, [[(x, y, 5) for x, y in square]])

    def test_selections_without_a_slice_are_refused(self):
        with open(self.path("square.roi"), "wb") as file:
            file.write(files.imagej_roi([(3, 4), (8, 4), (8, 9)], 0))
        with self.assertRaisesRegex(FormatError, "on no slice"):
            read_structures(self.path("square.roi"))

    def test_curves_of_slicer(self):
        stack = files.ball_stack(center=(1, 2, 3))
        for system, sign in (("LPS", 1), ("RAS", -1)):
            markups = [{"type": "ClosedCurve", "coordinateSystem": system, "controlPoints":
                        [{"position": [sign * x, sign * y, z], "positionStatus": "defined"}
                         for x, y, z in loop.tolist()]} for loop in stack]
            markups.append({"type": "Fiducial", "controlPoints": [{"position": [0, 0, 0]}]})
            path = self.write("curves.mrk.json", json.dumps({"markups": markups}))
            structure, = read_structures(path)
            self.check_loops(structure, stack)
        self.check_ball(structure, (1, 2, 3))

    def test_points_of_slicer_are_one_contour(self):
        loop = files.circle(5, 2.5)
        rows = "\n".join(f"id{i},{-x!r},{-y!r},{z!r},0,0,0,1,1,1,0,F-{i},,"
                         for i, (x, y, z) in enumerate(loop.tolist()))
        head = "# Markups fiducial file version = 4.10\n# CoordinateSystem = 0\n"
        head += "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
        structure, = read_structures(self.write("points.fcsv", head + rows))
        self.check_loops(structure, [loop])


class Results(FormatTest):
    READERS = {".stl": vtkSTLReader, ".obj": vtkOBJReader, ".ply": vtkPLYReader,
               ".vtp": vtkXMLPolyDataReader}

    def surfaces(self):
        structures = [Structure("left lung", 4), Structure("heart/1", 9)]
        for structure, x in zip(structures, (0.0, 40.0)):
            for loop in files.ball_stack(center=(x, 0, 0)):
                structure.add(loop)
        return [(structure, reconstruct(structure)) for structure in structures]

    def read(self, path):
        reader = self.READERS[os.path.splitext(path)[1]]()
        reader.SetFileName(path)
        clean = vtkCleanPolyData() # an STL has the points of each triangle by themselves
        clean.SetInputConnection(reader.GetOutputPort())
        clean.SetTolerance(0.0)
        clean.Update()
        return clean.GetOutput()

    def test_surfaces_are_read_back(self):
        surfaces = self.surfaces()
        for ending in Surfaces.ENDINGS:
            with self.subTest(ending=ending):
                path = self.path("one" + ending)
                self.assertEqual(Surfaces.write_surfaces(surfaces[:1], path), [path])
                again = self.read(path)
                self.assertEqual(loose_edges(again), 0)
                self.assertEqual(again.GetNumberOfPolys(), surfaces[0][1].GetNumberOfPolys())
                self.assertAlmostEqual(volume_of(again) / volume_of(surfaces[0][1]), 1.0, delta=1e-5)

    def test_several_surfaces_are_several_files_or_labels(self):
        surfaces = self.surfaces()
        names = Surfaces.write_surfaces(surfaces, self.path("all.stl"))
        self.assertEqual([os.path.basename(name) for name in names],
                         ["all-left_lung.stl", "all-heart_1.stl"])
        self.assertAlmostEqual(self.read(names[1]).GetCenter()[0], 40.0, delta=0.01)
        name, = Surfaces.write_surfaces(surfaces, self.path("all.vtp"))
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(name)
        reader.Update()
        self.assertEqual(reader.GetOutput().GetCellData().GetArray("Label").GetRange(), (4.0, 9.0))
        names = reader.GetOutput().GetFieldData().GetAbstractArray("Names")
        self.assertEqual([names.GetValue(i) for i in range(2)], ["left lung", "heart/1"])

    def test_labels_on_a_given_grid(self):
        """The label image of a surface on an oblique grid has its volume, at its place; and back."""
        surfaces = self.surfaces()
        for axes in (numpy.eye(3), PERMUTED, OBLIQUE):
            steps = axes * 0.7
            counts = numpy.array([100, 100, 100])
            origin = numpy.array([20.0, 0, 0]) - steps @ (counts - 1) / 2
            grid_samples = numpy.zeros(counts[::-1], dtype=numpy.uint8)
            files.write_nrrd(self.path("grid.nrrd"), grid_samples, steps, origin)
            (grid, _), = LabelMaps.read_label_images(self.path("grid.nrrd"))
            image = Surfaces.draw_labels(surfaces, grid)
            numpy.testing.assert_allclose(steps_of(image), steps, atol=1e-12)
            numpy.testing.assert_allclose(first_sample(image), origin, atol=1e-12)
            for (structure, surface), x in zip(surfaces, (0.0, 40.0)):
                places = numpy.argwhere(samples_of(image) == structure.label)[:, ::-1] @ steps.T + origin
                self.assertAlmostEqual(len(places) * 0.7**3 / volume_of(surface), 1.0, delta=0.01)
                numpy.testing.assert_allclose(places.mean(axis=0), (x, 0, 0), atol=0.05)
        self.assertEqual(set(numpy.unique(samples_of(image))), {0, 4, 9})


    def test_both_ways_to_fill_a_surface(self):
        """Rows cut here fill the same samples as VTK's stencil. Of a box whose faces lie on samples
        they fill those of one face of two, and none outside."""
        box = vtkCubeSource()
        box.SetBounds(2, 7, 3, 9, 1, 4.5)
        faces = vtkTriangleFilter()
        faces.SetInputConnection(box.GetOutputPort())
        clean = vtkCleanPolyData()
        clean.SetInputConnection(faces.GetOutputPort())
        clean.Update()
        inside = Stencil.inside_by_rows(clean.GetOutput(), (8, 12, 10))
        expected = numpy.zeros((8, 12, 10), dtype=bool)
        expected[2:5, 4:10, 2:7] = True
        numpy.testing.assert_array_equal(inside, expected)
        surface = Surfaces.moved(self.surfaces()[0][1], numpy.eye(3) * 1.7, (-12.3, -11.1, -10.7))
        rows = Stencil.inside_by_rows(surface, (40, 40, 40))
        self.assertAlmostEqual(rows.sum() / volume_of(surface), 1.0, delta=0.005)
        if Stencil.vtkPolyDataToImageStencil is not None:
            numpy.testing.assert_array_equal(rows, Stencil.inside_by_stencil(surface, (40, 40, 40)))


class CommandLine(FormatTest):
    def run_script(self, *arguments):
        out, errors = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
            status = ReconstructAny.main([*arguments])
        return status, out.getvalue(), errors.getvalue()

    def table(self, name, loops):
        rows = ["x,y,z,contour"] + [f"{x!r},{y!r},{z!r},{number}" for number, loop in enumerate(loops)
                                    for x, y, z in loop.tolist()]
        return self.write(name, "\n".join(rows))

    def test_three_views_of_one_object(self):
        stack = files.ball_stack()
        tables = [self.table(name, [loop[:, order] for loop in stack])
                  for name, order in (("x.csv", [2, 0, 1]), ("y.csv", [1, 2, 0]), ("z.csv", [0, 1, 2]))]
        status, out, errors = self.run_script(*tables, self.path("ball.ply"))
        self.assertEqual((status, errors), (0, ""))
        self.assertRegex(out, "contours: 30 contours, .*components 1, genus 0")
        reader = vtkPLYReader()
        reader.SetFileName(self.path("ball.ply"))
        reader.Update()
        self.assertAlmostEqual(volume_of(reader.GetOutput()) / BALL, 1.0, delta=0.01)

    def test_labels_in_labels_out(self):
        samples = files.ball_labels((30, 30, 30), (14, 15, 13), 10, 2)
        files.write_mha(self.path("in.mha"), samples, PERMUTED * 0.9, ORIGIN)
        status, out, errors = self.run_script(self.path("in.mha"), self.path("out.nrrd"), "--slices",
                                              "12", "--set", "Smoothing=0.5")
        self.assertEqual((status, errors), (0, ""))
        (image, _), = LabelMaps.read_label_images(self.path("out.nrrd"))
        again = samples_of(image)
        overlap = 2 * numpy.sum((again == 2) & (samples == 2)) / numpy.sum((again == 2) + 0 + (samples == 2))
        self.assertGreater(overlap, 0.95)
        self.assertEqual(set(numpy.unique(again)), {0, 2})

    def test_chosen_structures_and_grids(self):
        rows = ["structure,x,y,z"] + [f"{name},{x + 30 * place!r},{y!r},{z!r}"
                                      for place, name in enumerate("abc") for loop in files.ball_stack()
                                      for x, y, z in numpy.vstack((loop, loop[:1])).tolist()]
        table = self.write("abc.csv", "\n".join(rows))
        status, out, _ = self.run_script("--list", table)
        self.assertEqual((status, out.split()), (0, "1 a: 10 contours 2 b: 10 contours "
                                                    "3 c: 10 contours".split()))
        status, out, _ = self.run_script(table, self.path("c.nii.gz"), "--structure", "c", "--spacing", "1")
        self.assertEqual(status, 0)
        self.run_script(table, self.path("all.seg.nrrd"), "--spacing", "2", "--contours",
                        self.path("contours.vtp"))
        again = read_structures(self.path("contours.vtp"))
        self.assertEqual([(one.label, one.name, len(one.loops)) for one in again],
                         [(1, "a", 10), (2, "b", 10), (3, "c", 10)])
        numpy.testing.assert_array_equal(again[2].loops[4][:-1], files.ball_stack(center=(60, 0, 0))[4])
        (image, names), = LabelMaps.read_label_images(self.path("all.seg.nrrd"))
        self.assertEqual(names, {1: "a", 2: "b", 3: "c"})
        (image, _), = LabelMaps.read_label_images(self.path("c.nii.gz"))
        self.assertAlmostEqual(numpy.sum(samples_of(image) == 3) / BALL, 1.0, delta=0.02)
        status, _, errors = self.run_script(table, self.path("c.stl"), "--structure", "d")
        self.assertEqual((status, errors), (1, "There is no structure 'd', but a, b, c.\n"))

    def test_one_failure_does_not_keep_others_from_being_written(self):
        rows = ["structure,contour,x,y,z", "line,0,0,0,0", "line,0,1,0,0", "line,0,2,0,0"]
        rows += [f"ball,{number},{x!r},{y!r},{z!r}" for number, loop in enumerate(files.ball_stack())
                 for x, y, z in loop.tolist()]
        status, out, errors = self.run_script(self.write("two.csv", "\n".join(rows)), self.path("o.stl"))
        self.assertEqual(status, 1)
        self.assertRegex(out, "ball: 10 contours")
        self.assertRegex(errors, "^line: ")
        self.assertTrue(os.path.exists(self.path("o.stl")))

    def test_what_cannot_be_done_is_said_in_one_sentence(self):
        for arguments, sentence in (
                (("none.csv", "o.stl"), "There is no none.csv.\n"),
                ((__file__, "o.stl"), f"{__file__} is of no format that is read here.\n")):
            self.assertEqual(self.run_script(*arguments), (1, "", sentence))
        table = self.table("ball.csv", files.ball_stack())
        self.assertEqual(self.run_script(table, self.path("none/o.stl"))[2],
                         f"There is no folder for {self.path('none/o.stl')}.\n")
        self.assertEqual(self.run_script(table, self.path("o.nrrd"))[2],
                         "A label image needs a grid: give --grid or --spacing.\n")
        self.assertRegex(self.run_script(table, self.path("o.doc"))[2], "surfaces are written as")
        self.assertRegex(self.run_script(table, self.path("o.stl"), "--set", "Colour=1")[2],
                         "no property Colour")


if __name__ == "__main__":
    unittest.main()
