// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   labels in blocks like those of a chessboard, which touch themselves along an edge
 */

#include "Core/Frames/SplitByLabel.h"
#include "Core/ReconstructLabels.h"
#include "Support/CheckLabels.h"
#include "Support/CheckSurface.h"
#include "Support/ReconstructionMesh.h"
#include "Support/TurnedSlices.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Slices through two by two blocks along z, of which those in opposite quarters have one label.
struct Chessboard
{
  PieceSets Sets = EmptySets();
  std::vector<Index> Labels; ///< of all pieces

  explicit Chessboard(const std::array<std::vector<double>, 3>& planes);

private:
  /// Of the block at x and y.
  static Index LabelAt(double x, double y) { return x * y > 0.0 ? 0 : x < 0.0 ? 1 : 2; }
  void Add(int axis, double plane, const Point2& low, const Point2& high, Index label);
};

void Chessboard::Add(int axis, double plane, const Point2& low, const Point2& high, Index label)
{
  AddPiece(this->Sets[axis],
    { { low[0], low[1] }, { high[0], low[1] }, { high[0], high[1] }, { low[0], high[1] } }, plane);
  this->Labels.push_back(label);
}

Chessboard::Chessboard(const std::array<std::vector<double>, 3>& planes)
{
  for (const double x : planes[0])
  {
    this->Add(0, x, { -1.0, -1.0 }, { 0.0, 1.0 }, LabelAt(x, -1.0));
    this->Add(0, x, { 0.0, -1.0 }, { 1.0, 1.0 }, LabelAt(x, 1.0));
  }
  for (const double y : planes[1])
  {
    this->Add(1, y, { -1.0, -1.0 }, { 1.0, 0.0 }, LabelAt(-1.0, y));
    this->Add(1, y, { -1.0, 0.0 }, { 1.0, 1.0 }, LabelAt(1.0, y));
  }
  for (const double z : planes[2])
  {
    for (const double x : { -1.0, 0.0 })
    {
      for (const double y : { -1.0, 0.0 })
      {
        this->Add(2, z, { x, y }, { x + 1.0, y + 1.0 }, LabelAt(x + 0.5, y + 0.5));
      }
    }
  }
}

/// Pairs of triangles of different labels that cross.
std::int64_t CountCrossings(const Chessboard& board, const Matrix3& matrix)
{
  Options options;
  options.Virtual = VirtualSlices::Automatic;
  const SortedSlices sorted = SortByPlanes(MapSlices(board.Sets, matrix), FrameOptions());
  const LabelSurfaces surfaces =
    ReconstructLabels(SplitByLabel(sorted, board.Labels, 3), options, Execution());
  TriangleMesh all;
  std::vector<int> labels;
  for (std::size_t label = 0; label < surfaces.OfLabel.size(); ++label)
  {
    const TriangleMesh mesh = MeshOf(surfaces.OfLabel[label]);
    EXPECT_TRUE(CheckSurface(mesh).IsClosedManifold()) << label;
    const Index first = static_cast<Index>(all.Points.size());
    all.Points.insert(all.Points.end(), mesh.Points.begin(), mesh.Points.end());
    for (const auto& t : mesh.Triangles)
    {
      all.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
    }
    labels.resize(all.Triangles.size(), static_cast<int>(label));
  }
  return CountLabelCrossings(all, labels);
}
}

TEST(TouchingLabels, DoNotCrossTheirNeighbours)
{
  const Chessboard board({ { { -0.7, 0.2, 0.6 }, { -0.6, 0.1, 0.7 }, { -0.8, 0.1, 0.7 } } });
  EXPECT_EQ(CountCrossings(board, UnitMatrix()), 0);
  EXPECT_EQ(CountCrossings(board, RandomRotation(1)), 0);
}
