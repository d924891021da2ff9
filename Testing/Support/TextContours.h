// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   contours as text, for literals in tests and for logs
 *
 * One piece of a contour on each line, or separated by semicolons:
 *
 *   z=0: 0,0 1,0 1,1          closed contour on the plane z = 0
 *   x=0.5 open: 0,0 1,0       piece with two loose ends on the plane x = 0.5
 *   y=2: 0,0 1,0 1,1,2.1      the last vertex leaves the plane: its y is 2.1
 *
 * Vertices are given by their coordinates along FirstAxis and SecondAxis of the slice: x,y for
 * z-slices, y,z for x-slices, z,x for y-slices. So a contour that runs counter-clockwise as read
 * has its interior on the left. Numbers may be "nan" and "inf".
 */

#ifndef OrthoSlicesTextContours_h
#define OrthoSlicesTextContours_h

#include "Core/Base/Contours.h"

#include <string>

namespace orthoslices
{
namespace support
{

/// Pieces of the three axes. Cells are numbered from 0 in each axis, in the order of the text.
using PieceSets = std::array<Pieces, 3>;

/// Three sets without pieces, each with its axis.
PieceSets EmptySets();

/// Ends the program with a message if the text is no list of contours.
PieceSets ParsePieces(const std::string& text);

/// Closed contours of all axes, x before y before z; planes are not numbered yet.
Contours ParseContours(const std::string& text);

/// The text that gives the same pieces, with all digits.
std::string ToText(const PieceSets& pieces);

/// Appends a contour on a plane across z and numbers its cell.
void AddContour(
  Contours& contours, const std::vector<std::array<double, 2>>& vertices, double plane = 0.0);

/// Whether any of the contours has a vertex there.
bool HasVertex(const Contours& contours, const std::array<double, 2>& place);

/// Appends a closed piece and numbers its cell.
void AddPiece(Pieces& pieces, const std::vector<std::array<double, 2>>& vertices, double plane);

} // namespace support
} // namespace orthoslices

#endif
