// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPassProgress_h
#define OrthoSlicesPassProgress_h

#include "Core/Base/Execution.h"
#include "Core/Stage.h"
#include "Core/StageShares.h"

#include <memory>

namespace orthoslices
{
/**
 * How far one pass of the stages is in the progress of the whole, by the work that is done: each
 * stage has a share, see StageShares, and within it each of its loops has one. Progress never goes
 * back: after an attempt that failed it stays until the next one has come as far.
 */
class PassProgress
{
public:
  /// Progress goes to the execution's Continue, which has to outlive this.
  explicit PassProgress(const Execution& execution)
    : Execute(execution)
  {
  }

  /// Is part of the same whole as another pass.
  void ShareWhole(const PassProgress& other) { this->Furthest = other.Furthest; }

  /// Where what comes next begins and ends in the progress of the whole, 0 to 1: the stages that
  /// are left, or work that is none of a stage.
  void SetShare(double from, double to);

  /// That share of what is between the values of SetShare is done. Asks whether to go on.
  bool GoOn(double share);
  /// All stages up to the one that was finished last are done. Asks whether to go on.
  bool GoOn() { return this->GoOn(this->ShareOfStages(this->Begin)); }

  /// A stage is done. The words for what comes next go to the execution's Announce.
  void Finish(Stage stage, const StageShares& shares);

  /// Takes how many items of a loop are done: see Execution::Watcher. Throws Stopped if the caller
  /// does not want to go on.
  void Advance(std::size_t done, std::size_t count);

private:
  /// Progress of the stages, of which SetShare may have been called in the middle, to one of what
  /// is between its values.
  double ShareOfStages(double progress) const
  {
    return this->First < 1.0 ? (progress - this->First) / (1.0 - this->First) : 0.0;
  }

  const Execution& Execute;
  std::shared_ptr<double> Furthest = std::make_shared<double>(0.0); ///< of all passes
  double From = 0.0, To = 1.0; ///< the share in the whole of what is at work
  double First = 0.0;          ///< of the stages were done when it began
  Stage Current = Stage::AssembleContours;
  double Begin = 0.0, End = 0.0; ///< of the current stage, 0 to 1 in those of a pass
  LoopShares Loops;              ///< of the current stage
  std::size_t Loop = 0;          ///< its number in the stage, from 1
};
}

#endif
