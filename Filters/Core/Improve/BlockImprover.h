// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesBlockImprover_h
#define OrthoSlicesBlockImprover_h

#include "Core/Improve/OperationFinder.h"

#include <vector>

namespace orthoslices
{
/// What is done to all blocks first, and then to what is left.
enum class Round : std::uint8_t
{
  First, ///< flips, collapses and moves, the worst triangles first
  Last   ///< the same by larger tolerances, and splits where that fails
};

/// Does in a block what MeshImprover is for, around triangles that have nothing frozen around them:
/// one operation after another.
class BlockImprover
{
public:
  /// The block gets so many new triangles at most. Samples are those of the whole surface.
  BlockImprover(const SpatialGrid& grid, const ImprovementLimits& limits, std::size_t mostNew,
    MeshBlock& block, const SurfaceSamples& samples);

  /// Begins with the triangles that have not been tried, which it takes by their numbers in the
  /// whole.
  void Run(Round round, const std::vector<std::uint8_t>& tried);

  /// The samples of the block.
  const SurfaceSamples& Samples() const { return this->State.Samples; }

  /// Whether a triangle that is there, or anything beside it, has changed.
  bool HasChanged(Index triangle) const { return this->LastTouch(triangle) > AtFirst; }
  /// Whether a point may have.
  bool HasMoved(Index point) const { return this->TouchedAt[point] > AtFirst; }
  /// Whether a triangle is to be looked at once more, where the block is another one: it has changed,
  /// and something around it is frozen, or nothing helped it, but what would have left the block
  /// might.
  bool IsOpen(Index triangle) const
  {
    return this->Block.IsFree(triangle) ? this->CutShort[triangle] != 0
                                        : this->HasChanged(triangle);
  }

  /// Triangles of less quality are to be improved.
  static double WantedQuality(const ImprovementLimits& limits, Round round);

private:
  void RunFirst();
  void RunLast();
  void Unfold();
  bool Unfold(Index triangle);
  bool Lift(Index triangle);
  void RunBelow(double quality, Means means);
  std::vector<Index> ListWorse(double quality, Means means);
  Index LastTouch(Index triangle) const;
  bool MayHelp(Index triangle, Means means) const;
  void Improve(Index triangle, Means means);
  void Apply(const LocalOperation& operation);
  void ApplySplit(const LocalOperation& operation);
  void Touch(Index point);
  void Note(Index triangle);
  void Want(Index triangle);
  void ForgetFailures();

  ImprovementLimits Limits;
  std::size_t MostNew;
  double Bad = 0.0; ///< WantedQuality
  const MeshBlock& Block;
  ImprovableMesh& Mesh; ///< that of the block
  ImprovementState State;
  OperationFinder Finder;
  LocalOperation Found;
  static constexpr Index AtFirst = 1;
  Index Now = AtFirst;          ///< counts operations
  std::vector<Index> TouchedAt; ///< of each point: the last operation beside it
  /// Of each triangle: when nothing helped it, by Means.
  std::vector<std::array<Index, MeansCount>> FailedAt;
  /// Of each triangle: whether what might help it would leave the block.
  std::vector<std::uint8_t> CutShort;
  Index Listed = 0;            ///< counts lists of open triangles
  std::vector<Index> ListedAt; ///< of each triangle: the last one that it is in
  std::vector<Index> Open;     ///< triangles to be looked at
  std::vector<std::uint8_t> IsWanted;
  std::vector<Index> Wanted; ///< triangles that have been to be looked at
  std::vector<Index> Asked;  ///< free triangles that are to be looked at for folds
  std::size_t TrianglesAtFirst;
};
}

#endif
