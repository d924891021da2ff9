// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/CompareOthers.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace orthoslices
{
namespace
{
/// Of many contours so many are named.
constexpr Index ListedContours = 10;
}

std::vector<Agreement> MeasureDistances(const Polylines& lines, vtkPolyData* surface)
{
  std::vector<Agreement> distances(lines.Count());
  if (lines.Count() == 0 || surface->GetNumberOfPolys() == 0)
  {
    return distances;
  }
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  for (Index line = 0; line < lines.Count(); ++line)
  {
    for (Index i = lines.Offsets[line]; i < lines.Offsets[line + 1]; ++i)
    {
      const Point3 point = lines.PointAt(i);
      Point3 nearest;
      vtkIdType cell = -1;
      int part = 0;
      double squared = 0.0;
      locator->FindClosestPoint(point.data(), nearest.data(), cell, part, squared);
      distances[line].Add(std::sqrt(squared));
    }
  }
  return distances;
}

void WriteOthers(const Polylines& lines, const std::vector<Agreement>& distances, vtkTable* table)
{
  for (Index line = 0; line < lines.Count(); ++line)
  {
    for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
    {
      auto* column = vtkDataArray::SafeDownCast(table->GetColumn(i));
      const std::string name = column->GetName();
      const double value = name == "Port" ? lines.From.Port[line]
        : name == "Block"                 ? lines.From.Block[line]
        : name == "Cell"                  ? static_cast<double>(lines.From.Cell[line])
        : name == "NodePoints"            ? 0.0
        : name == "RmsDisagreement"       ? distances[line].RootMeanSquare()
        : name == "MaxDisagreement"       ? distances[line].Greatest
        : name == "PlaneCoordinate"       ? vtkMath::Nan()
                                          : -1.0; // the axis and the number of the slice
      column->InsertNextTuple1(value);
    }
  }
}

std::string DescribeOthers(const Polylines& lines, const std::vector<Agreement>& distances,
  const std::vector<std::uint8_t>& guiding)
{
  std::ostringstream text;
  if (lines.Count() == 0)
  {
    return text.str();
  }
  text << "\n"
       << lines.Count()
       << " contours lie on planes at other angles than those of up to three families, and take no "
          "part as slices. ";
  const auto guides = std::count(guiding.begin(), guiding.end(), std::uint8_t(1));
  if (guides > 0)
  {
    text << "Between the slices, the surface bends through the planes of " << guides
         << " of them. ";
  }
  text << "Distance of the surface from them:";
  for (Index line = 0; line < std::min(lines.Count(), ListedContours); ++line)
  {
    text << "\n  port " << int(lines.From.Port[line]);
    if (lines.From.Block[line] > 0)
    {
      text << ", block " << lines.From.Block[line];
    }
    text << ", cell " << lines.From.Cell[line] << ": RMS " << distances[line].RootMeanSquare()
         << ", at most " << distances[line].Greatest;
  }
  if (lines.Count() > ListedContours)
  {
    text << "\n  and " << lines.Count() - ListedContours << " more (see the table of contours)";
  }
  return text.str();
}
}
