// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   checks setters of the filter: modified time and what is printed
 */

#ifndef OrthoSlicesPropertyChanges_h
#define OrthoSlicesPropertyChanges_h

#include "vtkNew.h"
#include "vtkOrthogonalSliceReconstruction.h"

#include <gtest/gtest.h>

#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace orthoslices
{
namespace support
{

/// What is printed of a property afterwards, and the change.
using PropertyChange =
  std::pair<const char*, std::function<void(vtkOrthogonalSliceReconstruction*)>>;

/// Makes the changes, one after another, and expects that each is printed, and raises the modified
/// time when it is made, but not when it is made again.
inline void ExpectPropertyChanges(const std::vector<PropertyChange>& changes)
{
  vtkNew<vtkOrthogonalSliceReconstruction> filter;
  for (const PropertyChange& change : changes)
  {
    SCOPED_TRACE(change.first);
    const vtkMTimeType before = filter->GetMTime();
    change.second(filter);
    const vtkMTimeType after = filter->GetMTime();
    EXPECT_GT(after, before);
    change.second(filter);
    EXPECT_EQ(filter->GetMTime(), after);
    std::ostringstream text;
    filter->Print(text);
    EXPECT_NE(text.str().find(change.first), std::string::npos);
  }
}

} // namespace support
} // namespace orthoslices

#endif
