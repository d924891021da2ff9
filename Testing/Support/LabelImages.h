// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   images of labels of several kinds, made from random numbers
 */

#ifndef OrthoSlicesLabelImages_h
#define OrthoSlicesLabelImages_h

#include "Core/Base/Types.h"

#include <cstdint>
#include <vector>

namespace orthoslices
{
namespace support
{

/// How an image is divided into labels.
enum class LabelKind
{
  Ball,   ///< a ball, divided by which of some random places is nearest
  Box,    ///< the same in a box
  Wavy,   ///< a ball, the same by wavy borders
  Nested, ///< a ball of label 1 with small balls in it, each with a ball of another label inside
  Layers, ///< a ball of wavy layers, two to four samples thick, as many as there are labels, repeated
  Corners ///< a ball of blocks of random labels, some of them background, that touch in sides and corners
};

struct LabelImage
{
  int Size = 0;                     ///< samples on each axis, at 0, 1, ...
  std::vector<std::uint8_t> Labels; ///< x runs fastest; 0 is background

  std::uint8_t& At(int i, int j, int k)
  {
    return this->Labels[i + static_cast<std::size_t>(this->Size) * (j + this->Size * k)];
  }
  std::uint8_t At(int i, int j, int k) const { return const_cast<LabelImage*>(this)->At(i, j, k); }
};

/// An image of labels 1 and up to `labels`, of which some may be missing. Samples on its border are
/// background.
LabelImage MakeLabelImage(LabelKind kind, int labels, std::uint64_t seed, int size = 48);

/// A ball, divided by which of some places is nearest, in units of its radius from its middle:
/// labels 1 and up are around the places.
LabelImage DivideBall(const std::vector<Point3>& places, int size = 48);

/// Every sample becomes a block of so many on each axis, whose contours are stairs.
LabelImage Coarsen(const LabelImage& image, int block);

} // namespace support
} // namespace orthoslices

#endif
