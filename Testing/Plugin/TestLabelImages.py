# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestLabelImages.py: label images with their directions, read and written."""

import math
import os
import unittest

import numpy

import FormatFiles as files
from FormatChecks import BALL, OBLIQUE, ORIGIN, PERMUTED, SPACING
from FormatChecks import FormatTest, loose_edges, points_of, volume_of
from Formats import LabelMaps, read_structures
from Formats.Filter import reconstruct
from Formats.LabelNames import name_structures, read_label_names
from Formats.Images import first_sample, make_image, samples_of, steps_of
from Formats.Structures import FormatError

# An inclined gantry: slices that are not perpendicular to the table's axis, by 15 degrees.
INCLINED = numpy.array([[1, 0, 0], [0, 1, math.sin(math.pi / 12)], [0, 0, math.cos(math.pi / 12)]])


def centroid(points):
    points = numpy.asarray(points)
    return (points.max(axis=0) + points.min(axis=0)) / 2


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
                    form = "sform" if "-s" in ending else "qform"
                    files.write_nii(path, samples, steps, ORIGIN, form)
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
                points = points_of(ball)
                distances = numpy.linalg.norm(points - self.center(steps), axis=1)
                self.assertLess(abs(distances - 8.0).max(), 0.75)
                self.assertAlmostEqual(distances.mean(), 8.0, delta=0.15)

    def test_surfaces_lie_in_the_world(self):
        for name, axes in (("permuted", PERMUTED), ("oblique", OBLIQUE), ("inclined", INCLINED)):
            with self.subTest(axes=name):
                steps = axes * SPACING
                files.write_mha(self.path("ball.mha"), self.samples(steps), steps, ORIGIN)
                ball, box = read_structures(self.path("ball.mha"))
                surface = reconstruct(ball)
                self.assertEqual(loose_edges(surface), 0)
                self.assertAlmostEqual(volume_of(surface), 4 / 3 * math.pi * 8**3, delta=0.03 * BALL)
                numpy.testing.assert_allclose(surface.GetCenter(), self.center(steps), atol=0.4)
                cells = 4 * 4 * 6 * abs(numpy.linalg.det(steps))
                self.assertAlmostEqual(volume_of(reconstruct(box)) / cells, 1.0, delta=0.1)

    def test_blur_takes_the_steps_out(self):
        for axes in (PERMUTED, OBLIQUE):
            steps = axes * SPACING
            path = self.path("ball.nrrd")
            files.write_nrrd(path, self.samples(steps), steps, ORIGIN)
            deviations = []
            for blur in (0.0, 0.7):
                ball, _ = read_structures(path, blur=blur)
                points = points_of(ball)
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
        self.assertEqual([one.name for one in structures], ["left lung", "heart", "node"])
        for structure, i in zip(structures, (10, 14)):
            center = centroid(points_of(structure))
            numpy.testing.assert_allclose(center, ORIGIN + (i, 12, 10), atol=1e-3)

    def test_names_and_colors_of_labels(self):
        samples = files.ball_labels((20, 20, 20), (9, 10, 9), 6, 3)
        files.write_mha(self.path("labels.mha"), samples, numpy.eye(3), numpy.zeros(3))
        structure, = read_structures(self.path("labels.mha"))
        self.assertEqual((structure.name, structure.color), ("label 3", None))
        snap = self.write("labels.txt", "#####\n# ITK-SnAP Label Description File\n"
                          '    0     0    0    0        0  0  0    "Clear Label"\n'
                          '    3   200   30    7      0.5  1  1    "Left kidney, upper pole"\n')
        slicer = self.write("labels.ctbl", "# Color table\n0 Background 0 0 0 0\n"
                            "3 left_kidney 200 30 7 255\n")
        for path, name in ((snap, "Left kidney, upper pole"), (slicer, "left kidney")):
            name_structures([structure], read_label_names(path))
            self.assertEqual((structure.name, structure.color), (name, (200, 30, 7)))
        wrong = self.write("wrong.txt", "3 kidney\n")
        with self.assertRaisesRegex(FormatError, "line 1: no label"):
            read_label_names(wrong)

    def test_images_that_are_no_label_images_are_refused(self):
        path = self.path("flat.nrrd")
        files.write_nrrd(path, self.samples(numpy.eye(3)), numpy.diag([1.0, 1.0, 0.0]), ORIGIN)
        with self.assertRaisesRegex(FormatError, "lie in one plane"):
            read_structures(path)
        scan = numpy.arange(11 * 11 * 11, dtype=numpy.int16).reshape(11, 11, 11)
        LabelMaps.write_label_image(make_image(scan, numpy.eye(3), ORIGIN), path)
        with self.assertRaisesRegex(FormatError, "seems to be a scan"):
            read_structures(path)
        with open(path, "wb") as file:
            file.write(b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: 9 9 9\nencoding: raw\n\n123")
        with self.assertRaisesRegex(FormatError, "fewer samples"):
            read_structures(path)


if __name__ == "__main__":
    unittest.main()
