# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Closed surfaces from orthogonal sets of planar contours.

    from orthogonalslices import reconstruct
    points, triangles, report = reconstruct(x, y, z)

x, y and z are the contours on planes of constant x, y and z: arrays of NumPy or vtkPolyData; see
help(reconstruct). The classes of VTK that do the work are in
orthogonalslices.vtkFiltersOrthogonalSlices: vtkOrthogonalSliceReconstruction and
vtkOrthogonalSlicer. No ParaView is needed.
"""

from ._version import __version__
from .contours import polydata_of
from .reconstruction import Reconstruction, ReconstructionError, ReconstructionWarning, Report
from .reconstruction import reconstruct

__all__ = [
    "Reconstruction",
    "ReconstructionError",
    "ReconstructionWarning",
    "Report",
    "__version__",
    "polydata_of",
    "reconstruct",
]
