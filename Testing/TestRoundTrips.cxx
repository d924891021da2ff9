// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   surfaces that are written to files and read again, or moved by the user, are still valid
 */

#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/Vtk/DataSets.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <map>
#include <sstream>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// What is left of a mesh whose triangles were written with their rounded corners, as in STL format,
/// and read again: points at the same place are one.
TriangleMesh Merge(const TriangleMesh& mesh, const std::function<double(double)>& round)
{
  TriangleMesh merged;
  std::map<Point3, std::int64_t> numbers;
  for (const auto& triangle : mesh.Triangles)
  {
    merged.Triangles.emplace_back();
    for (int i = 0; i < 3; ++i)
    {
      Point3 p = mesh.Points[triangle[i]];
      std::transform(p.begin(), p.end(), p.begin(), round);
      const auto [found, isNew] =
        numbers.insert({ p, static_cast<std::int64_t>(merged.Points.size()) });
      if (isNew)
      {
        merged.Points.push_back(p);
      }
      merged.Triangles.back()[i] = found->second;
    }
  }
  return merged;
}

/// As in binary files.
double ToFloat(double x) { return static_cast<double>(static_cast<float>(x)); }

/// As in files with text of so many digits.
template <int Digits>
double ToText(double x)
{
  std::ostringstream text;
  text << std::setprecision(Digits) << x;
  return ToFloat(std::stod(text.str()));
}

template <typename Visit>
void VisitSurfaces(int precision, Visit&& visit)
{
  for (const DataSet& data : AllDataSets())
  {
    for (const bool isLight : { false, true })
    {
      SCOPED_TRACE(data.Name + (isLight ? ", few triangles" : ""));
      FilterRun run(ReadPieceSets(data, 16));
      run.Filter->SetAutomaticAccuracy(isLight);
      run.Filter->SetOutputPointsPrecision(precision);
      visit(run.Update());
    }
  }
}
}

//----------------------------------------------------------------------------
/// Points of single precision are what binary files in STL format store, and nine digits tell all of
/// them apart.
TEST(RoundTrips, SinglePrecisionThroughStl)
{
  VisitSurfaces(vtkAlgorithm::SINGLE_PRECISION,
    [](vtkPolyData* surface)
    {
      EXPECT_EQ(FieldValue(surface, "NumberOfPointsEqualInFloat"), 0);
      for (double (*round)(double) : { ToFloat, ToText<9> })
      {
        const TriangleMesh mesh = Merge(MeshOf(surface), round);
        EXPECT_EQ(static_cast<vtkIdType>(mesh.Points.size()), surface->GetNumberOfPoints());
        const SurfaceCheck check = CheckSurface(mesh);
        EXPECT_TRUE(check.IsClosedManifold()) << check;
        EXPECT_TRUE(FindMeetings(mesh).empty());
      }
    });
}

//----------------------------------------------------------------------------
/// The surface says how many points of double precision such files make one.
TEST(RoundTrips, DoublePrecisionThroughStl)
{
  VisitSurfaces(vtkAlgorithm::DOUBLE_PRECISION,
    [](vtkPolyData* surface)
    {
      const vtkIdType same = FieldValue(surface, "NumberOfPointsEqualInFloat");
      const TriangleMesh mesh = Merge(MeshOf(surface), ToFloat);
      EXPECT_EQ(static_cast<vtkIdType>(mesh.Points.size()) + same, surface->GetNumberOfPoints());
      EXPECT_LT(same, 10);
      if (same == 0)
      {
        const SurfaceCheck check = CheckSurface(mesh);
        EXPECT_TRUE(check.IsClosedManifold()) << check;
      }
    });
}

//----------------------------------------------------------------------------
/// Turned, scaled and moved by the user, in double precision, whatever that of the surface was.
TEST(RoundTrips, TurnedAndScaled)
{
  for (const int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
  {
    VisitSurfaces(precision,
      [](vtkPolyData* surface)
      {
        const double cosine = std::cos(0.6), sine = std::sin(0.6);
        TriangleMesh mesh = MeshOf(surface);
        for (Point3& p : mesh.Points)
        {
          const double y = sine * p[0] + cosine * p[1];
          p = { 7.0 * (cosine * p[0] - sine * p[1]) + 10.0, 7.0 * (cosine * y - sine * p[2]) - 20.0,
            7.0 * (sine * y + cosine * p[2]) + 30.0 };
        }
        const SurfaceCheck check = CheckSurface(mesh);
        EXPECT_TRUE(check.IsClosedManifold()) << check;
        EXPECT_TRUE(FindMeetings(mesh).empty());
      });
  }
}
