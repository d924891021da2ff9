# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestContourFormats.py: contours in every format that is read."""

import importlib.util
import json
import unittest
import zipfile

import numpy

import FormatFiles as files
from FormatChecks import OBLIQUE, FormatTest, loose_edges, volume_of
from Formats import Dicom, read_structures
from Formats.Filter import reconstruct
from Formats.Structures import FormatError, Structure, merged


def has(module):
    return importlib.util.find_spec(module) is not None


class Rtstruct(FormatTest):
    def structures(self):
        """A ball, a smaller one with a piece that is open, a mark and a structure without
        contours."""
        ball = [("CLOSED_PLANAR", loop) for loop in files.ball_stack(center=(5, -3, 40))]
        small = [("CLOSED_PLANAR", loop) for loop in files.ball_stack(4, 1, (30, 0, 40))]
        small.append(("OPEN_PLANAR", files.circle(3, 50.0)[:9]))
        mark = [("POINT", [(1, 2, 3)])]
        return [(7, "Heart", (255, 0, 10), ball), (12, "Tumor bed 1", None, small),
                (13, "Isocenter", (0, 0, 255), mark), (14, "Empty", None, [])]

    def check_read(self, access):
        for implicit in (False, True):
            with self.subTest(implicit=implicit):
                path = self.path("plan.dcm")
                files.write_rtstruct(path, self.structures(), implicit=implicit)
                heart, tumor = Dicom.read_rtstruct(path, access)
                self.check_structures(heart, tumor)

    def check_structures(self, heart, tumor):
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

    def test_names_that_come_twice_stay_apart(self):
        one, two = Structure("GTV", 4), Structure("GTV", 4)
        self.assertEqual([one, two], merged([[one, two]]))
        self.assertEqual([4, 5], [one.label, two.label])

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
        # Two contours on one slice, and a contour with the same number on the next slice.
        rows = ["Slice_ID,pos_x,pos_y,pos_z"] + [f"1,{line}" for line in
                                                 closed.replace(" ", ",").splitlines()]
        structure, = read_structures(self.write("slice.csv", "\n".join(rows)))
        self.check_loops(structure, two)
        rows = ["contour/slice id,x,y,z"] + [f"1,{x!r},{y!r},{z!r}" for loop in stack
                                             for x, y, z in loop.tolist()]
        structure, = read_structures(self.write("same.csv", "\n".join(rows)))
        self.check_loops(structure, stack)

    def test_inclined_contours_stay_whole(self):
        inclined = [(0, 0, 0), (4, 0, 0), (4, 3, 3), (0, 3, 3)]
        rows = ["Points:0,Points:1,Points:2,id"] + [f"{x},{y},{z},7" for x, y, z in inclined]
        structure, = read_structures(self.write("inclined.csv", "\n".join(rows)))
        self.check_loops(structure, [inclined])

    def test_slicers_tables_are_turned_to_lps(self):
        rows = ["label,r,a,s"]
        rows += [f"F,{-x:.9f},{-y:.9f},{z:.9f}" for x, y, z in files.circle(3, 5.0)]
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
            # Two squares, material 1 on the left, 2 on the right, with a common edge from 1 to 4.
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

    def test_planes_may_have_any_direction(self):
        """Sections of a ball across the axes of a turned frame."""
        planes = []
        for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
            planes += [((0, 0, 0, 0), [(1, "", loop[:, order] @ OBLIQUE.T + (3, 4, 5))])
                       for loop in files.ball_stack()]
        files.write_csl(self.path("turned.csl"), planes)
        structure, = read_structures(self.path("turned.csl"))
        self.assertEqual(len(structure.loops), 30)
        self.check_ball(structure, (3, 4, 5))

    def test_files_that_end_early_are_refused(self):
        with self.assertRaisesRegex(FormatError, "ends too early"):
            read_structures(self.write("short.csl", "CSLC\n1 2\n1 3 1 0 0 1 0\n0 0 0\n"))
        with self.assertRaisesRegex(FormatError, "vertex 9 of a plane with 3"):
            text = "1\n0 0 1 0\n3 1\n0 0 0\n1 0 0\n0 1 0\n0 9 1 0\n"
            read_structures(self.write("bad.contour", text))
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

    def test_damaged_files_are_refused(self):
        for name in ("cut.zip", "cut.roi", "cut.nrrd", "cut.mha", "cut.nii", "cut.csv", "cut.csl",
                     "cut.contour", "cut.fcsv", "cut.mrk.json", "cut.vtp", "cut.dcm"):
            with self.subTest(name=name):
                with open(self.path(name), "wb") as file:
                    file.write(b"NRRD0004\nIout\xff 3 nothing")
                with self.assertRaises(FormatError):
                    read_structures(self.path(name))

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


if __name__ == "__main__":
    unittest.main()
