// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEqualPoints_h
#define OrthoSlicesEqualPoints_h

#include <cstdint>

namespace orthoslices
{
/// How many of `count` points x, y, z would be at the place of one before them if all were rounded
/// to float, as many file formats store them.
std::int64_t CountEqualInFloat(const double* points, std::int64_t count);
std::int64_t CountEqualInFloat(const float* points, std::int64_t count);
}

#endif
