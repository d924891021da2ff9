// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEditContours_h
#define OrthoSlicesEditContours_h

#include "Core/Base/Box.h"
#include "Core/Base/Contours.h"

#include <vector>

/// What is asked and done of whole contours, by all stages that read or change them.
namespace orthoslices
{
/// Takes out the contours that are marked; `marked` has an entry for each.
void RemoveMarked(const std::vector<std::uint8_t>& marked, Contours& contours);

/// Appends contours. They are real where `contours` has some that are virtual.
void AppendContours(const Contours& added, Contours& contours);

/// For what changes the contours of several structures together.
std::vector<Contours*> PointersTo(std::vector<Contours>& structures);

/// The contours of each slice, in their order; slices by axis and plane.
std::vector<std::vector<Index>> GroupBySlice(const Contours& contours);

/// Twice the signed area of a contour: positive when it runs counter-clockwise seen from its axis.
double TwiceSignedArea(const Contours& contours, Index contour);

/// The box around all contours, or around the real ones alone.
Box3 BoxOf(const Contours& contours, bool withVirtual = true);
}

#endif
