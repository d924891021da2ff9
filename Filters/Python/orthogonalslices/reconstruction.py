# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkOrthogonalSliceReconstruction as one function: contours in, a closed surface out."""

from __future__ import annotations

import dataclasses
import math
import warnings
from collections.abc import Mapping, Sequence
from typing import Any, Literal, NamedTuple, Optional, Union, get_args

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCommand, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkFieldData, vtkPolyData, vtkTable

from .contours import LABEL_ARRAY, Contours, polydata_of
from .vtkFiltersOrthogonalSlices import vtkOrthogonalSliceReconstruction

# Enumerations, with the texts of ParaView's panel. The filter numbers them in this order.
Orientation = Literal["By Nesting", "As Drawn"]
InvalidContours = Literal["Refuse", "Leave Out", "Mend"]
BorderContours = Literal["Close Along Border", "Leave Open", "Refuse"]
CrossingContours = Literal["Repair", "Refuse", "Leave Out"]
LoopRule = Literal["Union", "Even-Odd", "Non-Zero"]
Frame = Literal["Automatic", "World", "Given"]
VirtualSlices = Literal["Automatic", "Off", "By Spacing"]
EndCaps = Literal["Dome", "Flat", "Half Slice"]
SeveralCycles = Literal["By Evidence", "Discs"]
Correspondence = Literal[
    "By Evidence", "Overlap", "Elliptical Cylinders", "Spanning Tree", "Reeb Graph"]
PatchType = Literal["Smooth", "Fan", "Coons"]
CentralPoint = Literal["Least Squares", "Centroid"]
Precision = Literal["Single", "Double", "Same as input"]

ENUMERATIONS = {
    "orientation": Orientation,
    "invalid_contours": InvalidContours,
    "border_contours": BorderContours,
    "crossing_contours": CrossingContours,
    "loop_rule": LoopRule,
    "frame": Frame,
    "virtual_slices": VirtualSlices,
    "end_caps": EndCaps,
    "several_cycles": SeveralCycles,
    "correspondence": Correspondence,
    "patch_type": PatchType,
    "central_point": CentralPoint,
    "output_points_precision": Precision,
}

Triple = Sequence[float]


class ReconstructionError(RuntimeError):
    """The filter refused the contours, or there is no surface; the text is the filter's."""


class ReconstructionWarning(UserWarning):
    """A warning of the filter: contours that contradict each other, were mended or left out."""


@dataclasses.dataclass(frozen=True)
class Report:
    """What the filter says besides the surface. The header of vtkOrthogonalSliceReconstruction
    describes every array and every column.

    warnings    texts of the filter's warnings, if there are any
    fields      field data of the surface by name: counts such as "NumberOfComponents" and
                "TotalGenus" as int, measures as float, several values as an array or a list of texts
    point_data  point arrays of the surface by name, as "Normals" and "Disagreement"
    cell_data   cell arrays of the surface by name, as "ComponentId", "Repaired" and "Label"
    histogram, contours, slices, undecided, problems, components
                the tables: a mapping from the column's name to its values, one for each row
    surface     the surface as vtkPolyData, with all of these arrays
    graph       node points, arcs, isolated contours and repairs as vtkPolyData
    """

    warnings: tuple[str, ...]
    fields: Mapping[str, Any]
    point_data: Mapping[str, numpy.ndarray]
    cell_data: Mapping[str, numpy.ndarray]
    histogram: Mapping[str, numpy.ndarray]
    contours: Mapping[str, numpy.ndarray]
    slices: Mapping[str, numpy.ndarray]
    undecided: Mapping[str, numpy.ndarray]
    problems: Mapping[str, numpy.ndarray]
    components: Mapping[str, numpy.ndarray]
    surface: vtkPolyData
    graph: vtkPolyData


class Reconstruction(NamedTuple):
    """What `reconstruct` returns.

    points     coordinates (n x 3), float or double as the contours are
    triangles  indices of points (m x 3), counter-clockwise seen from outside
    report     a Report
    """

    points: numpy.ndarray
    triangles: numpy.ndarray
    report: Report


def reconstruct(
    x: Optional[Contours] = None,
    y: Optional[Contours] = None,
    z: Optional[Contours] = None,
    contours: Optional[Contours] = None,
    *,
    closed: bool = True,
    label_array: Optional[str] = None,
    orientation: Union[Orientation, int, None] = None,
    frame: Union[Frame, int, None] = None,
    frame_normals: Optional[Sequence[Triple]] = None,
    invalid_contours: Union[InvalidContours, int, None] = None,
    border_contours: Union[BorderContours, int, None] = None,
    border_bounds: Optional[Sequence[float]] = None,
    crossing_contours: Union[CrossingContours, int, None] = None,
    loop_rule: Union[LoopRule, int, None] = None,
    redrawn_tolerance: Optional[float] = None,
    insert_missing_contours: Optional[bool] = None,
    axis_weights: Optional[Triple] = None,
    plane_tolerance: Optional[float] = None,
    report_tolerance: Optional[float] = None,
    warn_of_missing_families: Optional[bool] = None,
    virtual_slices: Union[VirtualSlices, int, None] = None,
    virtual_slice_spacing: Optional[float] = None,
    follow_field: Optional[bool] = None,
    end_caps: Union[EndCaps, int, None] = None,
    several_cycles: Union[SeveralCycles, int, None] = None,
    correspondence: Union[Correspondence, int, None] = None,
    expected_components: Optional[int] = None,
    expected_genus: Optional[int] = None,
    minimum_component_size: Optional[float] = None,
    minimum_isolated_contour_size: Optional[float] = None,
    patch_type: Union[PatchType, int, None] = None,
    edge_length: Optional[float] = None,
    chord_tolerance: Optional[float] = None,
    accuracy: Optional[float] = None,
    automatic_accuracy: Optional[bool] = None,
    keep_contour_vertices: Optional[bool] = None,
    corner_angle: Optional[float] = None,
    smoothing: Optional[float] = None,
    contour_tolerance: Optional[float] = None,
    central_point: Union[CentralPoint, int, None] = None,
    compute_normals: Optional[bool] = None,
    compute_curvatures: Optional[bool] = None,
    pass_cell_arrays: Optional[bool] = None,
    output_points_precision: Union[Precision, int, None] = None,
) -> Reconstruction:
    """A closed surface from contours on x-, y- and z-slices.

        points, triangles, report = reconstruct(x, y, z, smoothing=0.5)

    x, y, z   contours on planes of constant x, y and z, in any order and direction. Leave out what
              there is not: one family is enough, `reconstruct(z=stack)`.
    contours  contours on any planes, sorted by these, instead of the others or beside them.

    Each of them is a vtkPolyData (or a composite data set of them); a contour, which is an array of
    n x 3 coordinates; a sequence of contours; or a mapping {label: contours}, of names or whole
    numbers, that makes one closed surface for each structure, with its label in
    report.cell_data["Label"].

    closed    whether contours that are arrays are closed, with their first point repeated or not.
              With False they are polylines: pieces are joined where their ends coincide.

    All other keywords are the properties of vtkOrthogonalSliceReconstruction, named in its way and
    described in its header: edge_length is SetEdgeLength. None is the filter's default. Enumerations
    are the texts of ParaView's panel, patch_type="Fan", or their numbers. frame_normals are three
    normals.

    Raises ReconstructionError, with the filter's text, where it refuses the contours or there is
    nothing to reconstruct; ValueError for arrays of wrong shape, values out of range and unknown
    texts; TypeError for what is no contour. Warnings of the filter are issued as
    ReconstructionWarning, and are in report.warnings, too.
    """
    properties = dict(locals())
    inputs = [properties.pop(name) for name in ("x", "y", "z", "contours")]
    properties.pop("closed")
    reconstruction = vtkOrthogonalSliceReconstruction()
    for port, data in enumerate(inputs):
        if data is not None:
            reconstruction.SetInputDataObject(port, polydata_of(data, closed))
    if label_array is None and any(isinstance(data, Mapping) for data in inputs):
        properties["label_array"] = LABEL_ARRAY
    for name, value in properties.items():
        if value is not None:
            set_property(reconstruction, name, value)
    texts = run(reconstruction)
    surface = reconstruction.GetOutput()
    if surface.GetNumberOfPolys() == 0:
        raise ReconstructionError(" ".join(texts) or "The surface is empty.")
    for text in texts:
        warnings.warn(text, ReconstructionWarning, stacklevel=2)
    points = vtk_to_numpy(surface.GetPoints().GetData())
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return Reconstruction(points, triangles, report_of(reconstruction, texts))


# --------------------------------------------------------------------------------------------------
# Properties

def property_name(keyword: str) -> str:
    """The filter's name of a keyword: EdgeLength for edge_length."""
    return "".join(word.capitalize() for word in keyword.split("_"))


def set_property(reconstruction: vtkOrthogonalSliceReconstruction, keyword: str, value: Any) -> None:
    """Sets a property; raises ValueError where the filter would take another value instead."""
    name = property_name(keyword)
    setter = getattr(reconstruction, "Set" + name)
    if isinstance(value, numpy.generic):
        value = value.item()
    if keyword in ENUMERATIONS:
        value = enumeration_value(keyword, value)
    elif not isinstance(value, (str, bool, int, float)):
        value = numpy.ravel(value).tolist()
    try:
        setter(value)
    except TypeError as error:
        raise TypeError(f"{keyword}: {error}") from None
    except ValueError as error:
        raise ValueError(f"{keyword}: {error}") from None
    found = getattr(reconstruction, "Get" + name)()
    if isinstance(value, (int, float)) and found != value and not math.isnan(value):
        raise ValueError(f"{keyword}={value} is out of range: the nearest value is {found}")


def enumeration_value(keyword: str, value: Union[str, int]) -> int:
    """The filter's number of a text."""
    texts = get_args(ENUMERATIONS[keyword])
    if isinstance(value, str):
        if value not in texts:
            raise ValueError(f"{keyword}={value!r} is none of {', '.join(map(repr, texts))}")
        return texts.index(value)
    return int(value)


# --------------------------------------------------------------------------------------------------
# Execution and results

def run(reconstruction: vtkOrthogonalSliceReconstruction) -> tuple[str, ...]:
    """Executes the filter. Its errors become an exception; returns the texts of its warnings."""
    texts: dict[str, list[str]] = {"ErrorEvent": [], "WarningEvent": []}

    def collect(_caller: Any, event: str, text: str) -> None:
        # VTK puts file, line, class and address in front.
        message = " ".join((text.partition("): ")[2] or text).split())
        if message not in texts[event]:
            texts[event].append(message)

    collect.CallDataType = "string0"  # type: ignore[attr-defined]
    tags = [(sender, sender.AddObserver(event, collect))
            for sender in (reconstruction, reconstruction.GetExecutive())
            for event in (vtkCommand.ErrorEvent, vtkCommand.WarningEvent)]
    reconstruction.Update()
    for sender, tag in tags:
        sender.RemoveObserver(tag)
    if texts["ErrorEvent"]:
        raise ReconstructionError(texts["ErrorEvent"][0])
    return tuple(texts["WarningEvent"])


def report_of(reconstruction: vtkOrthogonalSliceReconstruction, texts: tuple[str, ...]) -> Report:
    """All outputs but points and triangles. The data sets are the caller's: copies that share their
    arrays with nobody who would change them."""
    surface, graph = vtkPolyData(), vtkPolyData()
    surface.ShallowCopy(reconstruction.GetOutput())
    graph.ShallowCopy(reconstruction.GetGraphOutput())
    return Report(
        warnings=texts,
        fields={name: single(values) for name, values in arrays_of(surface.GetFieldData()).items()},
        point_data=arrays_of(surface.GetPointData()),
        cell_data=arrays_of(surface.GetCellData()),
        histogram=columns_of(reconstruction.GetHistogramOutput()),
        contours=columns_of(reconstruction.GetContourTable()),
        slices=columns_of(reconstruction.GetSliceTable()),
        undecided=columns_of(reconstruction.GetUndecidedTable()),
        problems=columns_of(reconstruction.GetProblemTable()),
        components=columns_of(reconstruction.GetComponentTable()),
        surface=surface,
        graph=graph,
    )


def columns_of(table: vtkTable) -> dict[str, numpy.ndarray]:
    """The columns of a table by name."""
    return arrays_of(table.GetRowData())


def arrays_of(data: vtkFieldData) -> dict[str, numpy.ndarray]:
    """The arrays of a data set by name; texts become an array of str."""
    arrays = {}
    for index in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(index)
        if isinstance(array, vtkStringArray):
            values = [array.GetValue(row) for row in range(array.GetNumberOfValues())]
            arrays[array.GetName()] = numpy.array(values, dtype=str)
        elif array.GetNumberOfTuples() > 0:
            arrays[array.GetName()] = vtk_to_numpy(array)
        else:
            arrays[array.GetName()] = numpy.zeros(0)
    return arrays


def single(values: numpy.ndarray) -> Any:
    """A single value as a number or text of Python, several as they are."""
    return values.item() if values.size == 1 else values
