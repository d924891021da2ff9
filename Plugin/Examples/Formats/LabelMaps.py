# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Label images: NRRD, MetaImage, NIfTI and .vti, with their direction matrices, read and written.

An image is a vtkImageData whose scalars are labels, 0 for outside. It lies where it belongs in the
world: LPS (DICOM's frame) in millimetres. NIfTI and NRRD in other frames are turned into that. VTK
reads the samples of NIfTI and MetaImage; their directions are read here.
"""

import os

import numpy
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkIOImage import (
    vtkMetaImageReader,
    vtkNIFTIImageHeader,
    vtkNIFTIImageReader,
    vtkNIFTIImageWriter,
)
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter

from .Images import first_sample, make_image, samples_of, steps_of
from .Nrrd import read_nrrd, write_nrrd
from .Structures import FormatError, run

ENDINGS = (".nrrd", ".nhdr", ".mha", ".mhd", ".nii", ".nii.gz", ".vti")
WRITTEN = (".nrrd", ".mha", ".nii", ".nii.gz", ".vti")

RAS_TO_LPS = numpy.diag([-1.0, -1.0, 1.0])


def ending(path):
    name = os.path.basename(path).lower()
    return next((end for end in sorted(ENDINGS, key=len, reverse=True) if name.endswith(end)), "")


def read_label_images(path):
    """Pairs of an image and the names of its labels ({label: name}); several if it has layers."""
    end = ending(path)
    if end in (".nrrd", ".nhdr"):
        return read_nrrd(path)
    if end in (".mha", ".mhd"):
        return [(read_meta_image(path), {})]
    if end in (".nii", ".nii.gz"):
        return [(read_nifti(path), {})]
    reader = vtkXMLImageDataReader()
    reader.SetFileName(path)
    run(reader)
    image = reader.GetOutput()
    if image.GetPointData().GetScalars() is None:
        if image.GetPointData().GetNumberOfArrays() == 0:
            raise FormatError(f"{path} has no labels on its points.")
        image.GetPointData().SetActiveScalars(image.GetPointData().GetArrayName(0))
    return [(image, {})]


# --------------------------------------------------------------------------------------------------
# MetaImage

def read_meta_image(path):
    """A TransformMatrix is written column by column: each is the direction of an axis."""
    fields = {}
    with open(path, "rb") as file:
        for line in file:
            key, _, value = line.decode("latin-1").partition("=")
            fields[key.strip()] = value.strip()
            if key.strip() == "ElementDataFile":
                break
    if fields.get("NDims") != "3":
        raise FormatError(f"{path} has {fields.get('NDims', 'no')} dimensions, not three.")

    def numbers(names, default):
        text = next((fields[name] for name in names if name in fields), default)
        return numpy.array([float(number) for number in text.split()])

    reader = vtkMetaImageReader()
    reader.SetFileName(path)
    run(reader)
    columns = numbers(("TransformMatrix", "Rotation", "Orientation"), "1 0 0 0 1 0 0 0 1")
    spacing = numbers(("ElementSpacing", "ElementSize"), "1 1 1")
    origin = numbers(("Offset", "Origin", "Position"), "0 0 0")
    return make_image(samples_of(reader.GetOutput()), columns.reshape(3, 3).T * spacing, origin)


def write_meta_image(image, path):
    samples = samples_of(image)
    types = {"i1": "CHAR", "u1": "UCHAR", "i2": "SHORT", "u2": "USHORT", "i4": "INT", "u4": "UINT"}

    def text(numbers):
        return " ".join(repr(float(number)) for number in numbers)

    steps = steps_of(image)
    spacing = numpy.linalg.norm(steps, axis=0)
    header = ["ObjectType = Image", "NDims = 3", "BinaryData = True",
              "BinaryDataByteOrderMSB = False", "CompressedData = False",
              f"TransformMatrix = {text((steps / spacing).T.ravel())}",
              f"Offset = {text(first_sample(image))}", "CenterOfRotation = 0 0 0",
              f"ElementSpacing = {text(spacing)}",
              "DimSize = " + " ".join(map(str, image.GetDimensions())),
              f"ElementType = MET_{types[samples.dtype.str[1:]]}", "ElementDataFile = LOCAL", ""]
    with open(path, "wb") as file:
        file.write("\n".join(header).encode())
        file.write(samples.astype(samples.dtype.newbyteorder("<")).tobytes())


# --------------------------------------------------------------------------------------------------
# NIfTI

def read_nifti(path):
    """The sform is used if there is one, as most programs do, else the qform."""
    reader = vtkNIFTIImageReader()
    reader.SetFileName(path)
    run(reader)
    image = reader.GetOutput()
    matrix = reader.GetSFormMatrix() or reader.GetQFormMatrix()
    to_world = numpy.eye(4)
    if matrix:
        to_world = numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    # From VTK's image, whose first sample lies at 0, to right, anterior, superior.
    steps = RAS_TO_LPS @ to_world[:3, :3] * image.GetSpacing()
    return make_image(samples_of(image), steps, RAS_TO_LPS @ to_world[:3, 3])


def write_nifti(image, path):
    """sform and qform are the same; a qform cannot be left-handed: then its slices are reversed."""
    steps = RAS_TO_LPS @ steps_of(image)
    spacing = numpy.linalg.norm(steps, axis=0)
    matrix = vtkMatrix4x4()
    origin = RAS_TO_LPS @ first_sample(image)
    samples = samples_of(image)
    if numpy.linalg.det(steps) < 0:
        origin = origin + (samples.shape[0] - 1) * steps[:, 2]
        steps = steps * (1, 1, -1)
        samples = samples[::-1]
    for i in range(3):
        for j in range(3):
            matrix.SetElement(i, j, steps[i, j] / spacing[j])
        matrix.SetElement(i, 3, origin[i])
    header = vtkNIFTIImageHeader()
    header.SetQFormCode(1)
    header.SetSFormCode(1)
    writer = vtkNIFTIImageWriter()
    writer.SetNIFTIHeader(header)
    writer.SetQFormMatrix(matrix)
    writer.SetSFormMatrix(matrix)
    writer.SetInputData(make_image(samples, numpy.diag(spacing), (0, 0, 0)))
    writer.SetFileName(path)
    writer.Write()


def write_label_image(image, path, names=None):
    """The ending says how; a NRRD has the names of the labels ({label: name}), too."""
    end = ending(path)
    if end == ".nrrd":
        write_nrrd(image, path, names)
    elif end == ".mha":
        write_meta_image(image, path)
    elif end in (".nii", ".nii.gz"):
        write_nifti(image, path)
    elif end == ".vti":
        writer = vtkXMLImageDataWriter()
        writer.SetFileName(path)
        writer.SetInputData(image)
        writer.SetDataModeToBinary()
        writer.Write()
    else:
        raise FormatError(f"{path}: label images are written as {', '.join(WRITTEN)}.")
