// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEditContours_h
#define OrthoSlicesEditContours_h

#include "Core/Base/Box.h"
#include "Core/Base/Contours.h"

#include <vector>

/// What is done with whole contours, by all stages that read or change them.
namespace orthoslices
{
/// Takes out the contours that are marked; `marked` has an entry for each.
void RemoveMarked(const std::vector<std::uint8_t>& marked, Contours& contours);

/// Appends contours. They are real where `contours` has some that are virtual.
void AppendContours(const Contours& added, Contours& contours);

/// The box around all contours, or around the real ones alone.
Box3 BoxOf(const Contours& contours, bool withVirtual = true);
}

#endif
