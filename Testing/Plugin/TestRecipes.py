# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestRecipes.py: what people have, as small files: the example scripts for it, and every
command of the page's section Your data."""

import contextlib
import glob
import gzip
import io
import json
import math
import os
import re
import shlex
import unittest
import zipfile

import numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import FormatFiles as files
from FormatChecks import HERE, OBLIQUE, FormatTest, loose_edges
from Formats import Surfaces
import CardiacVolumes
import CutMesh
import FenceSections
import ReconstructAny

PAGE = os.path.join(HERE, "..", "..", "Plugin", "README.md")


class RecipeTest(FormatTest):
    def run_main(self, script, *arguments):
        """What a script prints; it must not fail."""
        out, errors = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
            status = script.main([*arguments])
        self.assertEqual((status, errors.getvalue()), (0, ""))
        return out.getvalue()

    def read(self, name):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(self.path(name))
        reader.Update()
        return reader.GetOutput()

    def table(self, name, contours):
        """`contours`: structure and points (n x 3) of each."""
        rows = ["structure,contour,x,y,z"]
        rows += [f"{structure},{number},{x!r},{y!r},{z!r}"
                 for number, (structure, points) in enumerate(contours)
                 for x, y, z in points.tolist()]
        return self.write(name, "\n".join(rows))


class Scripts(RecipeTest):
    def test_help_is_what_is_asked_for(self):
        for script in (CardiacVolumes, CutMesh, FenceSections, ReconstructAny):
            for arguments, status in ((["--help"], 0), ([], script.__doc__)):
                out = io.StringIO()
                with self.assertRaises(SystemExit) as end, contextlib.redirect_stdout(out):
                    script.main(arguments)
                self.assertEqual(end.exception.code, status)
                self.assertEqual(script.__doc__ in out.getvalue(), not status)

    def test_cuts_through_a_mesh(self):
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(64)
        sphere.SetPhiResolution(64)
        sphere.Update()
        Surfaces.write(sphere.GetOutput(), self.path("model.stl"))
        out = self.run_main(CutMesh, self.path("model.stl"), self.path("out.vtp"),
                            "--slices", "6", "18")
        rows = [line.split() for line in out.splitlines()[1:]]
        self.assertEqual([row[0] for row in rows], ["6", "18"])
        self.assertEqual([row[2:4] for row in rows], [["1", "0"]] * 2)
        self.assertLess(float(rows[1][4]), 2e-3)
        self.assertGreater(float(rows[0][4]), float(rows[1][4]))
        self.assertEqual(self.read("out.vtp").GetNumberOfPolys(), int(rows[1][1]))
        stack = self.run_main(CutMesh, self.path("model.stl"), self.path("z.vtp"),
                              "--slices", "18", "--stack", "z").splitlines()[1].split()
        self.assertGreater(float(stack[4]), float(rows[1][4]))
        with contextlib.redirect_stderr(io.StringIO()) as errors:
            self.assertEqual(CutMesh.main(["mesh.step", "out.vtp"]), 1)
        self.assertIn("meshes are read from", errors.getvalue())

    def ventricle(self, width, length, base, long_axes):
        """Contours of a half ellipsoid that ends flat at the base, in a turned frame: short axes 8
        mm apart, and long-axis planes at some angles; and its volume in millilitres."""
        angles = numpy.linspace(0, 2 * math.pi, 72, endpoint=False)
        contours = []
        for height in numpy.arange(base - 4.0, -length, -8.0):
            radius = width * math.sqrt(1 - (height / length) ** 2)
            contours.append(numpy.stack((radius * numpy.cos(angles), radius * numpy.sin(angles),
                                         numpy.full(72, height)), axis=1))
        top = math.acos(base / length)
        for angle in numpy.radians(long_axes):
            turns = numpy.linspace(top, 2 * math.pi - top, 90)
            across, along = width * numpy.sin(turns), length * numpy.cos(turns)
            contours.append(numpy.stack((across * math.cos(angle), across * math.sin(angle), along),
                                        axis=1))
        volume = math.pi * width**2 * ((base - base**3 / (3 * length**2)) + 2 / 3 * length) / 1000
        return [loop @ OBLIQUE.T + (10.0, -40.0, 25.0) for loop in contours], volume

    def test_cardiac_volumes(self):
        for long_axes in ((), (0, 90), (10, 70)):
            volumes = []
            for phase, width, length in (("diastole", 25, 70), ("systole", 17, 62)):
                endo, inner = self.ventricle(width, length, 20.0, long_axes)
                epi, outer = self.ventricle(width + 9, length + 8, 20.0, long_axes)
                self.table(phase + ".csv", [("endo", loop) for loop in endo]
                           + [("epi", loop) for loop in epi])
                volumes.append((inner, outer))
            out = self.run_main(CardiacVolumes, self.path("diastole.csv"), self.path("systole.csv"),
                                "--out", self.path("out.vtp"))
            with self.subTest(long_axes=long_axes):
                (inner, outer), (inner2, outer2) = volumes
                found = [float(number) for number in re.findall(r"\d+\.\d", out)]
                # Endo and epi in both phases with their fractions, then the mass of the muscle.
                expected = [inner, inner2, 100 * (1 - inner2 / inner), outer, outer2,
                            100 * (1 - outer2 / outer), 1.05 * (outer - inner),
                            1.05 * (outer2 - inner2)]
                numpy.testing.assert_allclose(found, expected, rtol=0.03, atol=1.0)
                self.assertEqual(loose_edges(self.read("out.vtp")), 0)

    def test_fence_of_sections(self):
        size = numpy.array([2000.0, 1500.0, 60.0])
        angles = numpy.linspace(0, 2 * math.pi, 80, endpoint=False)
        contours = []
        for axis, spacing in ((0, 500.0), (1, 400.0)):
            for place in numpy.arange(-size[axis] + spacing / 2, size[axis], spacing):
                width = math.sqrt(1 - (place / size[axis]) ** 2)
                loop = numpy.zeros((80, 3))
                loop[:, axis] = place
                loop[:, 1 - axis] = size[1 - axis] * width * numpy.cos(angles)
                loop[:, 2] = -3000 + size[2] * width * numpy.sin(angles)
                contours.append(("lens", loop))
        table = self.table("sections.csv", contours)
        out = self.run_main(FenceSections, table, self.path("lens.vtp"), "--exaggerate", "8")
        volume, area = (float(re.search(name + r" ([\d.e+]+)", out).group(1))
                        for name in ("volume", "area"))
        self.assertAlmostEqual(volume / (4 / 3 * math.pi * size.prod()), 1.0, delta=0.02)
        self.assertAlmostEqual(area / (2 * math.pi * size[0] * size[1]), 1.0, delta=0.02)
        lens = self.read("lens.vtp")
        self.assertEqual(loose_edges(lens), 0)
        numpy.testing.assert_allclose(lens.GetBounds()[4:], (-3060, -2940), atol=6)


class Commands(RecipeTest):
    """The commands of the table, in a folder that has the files they name."""

    def setUp(self):
        super().setUp()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        os.symlink(os.path.join(HERE, "..", "..", "Data"), "Data")
        stack = files.ball_stack()
        far = files.ball_stack(center=(60, 0, 0))
        files.write_rtstruct("plan.dcm", [(number, name, None, [("CLOSED_PLANAR", loop)
                                                              for loop in loops])
                                         for number, (name, loops) in enumerate(
                                             (("Heart", stack), ("Lung left", far)), 1)])
        samples = files.ball_labels((24, 24, 24), (11, 12, 11), 8, 3)
        files.write_nii("labels.nii", samples, numpy.eye(3), numpy.zeros(3), "sform")
        with open("labels.nii", "rb") as plain, gzip.open("labels.nii.gz", "wb") as packed:
            packed.write(plain.read())
        self.write("organs.label", "# IDX -R- -G- -B- -A-- VIS MSH LABEL\n"
                   '    0     0    0    0        0  0  0    "Clear Label"\n'
                   '    3   200   30    7        1  1  1    "Left kidney"\n')
        files.write_nrrd("scan.seg.nrrd", samples, numpy.eye(3), numpy.zeros(3), keys=(
            "Segment0_ID:=Segment_1", "Segment0_Name:=Liver", "Segment0_LabelValue:=3",
            "Segment0_Layer:=0"))
        self.table("contours.csv", [("ball", loop) for loop in stack])
        for name, order in (("axial", [0, 1, 2]), ("sagittal", [2, 0, 1]), ("coronal", [1, 2, 0])):
            self.table(name + ".csv", [("ball", loop[:, order]) for loop in stack])
        with zipfile.ZipFile("RoiSet.zip", "w") as archive:
            for number, loop in enumerate(stack, 1):
                archive.writestr(f"{number:04}.roi",
                                 files.imagej_roi(loop[:, :2] * 5 + 60, number))
        for number, loop in enumerate(stack, 1):
            numpy.savetxt(f"cell_{number:02}.txt", loop[:, :2] * 5 + 60, fmt="%.3f", delimiter="\t")
            with open(f"curve_{number:02}.mrk.json", "w", encoding="utf-8") as markup:
                points = [{"position": point} for point in loop.tolist()]
                json.dump({"markups": [{"type": "ClosedCurve", "coordinateSystem": "LPS",
                                        "controlPoints": points}]}, markup)
        planes = [((0, 0, 1, -float(loop[0, 2])), loop) for loop in stack]
        files.write_csl("brain.csl", [(plane, [(1, "", loop)]) for plane, loop in planes])
        edges = [(k, (k + 1) % files.POINTS, 1, 0) for k in range(files.POINTS)]
        files.write_contour("brain.contour", [(plane, loop, edges) for plane, loop in planes])

    def commands(self):
        with open(PAGE, encoding="utf-8") as page:
            section = page.read().split("## Your data\n")[1].split("\n## ")[0]
        rows = "".join(line for line in section.splitlines(True) if line.startswith("| "))
        found = re.findall("`reconstruct ([^`]*)`", rows)
        self.assertGreater(len(found), 10)
        return found

    def test_every_command_makes_a_surface(self):
        for command in self.commands():
            words = shlex.split(command)
            words = [name for word in words for name in sorted(glob.glob(word)) or [word]]
            before = set(os.listdir())
            with self.subTest(command=command):
                out = self.run_main(ReconstructAny, *words)
                self.assertRegex(out, "contours, .*components 1, genus [01], ")
                written = out.split("Written: ")[1].strip().split(", ")
                self.assertEqual(len(out.splitlines()), len(written) + 1)
                self.assertTrue(all(os.path.getsize(name) > 1000 for name in written), written)
            for name in set(os.listdir()) - before:
                os.remove(name)


if __name__ == "__main__":
    unittest.main()
