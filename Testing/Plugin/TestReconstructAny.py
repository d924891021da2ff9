# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestReconstructAny.py: surfaces in every format that is written, and ReconstructAny.py as
a user calls it."""

import contextlib
import io
import os
import unittest

import numpy
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import FormatFiles as files
from FormatChecks import BALL, OBLIQUE, ORIGIN, PERMUTED, FormatTest, loose_edges, volume_of
import ReconstructAny
from Formats import LabelMaps, Stencil, Surfaces, read_structures
from Formats.Filter import reconstruct
from Formats.Images import first_sample, samples_of, steps_of
from Formats.Structures import Structure


class Results(FormatTest):
    READERS = {".stl": vtkSTLReader, ".obj": vtkOBJReader, ".ply": vtkPLYReader,
               ".vtp": vtkXMLPolyDataReader}

    def surfaces(self):
        structures = [Structure("left lung", 4), Structure("heart/1", 9, (200, 30, 7))]
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
                ratio = volume_of(again) / volume_of(surfaces[0][1])
                self.assertAlmostEqual(ratio, 1.0, delta=1e-5)

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
        colors = reader.GetOutput().GetCellData().GetArray("Color")
        self.assertEqual(colors.GetTuple(0), (255, 255, 255))
        self.assertEqual(colors.GetTuple(colors.GetNumberOfTuples() - 1), (200, 30, 7))
        names = reader.GetOutput().GetFieldData().GetAbstractArray("Names")
        self.assertEqual([names.GetValue(i) for i in range(2)], ["left lung", "heart/1"])

    def test_labels_on_a_given_grid(self):
        """The label image of a surface on an oblique grid has its volume, at its place; and
        back."""
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
                indices = numpy.argwhere(samples_of(image) == structure.label)[:, ::-1]
                places = indices @ steps.T + origin
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
        rows = ["x,y,z,contour"]
        rows += [f"{x!r},{y!r},{z!r},{number}" for number, loop in enumerate(loops)
                 for x, y, z in loop.tolist()]
        return self.write(name, "\n".join(rows))

    def test_three_views_of_one_object(self):
        stack = files.ball_stack()
        orders = (("x.csv", [2, 0, 1]), ("y.csv", [1, 2, 0]), ("z.csv", [0, 1, 2]))
        tables = [self.table(name, [loop[:, order] for loop in stack]) for name, order in orders]
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
        status, out, errors = self.run_script(self.path("in.mha"), self.path("out.nrrd"),
                                              "--slices", "12", "--set", "Smoothing=0.5")
        self.assertEqual((status, errors), (0, ""))
        (image, _), = LabelMaps.read_label_images(self.path("out.nrrd"))
        again = samples_of(image)
        common = numpy.sum((again == 2) & (samples == 2))
        self.assertGreater(2 * common / (numpy.sum(again == 2) + numpy.sum(samples == 2)), 0.95)
        self.assertEqual(set(numpy.unique(again)), {0, 2})

    def test_chosen_structures_and_grids(self):
        rows = ["structure,x,y,z"]
        rows += [f"{name},{x + 30 * place!r},{y!r},{z!r}"
                 for place, name in enumerate("abc") for loop in files.ball_stack()
                 for x, y, z in numpy.vstack((loop, loop[:1])).tolist()]
        table = self.write("abc.csv", "\n".join(rows))
        status, out, _ = self.run_script("--list", table)
        self.assertEqual((status, out.split()), (0, "1 a: 10 contours 2 b: 10 contours "
                                                    "3 c: 10 contours".split()))
        status, out, _ = self.run_script(table, self.path("c.nii.gz"), "--structure", "c",
                                         "--spacing", "1")
        self.assertEqual(status, 0)
        self.run_script(table, self.path("all.seg.nrrd"), "--spacing", "2", "--contours",
                        self.path("contours.vtp"))
        again = read_structures(self.path("contours.vtp"))
        self.assertEqual([(one.label, one.name, len(one.loops)) for one in again],
                         [(1, "a", 10), (2, "b", 10), (3, "c", 10)])
        numpy.testing.assert_array_equal(again[2].loops[4][:-1],
                                         files.ball_stack(center=(60, 0, 0))[4])
        (image, names), = LabelMaps.read_label_images(self.path("all.seg.nrrd"))
        self.assertEqual(names, {1: "a", 2: "b", 3: "c"})
        (image, _), = LabelMaps.read_label_images(self.path("c.nii.gz"))
        self.assertAlmostEqual(numpy.sum(samples_of(image) == 3) / BALL, 1.0, delta=0.02)
        status, _, errors = self.run_script(table, self.path("c.stl"), "--structure", "d")
        self.assertEqual((status, errors), (1, "There is no structure 'd', but a, b, c.\n"))

    def test_one_failure_does_not_keep_others_from_being_written(self):
        rows = ["structure,contour,x,y,z", "line,0,0,0,0", "line,0,1,0,0", "line,0,2,0,0"]
        rows += [f"ball,{number},{x!r},{y!r},{z!r}"
                 for number, loop in enumerate(files.ball_stack()) for x, y, z in loop.tolist()]
        table = self.write("two.csv", "\n".join(rows))
        status, out, errors = self.run_script(table, self.path("o.stl"))
        self.assertEqual(status, 1)
        self.assertRegex(out, "ball: 10 contours")
        self.assertRegex(errors, "^line: ")
        self.assertTrue(os.path.exists(self.path("o.stl")))

    def test_what_cannot_be_done_is_said_in_one_sentence(self):
        for arguments, sentence in (
                (("none.csv", "o.stl"), "There is no file none.csv.\n"),
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
