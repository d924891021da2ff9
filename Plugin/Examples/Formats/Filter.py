# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters of this project, called from Python: contours in, closed surfaces out.

The package orthogonalslices is found on Python's path or in the build folders of the repository
that this file lies in. It goes with the Python of plain VTK, with Debian's python3-paraview and
with pvpython, whichever it was built with.
"""

import importlib
import math
import os
import sys

import numpy
import vtkmodules
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth

from .Images import first_sample, make_image, samples_of, steps_of
from .Structures import FormatError, Structure, run

# Scans have thousands of values, the finest atlases some hundred labels.
MOST_LABELS = 1000

# Inputs of vtkOrthogonalSliceReconstruction: x-, y- and z-slices, and contours on any planes.
SLICES_PORTS = (0, 1, 2)
CONTOURS_PORT = 3

MODULE = "orthogonalslices.vtkFiltersOrthogonalSlices"
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
PARAVIEW_BUILDS = ("build/paraview", "build/demo/paraview")
VTK_BUILDS = ("build/vtk",)


def load_filters():
    """The module with the wrapped classes, of a build with the same VTK that Python has."""
    try:
        return importlib.import_module(MODULE)
    except ImportError:
        pass
    # Beside ParaView's VTK lies ParaView.
    modules = os.path.dirname(os.path.abspath(vtkmodules.__file__))
    is_paraview = os.path.isdir(os.path.join(os.path.dirname(modules), "paraview"))
    for build in PARAVIEW_BUILDS if is_paraview else VTK_BUILDS:
        place = os.path.join(ROOT, build, "lib", "python3", "dist-packages")
        sys.path.insert(0, place)
        sys.modules.pop("orthogonalslices", None)
        try:
            return importlib.import_module(MODULE)
        except ImportError:
            sys.path.remove(place)
    raise FormatError("Python finds no package orthogonalslices that goes with its VTK: put "
                      "lib/python3/dist-packages of the build folder into PYTHONPATH.")


def load_package():
    """The package orthogonalslices, whose function reconstruct() has the tables, too."""
    load_filters()
    return importlib.import_module("orthogonalslices")


def reconstruct(structure, properties=None):
    """The closed surface of one structure. `properties`: names of vtkOrthogonalSliceReconstruction
    without "Set", and their values."""
    filters = load_filters()
    reconstruction = filters.vtkOrthogonalSliceReconstruction()
    contours = structure.contours()
    for port, piece in zip((CONTOURS_PORT,) if len(contours) == 1 else SLICES_PORTS, contours):
        reconstruction.SetInputData(port, piece)
    for name, value in (properties or {}).items():
        setter = getattr(reconstruction, "Set" + name, None)
        if setter is None:
            raise FormatError(f"The filter has no property {name}.")
        setter(value)
    run(reconstruction)
    surface = vtkPolyData()
    surface.ShallowCopy(reconstruction.GetOutput())
    if surface.GetNumberOfPolys() == 0:
        raise FormatError("The surface is empty.")
    return surface


def structures_of_image(image, names, slices, blur=0.0):
    """A structure for each label of an image, with contours on at most `slices` planes of its
    samples along each axis of the image; `blur` as in slices_of_label."""
    samples = samples_of(image)
    labels = numpy.unique(samples)
    if not numpy.array_equal(labels, labels.astype(numpy.int64)):
        raise FormatError("The image has values that are no whole numbers: it is no label image.")
    if len(labels) > MOST_LABELS:
        raise FormatError(f"The image has {len(labels)} values: it seems to be a scan, not its "
                          "labels.")
    return [Structure(names.get(int(label), f"label {int(label)}"), int(label),
                      slices=slices_of_label(image, label, slices, blur))
            for label in labels if label > 0]


def slices_of_label(image, label, slices, blur=0.0):
    """Contours around the samples with one label, on x-, y- and z-slices or on those of the image.

    They run halfway between the samples inside and outside, in steps. With `blur`, the samples are
    spread by a Gaussian of so many samples first, and the contours run where half of them are
    inside: that takes the steps out, and with them what is thinner than about twice `blur`."""
    part = part_of_label(image, label, margin=math.ceil(3 * blur))
    slicer = load_filters().vtkOrthogonalSlicer()
    slicer.SetInputData(blurred(part, blur) if blur > 0 else part)
    slicer.SetIsoValue(0.5)
    slicer.SetNumberOfSlices(slices, slices, slices)
    run(slicer)
    contours = [vtkPolyData() for _ in range(3)]
    for axis, data in enumerate(contours):
        data.ShallowCopy(slicer.GetOutput(axis))
    return contours


def part_of_label(image, label, margin):
    """The part of an image around one label, whose samples are 1, with zeros around it."""
    inside = samples_of(image) == label
    box = []
    for axis in range(3):
        others = tuple(other for other in range(3) if other != axis)
        filled = numpy.flatnonzero(inside.any(axis=others))
        box.append(slice(filled[0], filled[-1] + 1))
    lowest = numpy.array([part.start - margin for part in reversed(box)])
    steps = steps_of(image)
    samples = numpy.pad(inside[tuple(box)].astype(numpy.float32), margin)
    return make_image(samples, steps, first_sample(image) + steps @ lowest)


def blurred(image, deviation):
    """An image with its samples spread by a Gaussian of so many samples."""
    gauss = vtkImageGaussianSmooth()
    gauss.SetInputData(image)
    gauss.SetStandardDeviations(deviation, deviation, deviation)
    gauss.SetRadiusFactors(3, 3, 3)
    gauss.Update()
    return make_image(samples_of(gauss.GetOutput()), steps_of(image), first_sample(image))
