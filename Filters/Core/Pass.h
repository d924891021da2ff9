// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPass_h
#define OrthoSlicesPass_h

#include "Core/Base/Execution.h"
#include "Core/Options.h"
#include "Core/PassProgress.h"
#include "Core/Reconstruction.h"
#include "Core/Slices/EmptyPlanes.h"
#include "Core/Stage.h"

#include <memory>
#include <vector>

namespace orthoslices
{
/**
 * One pass of the stages of Reconstruct over a set of contours: the data that go from stage to
 * stage, and what each stage has to do besides its work. Where slices are few there are several
 * passes, each over other contours of the same input.
 */
class Pass
{
public:
  Pass(const Options& options, const Execution& execution, const StageObserver& observer)
    : Settings(options)
    , Outer(execution)
    , Observe(observer)
    , Progress(std::make_shared<PassProgress>(execution))
    , Execute(Watch(execution,
        [progress = this->Progress](std::size_t done, std::size_t count)
        { progress->Advance(done, count); }))
  {
  }

  /// A pass over other contours of the same input: what the report says of the input is what the
  /// first pass found.
  Pass(const Pass& first, Contours&& contours);
  /// The same, run otherwise: such as one that is a part of another's progress.
  Pass(const Pass& first, Contours&& contours, const Execution& execution);

  /// Is called after each stage: shows the tables to the observer, and checks them if the build has
  /// invariants checked. What comes next counts as the next stage in the progress.
  void Finish(Stage stage) const;

  /// Asks whether to go on after a stage, or after a share of work that is none; see PassProgress.
  /// False: stop.
  bool GoOn();
  bool GoOn(double share);

  /// See PassProgress.
  void SetShare(double from, double to) { this->Progress->SetShare(from, to); }

  /// Lists repairs, those of virtual slices in OfVirtual.
  void Report(const std::vector<Repair>& repairs);

  /// The planes of the contours, and those of other structures; where inserted contours are in it.
  void BuildGrid();

  /// Begins anew with other contours of the same slices. What the graph of those before has shown of
  /// the input is forgotten.
  void StartAgain(Contours&& contours);

  /// Planes of other structures, for grids that are built from now on, and which of them; see
  /// AddEmptyPlanes. They have to outlive this.
  void SetOtherPlanes(
    const std::array<std::vector<double>, 3>& planes, EmptyPlanes which = EmptyPlanes::NotPassed)
  {
    this->OtherPlanes = &planes;
    this->WhichPlanes = which;
  }

  /// The slices of an only family end half a slice farther: with copies of the first and the last
  /// one, which are virtual. See CopyEndSlices.
  void AddEndSlices();

  /// Adds contours on virtual planes before anything was made of the real ones, and bounds of the
  /// surface; the report is this pass's.
  void AddVirtualSlices(const Contours& added, const Box3& bounds);

  /// Whether the report of what the slices leave open is this pass's to make.
  bool ShowsDoubts() const { return !this->Result.Grid.HasVirtual() || this->OwnsVirtual; }

  Options Settings;
  const Execution& Outer; ///< the caller's
  const StageObserver& Observe;

private:
  std::shared_ptr<PassProgress> Progress;

public:
  /// The same, but that loops count as part of the progress of the current stage, and throw Stopped
  /// if the caller does not want to go on.
  Execution Execute;
  StageTables Tables;
  std::vector<Repair> Inserted;  ///< contours that slices lack, on planes of the grid
  std::vector<Repair> OfVirtual; ///< repairs of virtual slices, of which the report says nothing
  Reconstruction Result;

private:
  void NumberInserted();

  Box3 Bounds = Everywhere(); ///< of the surface, where slices were added at its ends,
  const std::array<std::vector<double>, 3>* OtherPlanes = nullptr;
  EmptyPlanes WhichPlanes = EmptyPlanes::NotPassed;
  bool OwnsVirtual = false; ///< slices were added by this pass: else another one made the report
};
}

#endif
