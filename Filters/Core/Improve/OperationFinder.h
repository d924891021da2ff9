// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesOperationFinder_h
#define OrthoSlicesOperationFinder_h

#include "Core/Improve/ImprovementState.h"

#include <vector>

namespace orthoslices
{
/// The least that an operation gains, as a factor of the squared sine: so that none is done for
/// nothing.
constexpr double LeastGain = 1.02;

/// Quality beyond which none is better than another one: 35 degrees.
constexpr double GoodEnough = 0.33;

/// A change of a surface beside one point or side.
struct LocalOperation
{
  enum class Kind : std::uint8_t
  {
    None,
    Flip,
    Collapse,
    Move,
    Split
  };
  Kind What = Kind::None;
  Index Corner = -1; ///< the corner opposite to the edge that is flipped, collapses or is split
  Index Point = -1;  ///< that is moved
  Point3 Place{};    ///< and where it goes, or where the new one will be
  double Quality = 0.0;
  /// Of a split: the sides around the new point, as their corners, and those that are flipped to
  /// it.
  std::vector<Index> Sides{}, Flipped{};
  SurfaceChange Change{};
};

/// What may be tried to improve a triangle.
enum class Means : std::uint8_t
{
  SameShape, ///< flips and collapses
  Moves,     ///< and moves
  Splits,    ///< and splits where all that fails
  Beside     ///< and, before splits, what changes a corner in another way than by its own sides
};

/// How many there are.
constexpr std::size_t MeansCount = 4;

/**
 * Finds what improves a triangle most: the operation that makes the smallest angle of the triangles
 * that it changes the greatest, of those that keep the surface near its samples, do not fold it and
 * do not let triangles meet. Several may look at one surface at the same time.
 */
class OperationFinder
{
public:
  explicit OperationFinder(const ImprovementState& state)
    : State(state)
    , Guard(state.Mesh.Corners, state.Mesh.Points, state.Boxes, state.Mesh.Borders)
  {
  }

  /// False if there is none.
  bool Find(Index triangle, Means means, LocalOperation& found);

  /// Finds what opens the fold at a corner's edge most. Triangles may turn as they like, but get no
  /// small angles. False if there is none.
  bool FindUnfolding(Index corner, LocalOperation& found);

  /// Finds how the ends of a corner's edge, which is short, become one point; whatever fold that
  /// makes was nearly there before, with that edge as its rim. False if they cannot.
  bool FindMerge(Index corner, LocalOperation& found);

  /// Finds how far a point that is pressed onto a plane of the grid may move away from it. False if
  /// it is not, or cannot.
  bool FindLift(Index point, LocalOperation& found);

  /// Whether something that might have helped was left out, when it was looked for last, as it would
  /// have left the block.
  bool WasCutShort() const { return this->IsCutShort; }

private:
  /// An operation that opens a fold so far.
  struct Unfolding
  {
    LocalOperation Operation;
    double Cosine; ///< see FoldChange
  };

  LocalOperation FindBest(Index triangle, Means means);
  void TryFlips(Index triangle, LocalOperation& best);
  void TryFlip(Index corner, LocalOperation& best) const;
  void TryCollapse(Index corner, LocalOperation& best);
  void TryMove(Index point, LocalOperation& best);
  void TryBeside(Index triangle, LocalOperation& best);
  void TrySplits(Index triangle, LocalOperation& best);
  void TrySplit(Index corner, double share, LocalOperation& best);
  std::array<std::pair<double, Index>, 3> SidesOf(Index triangle) const;
  bool MayMove(Index corner) const;
  void SpanCavity(Index corner);
  void WidenCavity(const Point3& place);
  bool IsCavitySimple() const;
  PointStar& StarOf(Index point);
  bool IsNear(const PointStar& star) const;
  bool StaysInside();
  bool IsAllowed(const LocalOperation& operation, bool mayFold = false);
  void Describe(const LocalOperation& operation);
  void ListUnfolding(Index corner);
  void AddUnfolding(LocalOperation operation);
  void AddFlip(Index corner);
  bool MayMerge(Index corner, double shareOfQuality);
  void AddCollapse(Index corner);
  void AddMoves(Index point, const Point3& across);
  void DescribeStar(Index point, Index gone, Index becomes);
  bool WasRefused(const LocalOperation& operation) const;

  const ImprovementState& State;
  CrossingGuard Guard;
  std::array<PointStar, 3> Stars; ///< of the corners of the triangle that is looked at
  SurfaceChange Change;           ///< that is asked for
  std::vector<LocalOperation> Refused;
  std::vector<Index> Cavity, Flipped; ///< see LocalOperation, of a split that is looked at
  std::vector<Unfolding> Unfoldings;  ///< that are looked at
  bool IsCutShort = false;
};
}

#endif
