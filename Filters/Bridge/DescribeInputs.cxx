// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/DescribeInputs.h"

#include "Bridge/ReadPieces.h"
#include "Core/Frames/SortByPlanes.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <algorithm>
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

/// What there is in the data sets of an input.
struct InputSize
{
  vtkIdType Contours = 0, Points = 0;
  bool IsModel = false;
};

InputSize SizeOf(vtkDataObject* input)
{
  InputSize size;
  VisitPolyData(input,
    [&](vtkPolyData* data, Index)
    {
      size.Contours += data->GetNumberOfLines() + data->GetNumberOfPolys();
      size.Points += data->GetNumberOfPoints();
      size.IsModel |= IsModel(data);
    });
  return size;
}
}

std::string DescribeInputs(const std::vector<vtkDataObject*>& inputs)
{
  std::ostringstream text;
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    const InputSize size = SizeOf(inputs[port]);
    if (size.Contours == 0 && size.Points > 0)
    {
      text << "\nThe " << NameOfPort(port) << " (port " << port << ") are " << size.Points
           << " points without lines or polygons: no contours, and a family without slices.";
    }
    else if (size.IsModel)
    {
      text << "\nThe " << NameOfPort(port) << " (port " << port
           << ") look like the surface of a model: their polygons share their points. Orthogonal "
              "Slicer cuts models into contours.";
    }
  }
  return text.str();
}

std::string DescribeMissingFamilies(
  const std::vector<vtkDataObject*>& inputs, const SortedSlices& sorted)
{
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    if ((SizeOf(inputs[port]).Contours > 0) != (port == 0))
    {
      return std::string();
    }
  }
  const auto families = std::count_if(sorted.Slices.begin(), sorted.Slices.end(),
    [](const Pieces& slices) { return slices.Count() > 0; });
  if (families > 1)
  {
    return std::string();
  }
  return "\nOnly the x-slices (port 0) are given, and all of them lie on parallel planes. If there "
         "are slices in other directions, give them, too (in ParaView: Edit, Change Input). For "
         "one family of slices there is Parallel Slice Reconstruction.";
}
}
