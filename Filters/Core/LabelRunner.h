// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLabelRunner_h
#define OrthoSlicesLabelRunner_h

#include "Core/Labels/ShareBorders.h"
#include "Core/Pass.h"
#include "Core/Patches/SharedPatches.h"
#include "Core/ReconstructLabels.h"
#include "Core/SparseStructure.h"

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace orthoslices
{
/// How much of the progress reading takes, and, where slices are sparse, reading and first
/// surfaces.
constexpr double ProgressOfReading = 0.2;
constexpr double ProgressOfDrawing = 0.5;

/// Where triangles are to be few, how much all takes until they are improved.
constexpr double ProgressOfFilling = 0.75;

/// A label that is within another one to that much of its area is meant to be.
constexpr double MostOverlap = 0.98;

/// The stages of one label, and what has to outlive them.
struct LabelPass
{
  LabelPass(const Options& options, const Execution& whole)
    : Execute(whole)
    , Stages(options, this->Execute, this->Observe)
  {
    this->Execute.Continue = [this, &whole](double progress)
    { return whole.Continue(this->From + (this->To - this->From) * progress); };
  }
  LabelPass(const LabelPass&) = delete;
  void operator=(const LabelPass&) = delete;

  /// From here on its progress is that part of what is between two values, of the whole.
  void SetProgress(double from, double to, std::size_t part, std::size_t parts)
  {
    const double share = (to - from) / static_cast<double>(parts);
    this->From = from + share * static_cast<double>(part);
    this->To = this->From + share;
  }

  Execution Execute;
  StageObserver Observe;
  Pass Stages;
  bool IsRead = false; ///< not refused, and there are contours
  Index Separated = 0; ///< components more than before common cells were settled
  std::unique_ptr<SparseStructure> Sparse;
  /// What is to be said of the slices as they were before labels were made to agree on them, if so.
  std::unique_ptr<Reconstruction> AsDrawn;

private:
  double From = 0.0, To = 1.0;
};

/// Runs the stages of all labels; see ReconstructLabels.
class LabelRunner
{
public:
  LabelRunner(
    std::vector<SortedSlices>& labels, const Options& options, const Execution& execution);

  /// False: stopped.
  bool Run();
  std::vector<Reconstruction> TakeResults();
  std::vector<LabelOverlap> FindOverlaps() const;
  std::vector<LabelLoss> FindLosses() const;
  CommonCellCounts Counts;

private:
  /// Labels that slices lack, by axis and coordinate.
  using LackingLabels = std::map<std::pair<int, double>, std::vector<Index>>;

  bool Read();
  bool DoAnyMeet() const;
  std::vector<Contours*> ListContours();
  bool IsAnyInsideOut() const;
  void RemoveInserted();
  void AddMissing();
  void ShareTolerance();
  bool ShareContours();
  void SettleEnds();
  void TakeBorders(SharedBorders&& shared);
  LackingLabels ListLacking() const;
  static std::vector<std::uint8_t> FindAlone(
    const LackingLabels& lacking, const Contours& contours);
  bool CutUnion(const VirtualPlanes& planes, std::vector<Contours>& cuts);
  static void RemoveThinHoles(double thickness, Contours& contours);
  bool FillLacking();
  void AddInserted(Index label, const Contours& found);
  StructureSets FindOverlapping() const;
  SetReplacements FindContradicted();
  void BuildGrids();
  bool FindLacking(const LabelPass& label, VirtualPlanes& lacking) const;
  bool DoSlicesContradict(VirtualPlanes& lacking);
  bool KeepReports();
  void ForgetReports();
  bool VoteTogether(const VirtualPlanes& ofVirtual, const std::vector<Contours*>& labels);
  bool RedrawEach();
  bool AgreeOnSlices();
  bool IsStopped() const;
  void TakeReports();
  void FindPlanes();
  void AddPlanes(const VirtualPlanes& planes);
  SliceDensity Density() const;
  SpatialGrid CommonGrid(const std::vector<Pass*>& passes) const;
  void KeepReport(Pass& drawn);
  void MendSlices(const SpatialGrid& grid, std::vector<Contours>& labels);
  bool DrawEach(const std::vector<Pass*>& passes, std::vector<Contours>& drawn);
  bool DrawGraphs(const std::vector<Pass*>& passes);
  bool MakeEach();
  bool MakeDense();
  bool MakeSparse(const SliceDensity& density);
  VirtualPlanes ListVirtualPlanes(const std::vector<LabelPass*>& passes) const;
  bool FinishSparse(const std::vector<LabelPass*>& passes);
  bool FollowsField(const SliceDensity& density, LabelPass& all);
  LabelPass& AddUnion();
  void MoveOffVertices(const SpatialGrid& grid, VirtualPlanes& planes) const;
  VirtualPlanes PlanesFor(const SpatialGrid& grid, const VirtualPlanes& common) const;
  void ShareVirtual(const std::vector<LabelPass*>& passes, bool withUnion);
  std::vector<StructureSurface> ListSurfaces();
  void SettleCells();
  double EndOfFilling() const;
  void ImproveTriangles();
  std::vector<Index> ListRead() const;
  double Thickness() const;
  void AddJunctions(const std::set<Point3>& junctions);
  /// Points as they are in contours that were rounded to multiples of a quantum, if it is not 0.
  static std::set<Point3> RoundAll(const std::set<Point3>& points, double quantum);

  std::vector<SortedSlices>& Labels;
  Options Settings;
  const Execution& Execute;
  SharedPatches Shared;
  std::deque<LabelPass> Passes; ///< of the labels, and of their union
  SharedBorders Borders;
  std::set<Point3> Junctions;
  std::array<std::vector<double>, 3> Planes;        ///< of all labels
  EmptyPlanes WhichPlanes = EmptyPlanes::NotPassed; ///< of these, on which a label is not drawn
  double Accuracy = 0.0; ///< of surfaces with few triangles, in spacings; 0: all triangles
  std::array<std::set<double>, 3> Filled; ///< planes with contours of labels that were lacking
};
}

#endif
