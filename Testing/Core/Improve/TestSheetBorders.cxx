// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/SheetBorders.h"

#include "Core/Improve/MakesFold.h"
#include "Core/Improve/MeshImprover.h"

#include <gtest/gtest.h>

using namespace orthoslices;

namespace
{
/// A quadrilateral in the plane z = 0 around a point, and a triangle that stands on one side of it
/// or across it. Each is a sheet of its own, closed by a fan around what is beyond its border.
struct TwoSheets
{
  enum : Index
  {
    BeyondFirst,
    BeyondSecond,
    A,
    B,
    C,
    D, ///< the quadrilateral
    P,
    Q,
    Top, ///< the triangle
    Middle
  };

  /// The triangle has two corners at those of the quadrilateral.
  TwoSheets(Index p, Index q, const Point3& top, const Point3& middle)
    : Mesh{ CornerTable(10,
              { { Middle, A, B }, { Middle, B, C }, { Middle, C, D }, { Middle, D, A },
                { P, Q, Top }, { BeyondFirst, B, A }, { BeyondFirst, C, B }, { BeyondFirst, D, C },
                { BeyondFirst, A, D }, { BeyondSecond, Q, P }, { BeyondSecond, Top, Q },
                { BeyondSecond, P, Top } }),
      { {}, {}, { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, {}, {}, top, middle },
      std::vector<Point3>(10, Point3{ 0.0, 0.0, 0.0 }) }
  {
    SheetBorders& borders = this->Mesh.Borders;
    borders.Beyond = 2;
    borders.Site = borders.Next = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 };
    for (const auto& [own, other] : { std::pair<Index, Index>{ P, p }, { Q, q } })
    {
      this->Mesh.Points[own] = this->Mesh.Points[other];
      borders.Site[own] = other;
      borders.Next[own] = other;
      borders.Next[other] = own;
    }
    for (Index corner = 15; corner < 36; corner += 3)
    {
      this->Mesh.Corners.MarkCurve(corner); // the first corner of each is beyond
    }
  }

  bool Allows(const SurfaceChange& change) const
  {
    std::vector<Box3> all = BoxesOf(this->Mesh.Corners, this->Mesh.Points);
    std::fill(all.begin() + 5, all.end(), Box3());
    const BoxTree boxes(all);
    return CrossingGuard(this->Mesh.Corners, this->Mesh.Points, boxes, this->Mesh.Borders)
      .Allows(change);
  }

  static SurfaceChange MoveMiddle(const Point3& place)
  {
    return { { 0, 1, 2, 3 },
      { { Middle, A, B }, { Middle, B, C }, { Middle, C, D }, { Middle, D, A } }, Middle, place };
  }

  /// The edge of the middle and C collapses.
  static SurfaceChange CollapseMiddle()
  {
    return { { 0, 1, 2, 3 }, { { C, A, B }, { C, D, A } }, -1, {} };
  }

  ImprovableMesh Mesh;
};
}

//----------------------------------------------------------------------------
TEST(SheetBorders, SheetsThatMeetDoNotCross)
{
  // A triangle on the side A B that leans over the quadrilateral.
  const TwoSheets sheets(TwoSheets::A, TwoSheets::B, { 0.5, 0.5, 0.25 }, { 0.5, 0.4, 0.0 });
  EXPECT_TRUE(sheets.Allows(TwoSheets::MoveMiddle({ 0.5, 0.5, 0.0 })));
  EXPECT_TRUE(sheets.Allows(TwoSheets::MoveMiddle({ 0.5, 0.4, 0.1 })));
  EXPECT_FALSE(sheets.Allows(TwoSheets::MoveMiddle({ 0.5, 0.4, 0.3 })));
}

//----------------------------------------------------------------------------
/// Two sheets get no other side between the same places, although they would not cross there.
TEST(SheetBorders, SidesStaySingle)
{
  const TwoSheets beside(TwoSheets::A, TwoSheets::B, { 0.5, 0.5, 1.0 }, { 0.5, 0.4, 0.0 });
  EXPECT_TRUE(beside.Allows(TwoSheets::CollapseMiddle()));
  const TwoSheets across(TwoSheets::A, TwoSheets::C, { 0.5, 0.5, 1.0 }, { 0.7, 0.3, -0.1 });
  EXPECT_FALSE(across.Allows(TwoSheets::CollapseMiddle()));
}

//----------------------------------------------------------------------------
TEST(SheetBorders, SheetsAreNotFoldedOntoEachOther)
{
  const TwoSheets sheets(TwoSheets::A, TwoSheets::B, { 0.5, 0.5, 0.25 }, { 0.5, 0.4, 0.0 });
  const ImprovableMesh& mesh = sheets.Mesh;
  const auto makesFold = [&](const Point3& place)
  { return MakesFold(mesh.Corners, mesh.Points, TwoSheets::MoveMiddle(place), mesh.Borders); };
  EXPECT_FALSE(makesFold({ 0.5, 0.4, 0.1 }));
  EXPECT_TRUE(makesFold({ 0.5, 0.4, 0.19 }));
}

//----------------------------------------------------------------------------
/// The borders of sheets stay as they are, and what is beyond them is no triangle.
TEST(SheetBorders, StayWhileSheetsAreImproved)
{
  TwoSheets sheets(TwoSheets::A, TwoSheets::B, { 0.5, -0.5, 0.5 }, { 0.5, 0.02, 0.0 });
  const std::vector<Point3> before = sheets.Mesh.Points;
  SpatialGrid grid;
  ImprovementLimits limits;
  limits.Tolerance = 0.01;
  limits.SmallAngle = 22.0;
  limits.Kept = TwoSheets::Middle;
  const Execution execution;
  MeshImprover(grid, limits, execution, sheets.Mesh).Run();
  for (Index point = TwoSheets::A; point < TwoSheets::Middle; ++point)
  {
    EXPECT_EQ(sheets.Mesh.Points[point], before[point]);
    EXPECT_TRUE(sheets.Mesh.Corners.IsUsed(point));
  }
  for (Index corner = 0; corner < sheets.Mesh.Corners.CornerCount(); corner += 3)
  {
    if (sheets.Mesh.Corners.IsAlive(corner) &&
      !sheets.Mesh.Borders.IsBeyond(sheets.Mesh.Corners, corner / 3))
    {
      const auto at = [&](Index i)
      { return sheets.Mesh.Points[sheets.Mesh.Corners.VertexOf(corner + i)]; };
      EXPECT_GT(SquaredSine({ at(0), at(1), at(2) }), 0.11); // 19.4 degrees
    }
  }
}
