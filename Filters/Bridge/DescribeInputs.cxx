// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/DescribeInputs.h"

#include "Bridge/ReadPieces.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <sstream>

namespace orthoslices
{
namespace
{
/// Fewer polygons than a cube has when its faces are triangles are no model.
constexpr vtkIdType LeastOfModel = 12;

const char* NameOfPort(std::size_t port)
{
  constexpr const char* names[] = { "x-slices", "y-slices", "z-slices" };
  return port < 3 ? names[port] : "contours";
}

/// Polygons of a mesh share their points: a closed one of triangles has half as many points as
/// triangles, one of quadrilaterals as many. Contours have at least three of their own each.
bool IsModel(vtkPolyData* data)
{
  const vtkIdType polygons = data->GetNumberOfPolys();
  return data->GetNumberOfLines() == 0 && polygons >= LeastOfModel &&
    data->GetPolys()->GetMaxCellSize() <= 4 && 2 * data->GetNumberOfPoints() < 3 * polygons;
}
}

std::string DescribeInputs(const std::vector<vtkDataObject*>& inputs)
{
  std::ostringstream text;
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    vtkIdType contours = 0, points = 0;
    bool isModel = false;
    VisitPolyData(inputs[port],
      [&](vtkPolyData* data, Index)
      {
        contours += data->GetNumberOfLines() + data->GetNumberOfPolys();
        points += data->GetNumberOfPoints();
        isModel |= IsModel(data);
      });
    if (contours == 0 && points > 0)
    {
      text << "\nThe " << NameOfPort(port) << " (port " << port << ") are " << points
           << " points without lines or polygons: no contours, and a family without slices.";
    }
    else if (isModel)
    {
      text << "\nThe " << NameOfPort(port) << " (port " << port
           << ") look like the surface of a model: their polygons share their points. Orthogonal "
              "Slicer cuts models into contours.";
    }
  }
  return text.str();
}
}
