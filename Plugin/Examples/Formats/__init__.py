# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Readers of contours and label images in the formats that people have, and writers of results.

    from Formats import read_structures
    from Formats.Filter import reconstruct
    for structure in read_structures("plan.dcm"):
        surface = reconstruct(structure)

A file is recognized by its ending, DICOM also by its content. Needs numpy and VTK's Python modules,
those of ParaView included; DICOM needs pydicom or GDCM.
"""

import os
import struct
import zipfile

from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from . import CrossSections, Dicom, ImageJ, LabelMaps, Markups, Tables
from .Structures import FormatError, Structure, loops_of, run

TABLES = (".csv", ".tsv", ".txt", ".xyz")


def read_structures(path, voxel=(1.0, 1.0, 1.0), slices=64, blur=0.0):
    """The structures of a file. `voxel`: the distance of samples along x, y and z, where a format
    counts pixels and slices. `slices`: label images are cut on at most so many planes of their
    samples along each of their axes; `blur`: after a Gaussian of so many samples took their steps
    out."""
    if not os.path.isfile(path):
        raise FormatError(f"There is no file {path}.")
    try:
        return read_by_ending(path, voxel, slices, blur)
    except (OSError, EOFError, ValueError, LookupError, struct.error, zipfile.BadZipFile) as error:
        raise FormatError(f"{path} is damaged, or not what its ending says: {error}.") from error


def read_by_ending(path, voxel, slices, blur):
    name = path.lower()
    if name.endswith(".mrk.json"):
        return Markups.read_markups(path)
    if LabelMaps.ending(path):
        return read_labels(path, slices, blur)
    end = os.path.splitext(name)[1]
    if end in TABLES:
        return Tables.read_table(path, voxel)
    if end in (".roi", ".zip"):
        return ImageJ.read_imagej(path, voxel)
    readers = {".contour": CrossSections.read_contour, ".csl": CrossSections.read_csl,
               ".fcsv": Markups.read_fcsv, ".vtp": read_vtk, ".vtk": read_vtk}
    if end in readers:
        return readers[end](path)
    if end in (".dcm", ".dicom") or is_dicom(path):
        return Dicom.read_rtstruct(path)
    raise FormatError(f"{path} is of no format that is read here.")


def is_dicom(path):
    with open(path, "rb") as file:
        return file.read(132)[128:] == b"DICM"


def read_labels(path, slices, blur):
    from .Filter import structures_of_image
    return [structure for image, names in LabelMaps.read_label_images(path)
            for structure in structures_of_image(image, names, slices, blur)]


def read_vtk(path):
    """Lines and polygons; with a cell array Label, a structure for each of its values."""
    reader = vtkXMLPolyDataReader() if path.lower().endswith(".vtp") else vtkPolyDataReader()
    reader.SetFileName(path)
    run(reader)
    data = reader.GetOutput()
    loops = loops_of(data)
    if not loops:
        raise FormatError(f"{path} has no lines or polygons.")
    labels = data.GetCellData().GetArray("Label")
    if labels is None:
        return [Structure("contours", loops=loops)]
    names = names_of(data.GetFieldData())
    structures = {}
    # Cells of a vtkPolyData count vertices first, then lines, then polygons.
    for cell, loop in enumerate(loops, data.GetNumberOfVerts()):
        label = int(labels.GetTuple1(cell))
        structures.setdefault(label, Structure(names.get(label, f"label {label}"),
                                               label)).loops.append(loop)
    return [structures[label] for label in sorted(structures)]


def names_of(fields):
    """Field data Labels and Names, as Surfaces writes them: {label: name}."""
    labels, names = fields.GetArray("Labels"), fields.GetAbstractArray("Names")
    if labels is None or names is None:
        return {}
    return {int(labels.GetTuple1(i)): str(names.GetValue(i))
            for i in range(min(labels.GetNumberOfTuples(), names.GetNumberOfValues()))}
