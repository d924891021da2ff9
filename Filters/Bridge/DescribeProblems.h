// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what is wrong with the input, in the user's words
 */

#ifndef OrthoSlicesDescribeProblems_h
#define OrthoSlicesDescribeProblems_h

#include "Core/Base/Contours.h"

#include <string>
#include <vector>

namespace orthoslices
{
/// The name of a kind in the table of input problems.
const char* NameOf(ProblemKind kind);

/// One line for each contour that cannot be used as it is, with port, cell and coordinate: the
/// first ten, and how many more there are.
std::string DescribeProblems(const std::vector<Problem>& problems);

/// One line for each kind of problem that was mended, or left out: how many there are, how great
/// they are at most, and port, cell and coordinate of the first. Empty if there are none.
std::string DescribeMended(const std::vector<Problem>& problems);
}

#endif
