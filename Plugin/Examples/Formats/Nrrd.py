# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""NRRD images: raw, gzip, bzip2 or text; the layers and names of 3D Slicer's .seg.nrrd, too.

VTK's reader leaves the directions out and takes the first axis for components.
"""

import bz2
import gzip
import os
import re

import numpy

from .Images import first_sample, make_image, samples_of, steps_of
from .Structures import FormatError

# Signs that turn a NRRD's space into left, posterior, superior.
SPACES = {"left-posterior-superior": (1, 1, 1), "lps": (1, 1, 1),
          "right-anterior-superior": (-1, -1, 1), "ras": (-1, -1, 1),
          "left-anterior-superior": (1, -1, 1), "las": (1, -1, 1)}
NRRD_TYPES = {"int8": "i1", "signed char": "i1",
              "uint8": "u1", "uchar": "u1", "unsigned char": "u1",
              "int16": "i2", "short": "i2", "uint16": "u2", "ushort": "u2", "unsigned short": "u2",
              "int32": "i4", "int": "i4", "uint32": "u4", "uint": "u4", "unsigned int": "u4",
              "int64": "i8", "uint64": "u8", "float": "f4", "double": "f8"}


def read_nrrd(path):
    with open(path, "rb") as file:
        data = file.read()
    if not data.startswith(b"NRRD"):
        raise FormatError(f"{path} is no NRRD file.")
    end = re.search(rb"\r?\n\r?\n", data) # without one, all of a detached header is header
    lines = data[:end.start() if end else len(data)].decode("utf-8", "replace").splitlines()
    body = data[end.end():] if end else b""
    fields, keys = {}, {}
    for line in lines[1:]:
        key = re.match(r"([^#:][^:]*):(=| )(.*)", line)
        if key:
            (keys if key[2] == "=" else fields)[key[1].strip()] = key[3].strip()
    # numpy has the axis first that varies slowest, NRRD the one that varies fastest.
    samples = nrrd_samples(path, fields, body)
    steps, origin, spatial = nrrd_axes(path, fields)
    if len(spatial) != 3:
        raise FormatError(f"{path} has {len(spatial)} axes in space, not three.")
    places = [samples.ndim - 1 - axis for axis in reversed(spatial)]
    samples = numpy.moveaxis(samples, places, (-3, -2, -1))
    layers = samples.reshape(-1, *samples.shape[-3:])
    return [(make_image(layer, steps, origin), segment_names(keys, index))
            for index, layer in enumerate(layers)]


def nrrd_samples(path, fields, body):
    sizes = [int(size) for size in fields["sizes"].split()]
    kind = NRRD_TYPES.get(re.sub(r"_t$", "", fields["type"]))
    if kind is None:
        raise FormatError(f"{path} has samples of the type {fields['type']!r}: no labels.")
    detached = fields.get("data file") or fields.get("datafile")
    if detached:
        try:
            with open(os.path.join(os.path.dirname(path), detached), "rb") as file:
                body = file.read()
        except OSError:
            raise FormatError(f"{path} keeps its samples in {detached!r}: there is none.") from None
    encoding = fields["encoding"].lower()
    if encoding in ("gzip", "gz"):
        body = gzip.decompress(body)
    elif encoding in ("bzip2", "bz2"):
        body = bz2.decompress(body)
    elif encoding in ("text", "txt", "ascii"):
        return numpy.array(body.split(), dtype=kind).reshape(sizes[::-1])
    elif encoding != "raw":
        raise FormatError(f"{path} has the encoding {encoding!r}, which is not read.")
    order = ">" if fields.get("endian") == "big" else "<"
    count = int(numpy.prod(sizes))
    if len(body) < count * int(kind[1]):
        raise FormatError(f"{path} has fewer samples than its sizes say.")
    return numpy.frombuffer(body, order + kind, count).astype(kind).reshape(sizes[::-1])


def nrrd_axes(path, fields):
    """Steps and origin in LPS, and which of the axes are in space."""
    dimension = int(fields["dimension"])
    if "space directions" not in fields:
        spacings = fields.get("spacings", "1 " * dimension).split()
        spatial = list(range(dimension - 3, dimension))
        return numpy.diag([float(spacings[axis]) for axis in spatial]), numpy.zeros(3), spatial
    vectors = re.findall(r"none|\([^)]*\)", fields["space directions"])
    spatial = [axis for axis, vector in enumerate(vectors) if vector != "none"]
    steps = numpy.array([nrrd_vector(vectors[axis]) for axis in spatial]).T
    origin = nrrd_vector(fields.get("space origin", "(0,0,0)"))
    space = fields.get("space", "left-posterior-superior").lower()
    if space not in SPACES and not space.startswith("3d-"):
        raise FormatError(f"{path} is in the space {space!r}, which is not known.")
    signs = numpy.array(SPACES.get(space, (1, 1, 1)), dtype=float)
    return signs[:, None] * steps, signs * origin, spatial


def nrrd_vector(text):
    return numpy.array([float(number) for number in text.strip("() ").split(",")])


def segment_names(keys, layer):
    """The segments of a layer, as 3D Slicer writes them into .seg.nrrd."""
    names = {}
    for key, name in keys.items():
        segment = re.fullmatch(r"(Segment\d+_)Name", key)
        if segment and int(keys.get(segment[1] + "Layer", 0)) == layer:
            names[int(keys.get(segment[1] + "LabelValue", 1))] = name
    return names


def write_nrrd(image, path, names=None):
    """With names of labels, 3D Slicer takes a .seg.nrrd for a segmentation."""
    samples = samples_of(image)
    steps, origin = steps_of(image), first_sample(image)

    def vector(numbers):
        return "(" + ",".join(repr(float(number)) for number in numbers) + ")"

    type_name = next(name for name, kind in NRRD_TYPES.items() if kind == samples.dtype.str[1:])
    header = ["NRRD0004", f"type: {type_name}", "dimension: 3", "space: left-posterior-superior",
              "sizes: " + " ".join(map(str, image.GetDimensions())),
              "space directions: " + " ".join(vector(steps[:, axis]) for axis in range(3)),
              "kinds: domain domain domain", "endian: little", "encoding: gzip",
              "space origin: " + vector(origin)]
    for index, (label, name) in enumerate(sorted((names or {}).items())):
        for key, value in (("ID", f"Segment_{label}"), ("Name", name), ("LabelValue", label),
                           ("Layer", 0)):
            header.append(f"Segment{index}_{key}:={value}")
    with open(path, "wb") as file:
        file.write(("\n".join(header) + "\n\n").encode())
        file.write(gzip.compress(samples.astype(samples.dtype.newbyteorder("<")).tobytes()))
