// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   random changes of the fuzzer's inputs
 */

#ifndef OrthoSlicesFuzzChanges_h
#define OrthoSlicesFuzzChanges_h

#include "FuzzInput.h"
#include "Support/Random.h"

namespace orthoslices
{
namespace support
{

/// One change: of a number, of a piece, of the flags, of the frame, of labels, or a box with its
/// slices.
void ChangeFuzzInput(FuzzInput& input, Random& random);

} // namespace support
} // namespace orthoslices

#endif
