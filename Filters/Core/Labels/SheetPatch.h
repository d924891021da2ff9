// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSheetPatch_h
#define OrthoSlicesSheetPatch_h

#include "Core/Patches/PatchBorder.h"

#include <functional>
#include <vector>

namespace orthoslices
{
/// A curve in which surfaces of structures meet within a cell: from one point on the boundary of the
/// cell over a point inside to another one. Its ends are numbers of points of the cell.
struct JunctionCurve
{
  Index First, Last;
  Point3 Middle;
};

/**
 * The patch of a border on which curves begin and end that divide it into sheets. Each curve cuts off
 * the part of the border between its ends, a sheet that is a fan around its middle. What is left is
 * one, too, if there is one curve; else it is a fan around another point, which `placeInside` moves into
 * the cell from the middle of its corners. A sheet has the same triangles in all patches that it is
 * part of, whichever way their borders run.
 *
 * `border` has numbers of points of the cell, `places` where these are. False if no ends of curves,
 * or ends of several, lie between the ends of one.
 */
bool BuildSheets(const std::vector<Index>& border, const std::vector<Point3>& places,
  const std::vector<JunctionCurve>& curves,
  const std::function<Point3(const Point3&)>& placeInside, InnerPatch& patch);
}

#endif
