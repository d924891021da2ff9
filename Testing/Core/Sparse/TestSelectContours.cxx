// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SelectContours.h"

#include "Core/Base/EditContours.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Squares on three planes across z, and the repairs made on them.
struct Squares
{
  Squares()
  {
    for (const double z : { 0.0, 1.0, 2.0 })
    {
      AddSquare(z);
    }
    this->Grid = BuildSpatialGrid(this->Set, Stages::Tolerance);
  }

  void AddSquare(double z)
  {
    const Contours square = ParseContours("z=" + std::to_string(z) + ": -1,-1 1,-1 1,1 -1,1");
    AppendContours(square, this->Set);
  }

  void AddRepair(RepairKind kind, Index plane)
  {
    this->Repairs.push_back({ kind, 2, plane, { 0.0, 0.0, 0.0 }, 0.1 });
  }

  /// The planes that are left.
  std::vector<double> Remove()
  {
    this->Removed = RemoveMended(this->Repairs, this->Grid, this->Set);
    return this->Set.Coordinate;
  }

  Contours Set;
  SpatialGrid Grid;
  std::vector<Repair> Repairs;
  bool Removed = false;
};
}

//----------------------------------------------------------------------------
TEST(SelectContours, TakesAwayPlanesOnWhichArcsWereDrawnAnewFirst)
{
  Squares squares;
  squares.AddRepair(RepairKind::ArcsUncrossed, 0);
  squares.AddRepair(RepairKind::ArcsRedrawn, 1);
  EXPECT_EQ(squares.Remove(), (std::vector<double>{ 0.0, 2.0 }));
  EXPECT_TRUE(squares.Removed);
}

//----------------------------------------------------------------------------
TEST(SelectContours, TakesAwayAllMendedPlanesIfNoArcsWereDrawnAnew)
{
  Squares squares;
  squares.AddRepair(RepairKind::ArcsUncrossed, 0);
  squares.AddRepair(RepairKind::ArcsReconnected, 2);
  EXPECT_EQ(squares.Remove(), std::vector<double>{ 1.0 });
  EXPECT_TRUE(squares.Removed);
}

//----------------------------------------------------------------------------
TEST(SelectContours, TakesNothingAwayWhereNothingWasMended)
{
  Squares squares;
  EXPECT_EQ(squares.Remove().size(), 3u);
  EXPECT_FALSE(squares.Removed);
}
