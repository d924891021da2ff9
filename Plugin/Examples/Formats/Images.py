# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Images that lie where they belong in the world, and their samples as arrays of numpy."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonMath import vtkMatrix3x3

from .Structures import FormatError


def make_image(samples, steps, origin):
    """An image of samples [k, j, i]; the columns of `steps` lead from sample to sample in i, j, k."""
    spacing = numpy.linalg.norm(steps, axis=0)
    if abs(numpy.linalg.det(steps)) <= 1e-9 * spacing.prod():
        raise FormatError("The directions of the image's axes lie in one plane.")
    image = vtkImageData()
    image.SetDimensions(*samples.shape[::-1])
    image.SetSpacing(*spacing)
    image.SetOrigin(*origin)
    set_direction(image, steps / spacing)
    scalars = numpy_to_vtk(numpy.ascontiguousarray(samples).ravel(), deep=True)
    scalars.SetName("Label")
    image.GetPointData().SetScalars(scalars)
    return image


def set_direction(image, columns):
    matrix = vtkMatrix3x3()
    matrix.DeepCopy(numpy.ravel(columns).tolist())
    image.SetDirectionMatrix(matrix)


def samples_of(image):
    """The scalars as an array [k, j, i]."""
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])


def steps_of(image):
    """A matrix whose columns lead from one sample to the next in i, j and k."""
    matrix = image.GetDirectionMatrix()
    direction = [[matrix.GetElement(i, j) for j in range(3)] for i in range(3)]
    return numpy.array(direction) * image.GetSpacing()


def first_sample(image):
    """The place of the sample with the lowest indices."""
    return numpy.array(image.GetPoint(0))
