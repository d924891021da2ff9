// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ReadSlices.h"

#include "Core/Base/EditContours.h"
#include "Core/Loops/RedrawnContours.h"
#include "Core/Loops/ResolveLoops.h"
#include "Core/Loops/WeldBridges.h"
#include "Core/Pieces/AssembleContours.h"
#include "Core/Slices/SmoothContours.h"
#include "Core/Sparse/MissingContours.h"

#include <cmath>

namespace orthoslices
{
namespace
{
/// How far vertices of a single slice may be off their plane, as a share of the diagonal of all
/// contours: that no other slice is meant is certain, and a contour that leaves its plane by more
/// is bent.
constexpr double AloneTolerance = 1e-2;

/// Diagonal of the bounding box of all finite coordinates of the input, without virtual pieces.
double FindDiagonal(const std::array<Pieces, 3>& pieces)
{
  Box3 box;
  for (const Pieces& set : pieces)
  {
    const auto extend = [&](int axis, const std::vector<double>& values)
    {
      for (Index piece = 0; piece < set.Count(); ++piece)
      {
        for (Index i = set.Offsets[piece]; i < set.Offsets[piece + 1] && !set.IsVirtual(piece); ++i)
        {
          if (std::isfinite(values[i]))
          {
            box.Add(axis, values[i]);
          }
        }
      }
    };
    extend(FirstAxis(set.Axis), set.U);
    extend(SecondAxis(set.Axis), set.V);
    extend(set.Axis, set.W);
  }
  const double diagonal = box.Diagonal();
  return std::isfinite(diagonal) ? diagonal : 0.0;
}

/// Closed contours on planes (the paper's section 3).
bool ReadContours(std::array<Pieces, 3>&& pieces, Pass& pass)
{
  pass.Result.Diagonal = FindDiagonal(pieces);
  pass.Tables.Tolerance = pass.Settings.PlaneTolerance * pass.Result.Diagonal;
  AssembleSettings settings;
  settings.Tolerance = pass.Tables.Tolerance;
  settings.Mend = pass.Settings.Invalid == InvalidContours::Mend;
  settings.AloneTolerance = AloneTolerance * pass.Result.Diagonal;
  settings.AtBorder = pass.Settings.AtBorder;
  settings.GivenBorder = pass.Settings.GivenBorder;
  PieceProblems problems =
    AssembleContours(std::move(pieces), settings, pass.Tables.Contours, pass.Execute);
  pass.Result.Invalid = std::move(problems.Unusable);
  pass.Result.Mended = std::move(problems.Mended);
  if (settings.AtBorder == BorderContours::LeaveOpen)
  {
    pass.Result.OpenBorder = problems.Border;
  }
  else
  {
    pass.Tables.Border = problems.Border;
  }
  if (pass.Tables.Contours.Count() == 0)
  {
    // Nothing was mended, but all left out.
    pass.Result.Invalid.insert(
      pass.Result.Invalid.end(), pass.Result.Mended.begin(), pass.Result.Mended.end());
    pass.Result.Mended.clear();
  }
  pass.Finish(Stage::AssembleContours);
  return pass.GoOn();
}

/// Contours that are drawn twice count once, and those that cross bound what a rule says. Returns
/// the number of the first contour that has its interior on the left already.
Index SettleLoops(Pass& pass)
{
  const Options& options = pass.Settings;
  Contours& contours = pass.Tables.Contours;
  std::vector<Problem>& mended = pass.Result.Mended;
  const bool asDrawn = options.Orient == Orientation::AsDrawn;
  RemoveRedrawn(options.RedrawnShare, asDrawn || options.Loops == LoopRule::NonZero, pass.Execute,
    contours, mended);
  if (options.Crossing != CrossingContours::Repair)
  {
    return contours.Count();
  }
  WeldBridges(options.RedrawnShare, pass.Execute, contours);
  // Where several structures meet, corners are cut off for all together.
  const bool partTouching = options.Junctions == nullptr;
  return ResolveLoops(options.Loops, asDrawn, partTouching, pass.Execute, contours, mended);
}

/// The spatial grid, and the interior on the left of each contour (sections 3 and 4).
bool OrientSlices(Pass& pass)
{
  const Options& options = pass.Settings;
  Reconstruction& result = pass.Result;
  Contours& contours = pass.Tables.Contours;
  pass.BuildGrid();
  const Index assembled = contours.Count();
  const Index firstSettled = SettleLoops(pass);
  const bool isResolved = firstSettled < contours.Count();
  OrientContours(options.Orient, options.Crossing != CrossingContours::Repair, firstSettled,
    pass.Execute, contours, result.CrossingProblems);
  if (contours.Count() < assembled || isResolved)
  {
    // A plane whose contours were all removed says nothing: it must not count as empty.
    pass.BuildGrid();
  }
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    result.ContourCount[contours.Axis[contour]] += contours.IsVirtual(contour) ? 0 : 1;
  }
  result.InsideOut = options.Orient == Orientation::AsDrawn && BoundOutside(contours);
  result.Refused = (options.Invalid != InvalidContours::LeaveOut && !result.Invalid.empty()) ||
    (options.Crossing == CrossingContours::Refuse && !result.CrossingProblems.empty());
  pass.Finish(Stage::OrientContours);
  if (result.Refused || !pass.GoOn())
  {
    return false;
  }
  if (options.InsertMissing && !result.Grid.HasVirtual())
  {
    MissingContours missing = FindMissingContours(contours, result.Grid, pass.Execute);
    AppendContours(missing.Found, contours);
    pass.Inserted = std::move(missing.Repairs);
  }
  SmoothContours(
    result.Grid, options.Smoothing, options.Patching.CornerAngle, pass.Execute, contours);
  pass.Finish(Stage::SmoothContours);
  return true;
}

}

bool ReadSlices(std::array<Pieces, 3>&& pieces, Pass& pass)
{
  return ReadContours(std::move(pieces), pass) && OrientSlices(pass);
}
}
