# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
r"""Closed surfaces from a file of contours or labels, in the formats that people have:

    python3 ReconstructAny.py IN [IN ...] OUT [options]

IN, by its ending (the folder Formats says more about each):
    .dcm                       radiotherapy structures (DICOM RTSTRUCT), all of them
    .nrrd .mha .mhd .nii(.gz)  label image, with its directions; also .seg.nrrd of 3D Slicer, .vti
    .csv .tsv .txt .xyz        table of points: x, y, z and a column that tells contours apart
    .contour .csl              cross-sections of the literature
    .roi .zip                  selections of ImageJ
    .mrk.json .fcsv            curves of 3D Slicer
    .vtp .vtk                  lines and polygons, structures by the cell array Label
Several files are read together: the three views of one object, or a file for each contour.

OUT, by its ending:
    .vtp                       all surfaces in one file, with the cell array Label
    .stl .obj .ply             a surface; of several structures a file each, OUT-name.stl
    .nrrd .mha .nii(.gz) .vti  label image, on the grid of --grid, --spacing or a label image IN

    --list                 say what is in the files, and reconstruct nothing (no OUT then)
    --contours FILE.vtp    write the contours, too, to look at
    --names FILE           names and colors of labels: label descriptions of ITK-SNAP, or a color
                           table of 3D Slicer
    --structure NAME       only this structure (may be given several times)
    --slices N             cut label images on at most N planes along each axis (default 64)
    --blur S               take the steps out of label images with a Gaussian of S samples, as 0.7
                           (default 0: as they are); thin parts go, too, from twice S on
    --voxel SX SY SZ       distance of samples, where files count pixels and slices (default 1 1 1)
    --grid FILE            image whose grid the label image gets
    --spacing S            grid of cubes of this size around the surfaces instead
    --set PROPERTY=VALUE   property of vtkOrthogonalSliceReconstruction, as Smoothing=0.5

Medical formats come and go in one frame: LPS, as DICOM has it, in millimetres. A structure that
fails is reported and does not keep the others from being written; the exit status is 1 then.
"""

import os
import sys

from vtkmodules.vtkFiltersCore import vtkMassProperties

from Formats import LabelMaps, Surfaces, read_structures
from Formats.Command import parser_of
from Formats.Filter import reconstruct
from Formats.LabelNames import name_structures, read_label_names
from Formats.Structures import FormatError, merged


def parse(arguments):
    parser = parser_of(arguments, "ReconstructAny.py IN [IN ...] OUT [options]", __doc__)
    parser.add_argument("files", nargs="+")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--contours")
    parser.add_argument("--names")
    parser.add_argument("--structure", action="append")
    parser.add_argument("--slices", type=int, default=64)
    parser.add_argument("--blur", type=float, default=0.0)
    parser.add_argument("--voxel", type=float, nargs=3, default=(1.0, 1.0, 1.0))
    parser.add_argument("--grid")
    parser.add_argument("--spacing", type=float)
    parser.add_argument("--set", action="append", default=[])
    options = parser.parse_args(arguments)
    options.out = None if options.list else options.files.pop()
    if not options.files:
        parser.error("give a file to read and a file to write")
    return options


def properties_of(texts):
    """NAME=VALUE, with whole numbers as such: properties are numbers, enumerations and switches."""
    properties = {}
    for text in texts:
        name, equals, value = text.partition("=")
        try:
            properties[name] = int(value) if value.lstrip("+-").isdigit() else float(value)
        except ValueError:
            raise FormatError(f"--set {text}: give a property and a number.") from None
    return properties


def read_all(options):
    structures = merged(read_structures(path, options.voxel, options.slices, options.blur)
                        for path in options.files)
    if options.names:
        name_structures(structures, read_label_names(options.names))
    if options.structure:
        names = [structure.name for structure in structures]
        for name in options.structure:
            if name not in names:
                raise FormatError(f"There is no structure {name!r}, but {', '.join(names)}.")
        structures = [structure for structure in structures if structure.name in options.structure]
    if not structures:
        raise FormatError("The files have no contours.")
    return structures


def describe(surface):
    fields = surface.GetFieldData()
    mass = vtkMassProperties()
    mass.SetInputData(surface)
    components, genus = (int(fields.GetArray(name).GetValue(0))
                         for name in ("NumberOfComponents", "TotalGenus"))
    return (f"{surface.GetNumberOfPolys()} triangles, components {components}, genus {genus}, "
            f"area {mass.GetSurfaceArea():.6g}, volume {mass.GetVolume():.6g}")


def reconstruct_all(structures, properties):
    """One surface for each structure: pairs of both, and how many failed."""
    surfaces = []
    for structure in structures:
        try:
            surface = reconstruct(structure, properties)
            contours = structure.number_of_contours()
            print(f"{structure.name}: {contours} contours, {describe(surface)}")
            surfaces.append((structure, surface))
        except FormatError as error:
            print(f"{structure.name}: {error}", file=sys.stderr)
    return surfaces, len(structures) - len(surfaces)


def check_out(options):
    """Before anything takes time: whether the result can be written."""
    out = options.out.lower()
    if not out.endswith(Surfaces.ENDINGS + LabelMaps.WRITTEN):
        raise FormatError(f"{options.out}: surfaces are written as {', '.join(Surfaces.ENDINGS)}, "
                          f"label images as {', '.join(LabelMaps.WRITTEN)}.")
    if not os.path.isdir(os.path.dirname(options.out) or "."):
        raise FormatError(f"There is no folder for {options.out}.")
    if LabelMaps.ending(options.out) and not (options.spacing or grid_file(options)):
        raise FormatError("A label image needs a grid: give --grid or --spacing.")


def grid_file(options):
    """The image whose grid a label image gets: the one given, or the first that is read."""
    return options.grid or next((path for path in options.files if LabelMaps.ending(path)), None)


def grid_for(options, surfaces):
    if options.spacing:
        return Surfaces.make_grid(surfaces, options.spacing)
    return LabelMaps.read_label_images(grid_file(options))[0][0]


def write_all(options, surfaces):
    if LabelMaps.ending(options.out):
        image = Surfaces.draw_labels(surfaces, grid_for(options, surfaces))
        names = {structure.label: structure.name for structure, _ in surfaces}
        LabelMaps.write_label_image(image, options.out, names)
        return [options.out]
    return Surfaces.write_surfaces(surfaces, options.out)


def main(arguments):
    options = parse(arguments)
    try:
        if options.out:
            check_out(options)
        structures = read_all(options)
        if options.list:
            for structure in structures:
                contours = structure.number_of_contours()
                print(f"{structure.label:4} {structure.name}: {contours} contours")
            return 0
        if options.contours:
            Surfaces.write_contours(structures, options.contours)
        surfaces, failed = reconstruct_all(structures, properties_of(options.set))
        if surfaces:
            print("Written: " + ", ".join(write_all(options, surfaces)))
        return 1 if failed else 0
    except FormatError as error:
        print(error, file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
