// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   labels in blocks like those of a chessboard, which touch themselves along an edge, and
 *          labels that meet on a line in which slices meet
 */

#include "Core/Frames/SplitByLabel.h"
#include "Core/ReconstructLabels.h"
#include "Support/CheckLabels.h"
#include "Support/CheckSurface.h"
#include "Support/ReconstructionMesh.h"
#include "Support/TurnedSlices.h"

#include <gtest/gtest.h>

#include <algorithm>

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

/// Slices through sectors along z, which meet where x and y are 0: on slices of y, too. Of one that
/// reaches below that slice, a side runs upwards between the sides of two that do not.
struct Sectors
{
  PieceSets Sets = EmptySets();
  std::vector<Index> Labels; ///< of all pieces

  Sectors();

private:
  void Add(int axis, double plane, const std::vector<Point2>& corners, Index label);
  /// Rectangles between places where labels change, from -1 to 1, on a slice across x or y.
  void AddBands(int axis, double plane, const std::vector<double>& ends, std::vector<Index> labels);
};

void Sectors::Add(int axis, double plane, const std::vector<Point2>& corners, Index label)
{
  AddPiece(this->Sets[axis], corners, plane);
  this->Labels.push_back(label);
}

void Sectors::AddBands(
  int axis, double plane, const std::vector<double>& ends, std::vector<Index> labels)
{
  double low = -1.0;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const double high = i < ends.size() ? ends[i] : 1.0;
    std::vector<Point2> corners{ { low, -1.0 }, { high, -1.0 }, { high, 1.0 }, { low, 1.0 } };
    if (axis == 1)
    {
      corners = { { -1.0, low }, { 1.0, low }, { 1.0, high }, { -1.0, high } }; // z before x
    }
    this->Add(axis, plane, corners, labels[i]);
    low = high;
  }
}

Sectors::Sectors()
{
  constexpr double steep = 1.25, middle = 1.125, flat = 0.5; // slopes
  const Point2 center{ 0.0, 0.0 }, first{ 1.0 / steep, 1.0 }, second{ 1.0 / middle, 1.0 };
  const Point2 third{ 1.0, flat };
  for (const double x : { 0.3, 0.7 })
  {
    this->AddBands(0, x, { flat * x, middle * x, steep * x }, { 3, 2, 1, 0 });
  }
  this->AddBands(0, -0.4, {}, { 0 });
  for (const double y : { -0.6, 0.0 })
  {
    this->AddBands(1, y, { 0.0 }, { 0, 3 });
  }
  this->AddBands(1, 0.4, { 0.4 / steep, 0.4 / middle, 0.4 / flat }, { 0, 1, 2, 3 });
  for (const double z : { -0.7, 0.1, 0.6 })
  {
    this->Add(2, z, { { -1.0, -1.0 }, { 0.0, -1.0 }, center, first, { -1.0, 1.0 } }, 0);
    this->Add(2, z, { center, second, first }, 1);
    this->Add(2, z, { center, third, { 1.0, 1.0 }, second }, 2);
    this->Add(2, z, { { 0.0, -1.0 }, { 1.0, -1.0 }, third, center }, 3);
  }
}

/// Pairs of triangles of different labels that cross.
template <class Slices>
std::int64_t CountCrossings(const Slices& board, const Matrix3& matrix,
  VirtualSlices virtualSlices = VirtualSlices::Automatic)
{
  Options options;
  options.Virtual = virtualSlices;
  const SortedSlices sorted = SortByPlanes(MapSlices(board.Sets, matrix), FrameOptions());
  const Index count = *std::max_element(board.Labels.begin(), board.Labels.end()) + 1;
  const LabelSurfaces surfaces =
    ReconstructLabels(SplitByLabel(sorted, board.Labels, count), options, Execution());
  const LabelMesh all = MeshOf(surfaces);
  EXPECT_TRUE(CheckSurface(all.Mesh).IsClosedManifold());
  return CountLabelCrossings(all.Mesh, all.Labels);
}
}

TEST(TouchingLabels, DoNotCrossTheirNeighbours)
{
  const Chessboard board({ { { -0.7, 0.2, 0.6 }, { -0.6, 0.1, 0.7 }, { -0.8, 0.1, 0.7 } } });
  EXPECT_EQ(CountCrossings(board, UnitMatrix()), 0);
  EXPECT_EQ(CountCrossings(board, RandomRotation(1)), 0);
}

/// Where labels meet on a slice's line, each has room there that suits all of them.
TEST(TouchingLabels, DoNotCrossWhereTheyMeetOnALine)
{
  const Sectors sectors;
  for (const VirtualSlices virtualSlices : { VirtualSlices::Off, VirtualSlices::Automatic })
  {
    EXPECT_EQ(CountCrossings(sectors, UnitMatrix(), virtualSlices), 0);
    EXPECT_EQ(CountCrossings(sectors, RandomRotation(1), virtualSlices), 0);
  }
}
