// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   inputs of the fuzzer as text that is read without ever failing
 *
 * Every change of such a text means something:
 *
 *   FD                   flags, see below FD 2 0 -1m2 1        the same; the slices are turned by 2
 *   * 7.5 degrees around x and -7.5 degrees around z, and inclined; see FuzzInput::Frame z2: 0,0
 *   4,0 4,4      contour on z = 2; small integers, so that coincidences are frequent x1o: 0,0
 *   4m1,0e-2    open piece; m adds multiples of 2^-22, e of 2^-50 y3aq: 0,0 4h1,0 4,4  label a (of
 *   a, b, c), through port q (p, q, r for those of x, y, z); h moves a vertex off its plane by
 *   multiples of 2^-7 w1: 0,0 4,0 4,4      on a plane of a further family
 *
 * Coordinates as in Support/TextContours.h. Flags, by what they are about:
 *
 *   numbers   F float, T tiny (times 1e-9), B features of 1e-3 at 1e6, Q rounded to 1/64 in the
 *   world input     X, Y, Z without the slices of this axis, A all through the port of any families
 *   frames    G given, W that of the world contours  D as drawn, L left out where they cross, E
 *   even-odd, N non-zero, M mended borders   K surface left open there, R contours that end there
 *   refused; with M surface   C centroid, V virtual slices where they are needed, P ends flat, H
 *   half a slice farther
 */

#ifndef OrthoSlicesFuzzInput_h
#define OrthoSlicesFuzzInput_h

#include "Core/Base/Types.h"

#include <string>
#include <vector>

namespace orthoslices
{
namespace support
{

struct FuzzNumber
{
  int Whole = 0, Middle = 0, Last = 0;
  int Height = 0; ///< of the vertex over its plane

  double Value() const { return this->Whole + this->Middle * 0x1p-22 + this->Last * 0x1p-50; }
};

struct FuzzPiece
{
  static constexpr int Oblique = 3;

  int Axis = 0; ///< or Oblique
  bool Open = false;
  int Label = -1; ///< -1: none
  int Port = -1;  ///< -1: that of the axis
  FuzzNumber Plane;
  std::vector<std::array<FuzzNumber, 2>> Vertices;
};

struct FuzzInput
{
  static constexpr std::size_t MaxPieces = 24;
  static constexpr std::size_t MaxVertices = 24;
  static constexpr int Greatest = 12; ///< integer, of either sign
  static constexpr int Labels = 3;
  static constexpr const char* AllFlags = "DFCLTBVMXYZENAGWQKRPH";

  std::string Flags;
  /// Three rotations, around x, y and z, in units of 7.5 degrees, and three inclinations, in
  /// sixteenths: of y towards x, of z towards x, of z towards y.
  std::array<FuzzNumber, 6> Frame;
  std::vector<FuzzPiece> Pieces;

  bool Has(char flag) const { return this->Flags.find(flag) != std::string::npos; }
  bool HasLabels() const;
};

FuzzInput ReadFuzzInput(const std::string& text);
std::string WriteFuzzInput(const FuzzInput& input);

} // namespace support
} // namespace orthoslices

#endif
