# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Small files in the formats that are read, written here byte by byte as their specifications say,
and not by what is tested."""

import gzip
import math
import struct

import numpy

POINTS = 48


def circle(radius, z, center=(0.0, 0.0), points=POINTS):
    angles = 2 * math.pi / points * numpy.arange(points)
    return numpy.column_stack((center[0] + radius * numpy.cos(angles),
                               center[1] + radius * numpy.sin(angles), numpy.full(points, z)))


def ball_stack(radius=10.0, spacing=2.0, center=(0.0, 0.0, 0.0)):
    """Circles on z-slices of a ball: half a spacing from its poles, and `spacing` apart."""
    count = int(2 * radius / spacing)
    heights = [-radius + (i + 0.5) * spacing for i in range(count)]
    return [circle(math.sqrt(radius**2 - h**2), center[2] + h, center) for h in heights]


# --------------------------------------------------------------------------------------------------
# DICOM

def write_rtstruct(path, structures, modality="RTSTRUCT", implicit=False):
    """`structures`: number, name, colour, and contours as pairs of a geometric type and points.
    `implicit`: without the types of the elements, as some programs write."""
    from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
    from pydicom.sequence import Sequence
    from pydicom.uid import ExplicitVRLittleEndian, ImplicitVRLittleEndian, generate_uid

    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.481.3"
    meta.MediaStorageSOPInstanceUID = generate_uid()
    meta.TransferSyntaxUID = ImplicitVRLittleEndian if implicit else ExplicitVRLittleEndian
    file = FileDataset(path, {}, file_meta=meta, preamble=b"\0" * 128)
    file.is_little_endian, file.is_implicit_VR = True, implicit
    file.SOPClassUID = meta.MediaStorageSOPClassUID
    file.SOPInstanceUID = meta.MediaStorageSOPInstanceUID
    file.Modality = modality
    rois, contours = [], []
    for number, name, color, loops in structures:
        roi = Dataset()
        roi.ROINumber, roi.ROIName = number, name
        rois.append(roi)
        item = Dataset()
        item.ReferencedROINumber = number
        if color:
            item.ROIDisplayColor = list(color)
        items = []
        for kind, points in loops:
            contour = Dataset()
            contour.ContourGeometricType = kind
            contour.NumberOfContourPoints = len(points)
            contour.ContourData = [f"{value:.2f}" for value in numpy.ravel(points)]
            items.append(contour)
        if items:
            item.ContourSequence = Sequence(items)
        contours.append(item)
    file.StructureSetROISequence = Sequence(rois)
    file.ROIContourSequence = Sequence(contours)
    file.save_as(path, write_like_original=False)


# --------------------------------------------------------------------------------------------------
# Label images: samples [k, j, i], the steps in i, j and k as columns, the place of the first sample

def ball_labels(shape, center, radius, label=1):
    """Labels of a ball; all in samples."""
    places = numpy.indices(shape)[::-1] # i, j, k
    squares = sum((places[axis] - center[axis]) ** 2 for axis in range(3))
    return (label * (squares <= radius**2)).astype(numpy.uint8)


def vector(numbers):
    return "(" + ",".join(f"{number:.17g}" for number in numbers) + ")"


def write_nrrd(path, samples, steps, origin, space="left-posterior-superior", encoding="gzip",
               keys=()):
    """With four axes, the first of the file counts the layers of a segmentation."""
    directions = " ".join(vector(steps[:, axis]) for axis in range(3))
    layers = samples.ndim == 4
    body = numpy.moveaxis(samples, 0, -1) if layers else samples
    lines = ["NRRD0004", "# made for a test", "type: unsigned char", f"dimension: {samples.ndim}",
             f"space: {space}", "sizes: " + " ".join(map(str, body.shape[::-1])),
             "space directions: " + ("none " if layers else "") + directions,
             "kinds: " + ("list " if layers else "") + "domain domain domain",
             f"encoding: {encoding}", f"space origin: {vector(origin)}", *keys, "", ""]
    data = body.tobytes()
    if encoding == "gzip":
        data = gzip.compress(data)
    elif encoding == "text":
        data = " ".join(map(str, body.ravel())).encode()
    with open(path, "wb") as file:
        file.write("\n".join(lines).encode() + data)


def write_mha(path, samples, steps, origin):
    spacing = numpy.linalg.norm(steps, axis=0)
    direction = " ".join(f"{value:.17g}" for value in (steps / spacing).T.ravel())

    def text(numbers):
        return " ".join(f"{number:.17g}" for number in numbers)

    lines = ["ObjectType = Image", "NDims = 3", "BinaryData = True",
             "BinaryDataByteOrderMSB = False", "CompressedData = False",
             f"TransformMatrix = {direction}", f"Offset = {text(origin)}",
             "CenterOfRotation = 0 0 0", "AnatomicalOrientation = RAI",
             f"ElementSpacing = {text(spacing)}",
             "DimSize = " + " ".join(map(str, samples.shape[::-1])),
             "ElementType = MET_UCHAR", "ElementDataFile = LOCAL", ""]
    with open(path, "wb") as file:
        file.write("\n".join(lines).encode() + samples.tobytes())


def write_nii(path, samples, steps, origin, form):
    """NIfTI-1 with the same placement as sform or as qform ("sform", "qform"); LPS in, RAS in the
    file."""
    flip = numpy.diag([-1.0, -1.0, 1.0])
    steps, origin = flip @ steps, flip @ origin
    spacing = numpy.linalg.norm(steps, axis=0)
    header = bytearray(348)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *samples.shape[::-1], 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 2, 8) # unsigned char
    rotation = steps / spacing
    qfac = -1.0 if numpy.linalg.det(rotation) < 0 else 1.0
    struct.pack_into("<8f", header, 76, qfac, *spacing, 1, 1, 1, 1)
    struct.pack_into("<f", header, 108, 352)
    struct.pack_into("<b", header, 123, 2) # mm
    if form == "sform":
        struct.pack_into("<h", header, 254, 1)
        for row in range(3):
            struct.pack_into("<4f", header, 280 + 16 * row, *steps[row], origin[row])
    else:
        struct.pack_into("<h", header, 252, 1)
        b, c, d = quaternion(rotation * (1, 1, qfac))
        struct.pack_into("<6f", header, 256, b, c, d, *origin)
    header[344:348] = b"n+1\0"
    with open(path, "wb") as file:
        file.write(bytes(header) + b"\0" * 4 + samples.tobytes())


def quaternion(rotation):
    """b, c and d of the unit quaternion a + bi + cj + dk, with a >= 0, of a rotation: the
    eigenvector of the largest eigenvalue of Bar-Itzhack's matrix."""
    m = rotation
    lower = numpy.array([
        [m[0, 0] - m[1, 1] - m[2, 2], 0, 0, 0],
        [m[0, 1] + m[1, 0], m[1, 1] - m[0, 0] - m[2, 2], 0, 0],
        [m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], m[2, 2] - m[0, 0] - m[1, 1], 0],
        [m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], numpy.trace(m)]])
    b, c, d, a = numpy.linalg.eigh(lower, "L")[1][:, -1]
    return (b, c, d) if a >= 0 else (-b, -c, -d)


# --------------------------------------------------------------------------------------------------
# Cross-sections

def write_csl(path, planes):
    """`planes`: parameters and components, each a label, what follows the count ("" or "h0"),
    points."""
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"CSLC\n{len(planes)} 3\n\n")
        for number, (plane, components) in enumerate(planes, 1):
            points = numpy.vstack([loop for _, _, loop in components])
            file.write(f"{number} {len(points)} {len(components)} {' '.join(map(str, plane))}\n\n")
            file.write("".join(f"{x:.10f} {y:.10f} {z:.10f}\n" for x, y, z in points) + "\n")
            first = 0
            for label, hole, loop in components:
                indices = " ".join(str(first + i) for i in range(len(loop)))
                file.write(f"{len(loop)}{hole} {label} {indices}\n")
                first += len(loop)
            file.write("\n")


def write_contour(path, planes):
    """`planes`: parameters, points and edges (start, end, left, right)."""
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"{len(planes)}\n")
        for plane, points, edges in planes:
            file.write(" ".join(map(str, plane)) + f"\n{len(points)} {len(edges)}\n")
            file.write("".join(f"{x:.10f} {y:.10f} {z:.10f}\n" for x, y, z in points))
            file.write("".join(f"{a} {b} {left} {right}\n" for a, b, left, right in edges))


# --------------------------------------------------------------------------------------------------
# ImageJ

def imagej_roi(points, position, kind=7, sub_pixel=True):
    """The bytes of a selection on slice `position`: a second header has it as z position."""
    points = numpy.asarray(points, dtype=float)
    low = numpy.floor(points.min(axis=0)).astype(int)
    high = numpy.ceil(points.max(axis=0)).astype(int)
    data = bytearray(64)
    data[:4] = b"Iout"
    struct.pack_into(">h", data, 4, 228)
    data[6] = kind
    struct.pack_into(">4hH", data, 8, low[1], low[0], high[1], high[0], len(points))
    struct.pack_into(">H", data, 50, 128 if sub_pixel else 0)
    data += (numpy.round(points) - low).T.astype(">i2").tobytes()
    if sub_pixel:
        data += points.T.astype(">f4").tobytes()
    struct.pack_into(">i", data, 60, len(data))
    second = bytearray(64)
    struct.pack_into(">i", second, 8, position)
    return bytes(data + second)
