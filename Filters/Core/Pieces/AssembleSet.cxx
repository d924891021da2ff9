// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/AssembleSet.h"

#include "Core/Pieces/AddLoop.h"
#include "Core/Pieces/JoinPieces.h"
#include "Core/Pieces/PiecePlanes.h"
#include "Core/Pieces/TrimOverrun.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// A piece whose ends are near to each other may have run past its start by this share of its
/// length. If it crosses itself farther from its ends, it is a figure eight, and both parts of it
/// count.
constexpr double OverrunOfComplete = 0.15;

/// Makes contours of the pieces of one axis.
class SetAssembler
{
public:
  SetAssembler(
    Pieces&& pieces, const AssembleSettings& settings, Contours& contours, PieceProblems& problems)
    : Input(std::move(pieces))
    , Settings(settings)
    , Output(contours)
    , Problems(problems)
    , Usable(Input.Count(), 1)
  {
  }

  /// Appends the contours that need nothing. With Mend, returns the others that may be mended.
  std::vector<OpenCurve> Run(const Execution& execution);

private:
  Index First(Index piece) const { return this->Input.Offsets[piece]; }
  Index Last(Index piece) const { return this->Input.Offsets[piece + 1] - 1; }
  Point3 World(Index vertex) const;
  void Report(ProblemKind kind, Index piece, Index vertex, double size);
  std::vector<Problem>& Unusable()
  {
    return this->Settings.Mend ? this->Problems.Mended : this->Problems.Unusable;
  }

  void RejectNotFinite();
  bool IsComplete(Index piece) const;
  void AddContour(const PieceChains& chains, Index chain);
  void AddVertices(const PieceChains::Link& link);
  void AddVertex(Index vertex);
  bool FinishContour(Index piece);
  double LengthOf(Index piece) const;
  bool TreatOpen(const PieceChains& chains, Index chain, OpenCurve& curve);
  void ReportShift(const PieceChains& chains, Index chain);
  bool CopyCurve(const PieceChains& chains, Index chain, OpenCurve& curve);

  Pieces Input;
  const AssembleSettings& Settings;
  Contours& Output;
  PieceProblems& Problems;
  std::vector<std::uint8_t> Usable; ///< of the pieces
  std::vector<PlaneShift> Shifts;   ///< of the pieces; empty if none was moved
  double CurrentW = 0.0;            ///< plane of the contour that is being built
  Index OffPlaneVertex = -1;        ///< its first vertex that is farther from it than the tolerance
};

Point3 SetAssembler::World(Index vertex) const
{
  Point3 point;
  point[this->Input.Axis] = this->Input.W[vertex];
  point[FirstAxis(this->Input.Axis)] = this->Input.U[vertex];
  point[SecondAxis(this->Input.Axis)] = this->Input.V[vertex];
  return point;
}

/// Reports a contour that is not there.
void SetAssembler::Report(ProblemKind kind, Index piece, Index vertex, double size)
{
  this->Unusable().push_back(
    { kind, this->Input.Axis, this->Input.Cell[piece], this->World(vertex), size, true });
}

void SetAssembler::RejectNotFinite()
{
  for (Index piece = 0; piece < this->Input.Count(); ++piece)
  {
    for (Index i = this->First(piece); i <= this->Last(piece); ++i)
    {
      if (!std::isfinite(this->Input.U[i] + this->Input.V[i] + this->Input.W[i]))
      {
        this->Report(ProblemKind::NotFinite, piece, i, 0.0);
        this->Usable[piece] = 0;
        break;
      }
    }
  }
}

/// Whether a piece with two loose ends is a polyline that does not repeat its first point.
bool SetAssembler::IsComplete(Index piece) const
{
  const auto distance = [this](Index a, Index b)
  { return Length(this->World(b) - this->World(a)); };
  if (this->Last(piece) - this->First(piece) < 2)
  {
    return false;
  }
  double longest = 0.0;
  for (Index i = this->First(piece); i < this->Last(piece); ++i)
  {
    longest = std::max(longest, distance(i, i + 1));
  }
  return distance(this->First(piece), this->Last(piece)) <= 2.0 * longest;
}

void SetAssembler::AddVertices(const PieceChains::Link& link)
{
  const Index first = this->First(link.Piece);
  const Index last = this->Last(link.Piece);
  for (Index i = first; i <= last; ++i)
  {
    this->AddVertex(link.IsForward ? i : last - (i - first));
  }
}

void SetAssembler::AddVertex(Index vertex)
{
  const bool begins = static_cast<Index>(this->Output.U.size()) == this->Output.Offsets.back();
  if (begins)
  {
    this->CurrentW = this->Input.W[vertex];
    this->OffPlaneVertex = -1;
  }
  if (std::abs(this->Input.W[vertex] - this->CurrentW) > this->Settings.Tolerance)
  {
    this->OffPlaneVertex = this->OffPlaneVertex < 0 ? vertex : this->OffPlaneVertex;
  }
  AddPoint(this->Input.U[vertex], this->Input.V[vertex], this->Output);
}

/// The vertices of a contour of several pieces lie on the plane of the first one.
void SetAssembler::AddContour(const PieceChains& chains, Index chain)
{
  for (Index i = chains.Offsets[chain]; i < chains.Offsets[chain + 1]; ++i)
  {
    this->AddVertices(chains.Links[i]);
  }
  if (this->FinishContour(chains.Links[chains.Offsets[chain]].Piece))
  {
    this->ReportShift(chains, chain);
  }
}

/// Ends the contour, which is named after one of its pieces. Returns whether it is one.
bool SetAssembler::FinishContour(Index piece)
{
  if (this->OffPlaneVertex >= 0)
  {
    this->Report(ProblemKind::OffPlane, piece, this->OffPlaneVertex,
      std::abs(this->Input.W[this->OffPlaneVertex] - this->CurrentW));
    DropLoop(this->Output);
    return false;
  }
  const LoopState state = CheckLoop(this->Settings.Mend, this->Settings.Tolerance, this->Output);
  if (state != LoopState::Good)
  {
    if (this->Settings.Mend)
    {
      this->Report(state == LoopState::Flat ? ProblemKind::Flat : ProblemKind::TooShort, piece,
        this->First(piece), this->LengthOf(piece));
    }
    DropLoop(this->Output);
    return false;
  }
  this->Output.Offsets.push_back(static_cast<Index>(this->Output.U.size()));
  this->Output.Axis.push_back(static_cast<std::int8_t>(this->Input.Axis));
  this->Output.Coordinate.push_back(this->CurrentW);
  this->Output.Cell.push_back(this->Input.Cell[piece]);
  if (!this->Input.Virtual.empty() || !this->Output.Virtual.empty())
  {
    this->Output.Virtual.resize(this->Output.Axis.size(), 0);
    this->Output.Virtual.back() = this->Input.IsVirtual(piece) ? 1 : 0;
  }
  return true;
}

double SetAssembler::LengthOf(Index piece) const
{
  double length = 0.0;
  for (Index i = this->First(piece); i < this->Last(piece); ++i)
  {
    length += Length(this->World(i + 1) - this->World(i));
  }
  return length;
}

/// Reports the vertex that was moved farthest, if the tolerance does not allow it to be where it
/// was.
void SetAssembler::ReportShift(const PieceChains& chains, Index chain)
{
  PlaneShift farthest;
  Index ofPiece = -1;
  for (Index i = chains.Offsets[chain]; i < chains.Offsets[chain + 1] && !this->Shifts.empty(); ++i)
  {
    const Index piece = chains.Links[i].Piece;
    if (this->Shifts[piece].Distance > std::max(farthest.Distance, this->Settings.Tolerance))
    {
      farthest = this->Shifts[piece];
      ofPiece = piece;
    }
  }
  if (ofPiece >= 0)
  {
    Point3 where = this->World(farthest.Vertex);
    where[this->Input.Axis] = farthest.From;
    this->Problems.Mended.push_back({ ProblemKind::MovedOntoPlane, this->Input.Axis,
      this->Input.Cell[ofPiece], where, farthest.Distance });
  }
}

/// The curve of an open chain. False if it leaves its plane.
bool SetAssembler::CopyCurve(const PieceChains& chains, Index chain, OpenCurve& curve)
{
  const Index piece = chains.Links[chains.Offsets[chain]].Piece;
  curve.Axis = this->Input.Axis;
  curve.Cell = this->Input.Cell[piece];
  // Where contours are collected there is room for one more. A single piece runs as it was drawn:
  // open chains begin with an end that was found last.
  const std::size_t begin = this->Output.U.size();
  for (Index i = chains.Offsets[chain + 1]; i-- > chains.Offsets[chain];)
  {
    this->AddVertices({ chains.Links[i].Piece, !chains.Links[i].IsForward });
  }
  curve.Plane = this->CurrentW;
  for (std::size_t i = begin; i < this->Output.U.size(); ++i)
  {
    curve.Points.push_back({ this->Output.U[i], this->Output.V[i] });
  }
  DropLoop(this->Output);
  if (this->OffPlaneVertex >= 0)
  {
    this->Report(ProblemKind::OffPlane, piece, this->OffPlaneVertex,
      std::abs(this->Input.W[this->OffPlaneVertex] - this->CurrentW));
    return false;
  }
  return true;
}

/// Closes an open chain, or says that it is open. With Mend, returns true if that is still to be
/// done, and the curve.
bool SetAssembler::TreatOpen(const PieceChains& chains, Index chain, OpenCurve& curve)
{
  const PieceChains::Link& first = chains.Links[chains.Offsets[chain]];
  const bool isComplete = chains.IsSingle(chain) && this->IsComplete(first.Piece);
  if (this->Settings.Mend)
  {
    if (!this->CopyCurve(chains, chain, curve))
    {
      return false;
    }
    const double length = curve.Length();
    const bool isTrimmed = TrimOverrun(curve);
    if (!isComplete || (isTrimmed && curve.Trimmed <= OverrunOfComplete * length))
    {
      this->ReportShift(chains, chain);
      return true;
    }
  }
  if (isComplete)
  {
    this->AddContour(chains, chain);
    return false;
  }
  const Index last = chains.Links[chains.Offsets[chain + 1] - 1].Piece;
  const bool lastIsForward = chains.Links[chains.Offsets[chain + 1] - 1].IsForward;
  const Index end = first.IsForward ? this->First(first.Piece) : this->Last(first.Piece);
  const Index other = lastIsForward ? this->Last(last) : this->First(last);
  this->Report(ProblemKind::Open, first.Piece, end, Length(this->World(other) - this->World(end)));
  return false;
}

std::vector<OpenCurve> SetAssembler::Run(const Execution& execution)
{
  this->RejectNotFinite();
  if (this->Settings.Mend)
  {
    this->Shifts =
      MoveOntoPlanes(this->Settings.Tolerance, this->Settings.AloneTolerance, this->Input);
  }
  this->Output.U.reserve(this->Output.U.size() + this->Input.U.size());
  this->Output.V.reserve(this->Output.V.size() + this->Input.V.size());
  const PieceChains chains = JoinPieces(this->Input, this->Usable, this->Settings.Tolerance);
  std::vector<OpenCurve> curves;
  ForInOrder(execution, static_cast<std::size_t>(chains.Count()),
    [&](std::size_t number)
    {
      const Index chain = static_cast<Index>(number);
      OpenCurve curve;
      if (chains.Closed[chain])
      {
        this->AddContour(chains, chain);
      }
      else if (this->TreatOpen(chains, chain, curve))
      {
        curves.push_back(std::move(curve));
      }
    });
  return curves;
}
}

std::vector<OpenCurve> AssembleSet(Pieces&& pieces, const AssembleSettings& settings,
  Contours& contours, PieceProblems& problems, const Execution& execution)
{
  return SetAssembler(std::move(pieces), settings, contours, problems).Run(execution);
}
}
