# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Radiotherapy structure sets (DICOM RTSTRUCT): all structures with their names and colours.

The file is read with pydicom (Debian: python3-pydicom) or, where that is missing, with GDCM
(Debian: python3-gdcm). Neither of them depends on VTK, so that both go with VTK's Python and with
ParaView's.
"""

import numpy

from .Structures import FormatError, Structure

MODALITY = (0x0008, 0x0060)
STRUCTURE_SET_ROIS = (0x3006, 0x0020)
ROI_NUMBER = (0x3006, 0x0022)
ROI_NAME = (0x3006, 0x0026)
DISPLAY_COLOR = (0x3006, 0x002A)
ROI_CONTOURS = (0x3006, 0x0039)
CONTOURS = (0x3006, 0x0040)
GEOMETRIC_TYPE = (0x3006, 0x0042)
CONTOUR_DATA = (0x3006, 0x0050)
REFERENCED_ROI = (0x3006, 0x0084)

# Marks and reference points bound nothing.
CLOSED_TYPES = ("CLOSED_PLANAR", "CLOSEDPLANAR_XOR")
OPEN_TYPES = ("OPEN_PLANAR",)


class PydicomAccess:
    """Elements of a DICOM data set by their tags, read with pydicom."""

    def __init__(self):
        import pydicom
        self.library = pydicom

    def read(self, path):
        return self.library.dcmread(path, force=True) # also without the preamble of a file

    def items(self, dataset, tag):
        return list(dataset[tag].value or ()) if tag in dataset else []

    def text(self, dataset, tag):
        value = dataset[tag].value if tag in dataset else None
        if value is None:
            return ""
        several = not isinstance(value, str) and hasattr(value, "__iter__")
        return "\\".join(map(str, value)) if several else str(value)


class GdcmAccess:
    """The same with GDCM."""

    def __init__(self):
        import gdcm
        self.library = gdcm
        self.kept = [] # readers and sequences own the data sets that they give away

    def read(self, path):
        reader = self.library.Reader()
        self.kept.append(reader)
        reader.SetFileName(path)
        if not reader.Read():
            raise FormatError(f"{path} is no DICOM file that GDCM can read.")
        return reader.GetFile().GetDataSet()

    def items(self, dataset, tag):
        tag = self.library.Tag(*tag)
        if not dataset.FindDataElement(tag):
            return []
        sequence = dataset.GetDataElement(tag).GetValueAsSQ()
        self.kept.append(sequence)
        return [sequence.GetItem(i + 1).GetNestedDataSet()
                for i in range(sequence.GetNumberOfItems())]

    def text(self, dataset, tag):
        tag = self.library.Tag(*tag)
        if not dataset.FindDataElement(tag):
            return ""
        value = dataset.GetDataElement(tag).GetByteValue()
        return value.GetBuffer().strip("\0 ") if value else ""


def find_access(kinds=(PydicomAccess, GdcmAccess)):
    for kind in kinds:
        try:
            return kind()
        except ImportError:
            continue
    raise FormatError("DICOM files are read with pydicom or GDCM, and Python has neither: "
                      "apt-get install python3-pydicom.")


def read_rtstruct(path, access=None):
    """All structures of an RTSTRUCT file that have contours. Label: the number of the ROI."""
    access = access or find_access()
    dataset = access.read(path)
    modality = access.text(dataset, MODALITY)
    if modality != "RTSTRUCT":
        raise FormatError(f"{path} is no structure set (RTSTRUCT): its modality is {modality!r}.")
    names = {access.text(item, ROI_NUMBER): access.text(item, ROI_NAME)
             for item in access.items(dataset, STRUCTURE_SET_ROIS)}
    structures = []
    for item in access.items(dataset, ROI_CONTOURS):
        number = access.text(item, REFERENCED_ROI)
        structure = Structure(names.get(number) or f"ROI {number}", int(number),
                              color_of(access.text(item, DISPLAY_COLOR)))
        for contour in access.items(item, CONTOURS):
            add_contour(access, contour, structure)
        if structure.loops:
            structures.append(structure)
    return structures


def color_of(text):
    values = text.split("\\")
    return tuple(int(float(value)) for value in values) if len(values) == 3 else None


def add_contour(access, contour, structure):
    kind = access.text(contour, GEOMETRIC_TYPE)
    if kind not in CLOSED_TYPES + OPEN_TYPES:
        return
    values = access.text(contour, CONTOUR_DATA).split("\\")
    numbers = [float(value) for value in values if value.strip()]
    if len(numbers) % 3 != 0:
        raise FormatError(f"A contour of {structure.name!r} has {len(numbers)} numbers, not three "
                          "for each point.")
    structure.add(numpy.reshape(numbers, (-1, 3)), closed=kind in CLOSED_TYPES)
