// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/PassProgress.h"

#include <algorithm>

namespace orthoslices
{
void PassProgress::SetShare(double from, double to)
{
  this->From = from;
  this->To = to;
  this->First = this->Begin;
}

bool PassProgress::GoOn(double share)
{
  double& furthest = *this->Furthest;
  furthest = std::max(furthest, this->From + (this->To - this->From) * share);
  return this->Execute.Continue(furthest);
}

void PassProgress::Finish(Stage stage, const StageShares& shares)
{
  this->Begin = shares.EndOf(stage);
  if (this->Begin < this->First) // stages are run once more
  {
    this->First = this->Begin;
  }
  this->End = this->Begin;
  this->Loop = 0;
  if (stage != Stage::ImproveSurface)
  {
    this->Current = static_cast<Stage>(static_cast<int>(stage) + 1);
    this->End = shares.EndOf(this->Current);
    this->Loops = shares.LoopsOf(this->Current);
    this->Execute.Announce(TextOf(this->Current));
  }
}

void PassProgress::Advance(std::size_t done, std::size_t count)
{
  this->Loop += done == 0 ? 1 : 0;
  const double first = this->Loops.StartOf(this->Loop - 1);
  const double last = this->Loops.StartOf(this->Loop);
  const double ofStage = first + (last - first) * static_cast<double>(done) / count;
  const double progress = this->Begin + (this->End - this->Begin) * ofStage;
  if (!this->GoOn(this->ShareOfStages(progress)))
  {
    throw Stopped();
  }
}
}
