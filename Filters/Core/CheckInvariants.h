// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCheckInvariants_h
#define OrthoSlicesCheckInvariants_h

#include "Core/Stage.h"

#include <string>

namespace orthoslices
{
/**
 * What has to hold after a stage, whatever the input: what is wrong first, or an empty string. With
 * ORTHOGONAL_SLICES_CHECK_INVARIANTS, which debug, sanitizer and fuzz builds define, Reconstruct
 * calls it after each stage and aborts the program if something is wrong.
 */
std::string CheckInvariants(Stage stage, const StageTables& tables, const Reconstruction& result);
}

#endif
