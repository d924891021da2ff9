// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
// The requests of the pipeline of which several processes each do a part.
#include "vtkOrthogonalSliceReconstruction.h"

#include "Bridge/CarryFieldData.h"
#include "Bridge/GatherInputs.h"
#include "Bridge/ProcessGroup.h"
#include "Bridge/TakePiece.h"
#include "Bridge/TimeSteps.h"
#include "Core/Base/Execution.h"
#include "Core/Frames/SortByPlanes.h"

#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <new>

using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{
/// What is asked of an output for which the pipeline passes on a request.
vtkInformation* RequestOf(vtkInformation* request, vtkInformationVector* outputs)
{
  const int from = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  return outputs->GetInformationObject(from);
}

using Inputs = std::vector<vtkSmartPointer<vtkDataObject>>;

/// Gives a member a value for as long as this lives, and takes it away however that ends.
template <typename Value>
class ForNow
{
public:
  ForNow(Value& member, const Value& value)
    : Member(member)
  {
    member = value;
  }
  ~ForNow() { this->Member = Value(); }
  ForNow(const ForNow&) = delete;
  void operator=(const ForNow&) = delete;

private:
  Value& Member;
};
}

int vtkOrthogonalSliceReconstruction::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // Contours of all pieces belong together: one process needs the whole input, several exchange
  // what each of them has.
  const orthoslices::ProcessGroup group(this->Controller, RequestOf(request, outputs));
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    vtkInformation* input = inputs[port]->GetInformationObject(0);
    if (input != nullptr)
    {
      input->Set(Pipeline::UPDATE_PIECE_NUMBER(), group.GetRanks().Rank);
      input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), group.GetRanks().Count);
      input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
  return 1;
}

int vtkOrthogonalSliceReconstruction::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  orthoslices::ClearFieldData(outputs);
  orthoslices::MarkTime(this->ListInputs(), outputs);
  vtkInformation* asked = RequestOf(request, outputs);
  orthoslices::ProcessGroup group(this->Controller, asked);
  if (!group.IsParallel() && asked->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1; // without other processes, the first piece is the whole surface
  }
  const ForNow<orthoslices::ProcessGroup*> processes(this->Processes, &group);
  const ForNow<Inputs> gathered(this->GatheredInputs, {});
  return this->MakeWithOthers(outputs) ? 1 : 0;
}

/// What this process has to make of the outputs. However it ends, the others of a parallel run hear
/// of it. False, with an error and empty outputs, if they cannot be made; empty outputs without an
/// error if it was aborted.
bool vtkOrthogonalSliceReconstruction::MakeWithOthers(vtkInformationVector* outputs)
{
  orthoslices::ProcessGroup& group = *this->Processes;
  bool done = false;
  try
  {
    done = this->CheckProperties() &&
      (group.IsParallel() ? this->MakePieces(outputs) : this->MakeOutputs(outputs));
    if (this->GetAbortExecute())
    {
      throw orthoslices::Stopped(); // too late for a loop to hear of it
    }
    if (done)
    {
      group.Finish();
      return true;
    }
    group.Fail("reported an error.");
  }
  catch (const orthoslices::Stopped&)
  {
    group.Fail("aborted.");
    done = true;
  }
  catch (const std::bad_alloc&)
  {
    group.Fail("has not enough memory.");
    vtkErrorMacro("There is not enough memory for the surface of these contours.");
    done = false;
  }
  catch (const std::exception& failure)
  {
    group.Fail(failure.what());
    vtkErrorMacro(<< failure.what());
    done = false;
  }
  orthoslices::ClearOutputs(outputs);
  return done;
}

/// The piece of this process, and on the first one all other outputs.
bool vtkOrthogonalSliceReconstruction::MakePieces(vtkInformationVector* outputs)
{
  const orthoslices::Ranks& ranks = this->Processes->GetRanks();
  this->GatheredInputs = orthoslices::GatherInputs(this->ListInputs(), ranks);
  if (!this->MakeOutputs(outputs))
  {
    return false;
  }
  vtkPolyData* surface = vtkPolyData::GetData(outputs, 0);
  if (surface->GetPointData()->GetGlobalIds() == nullptr)
  {
    orthoslices::TakePiece(ranks, surface); // it could not be made in pieces
  }
  for (int port = 1; port < this->GetNumberOfOutputPorts() && ranks.Rank > 0; ++port)
  {
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
  return true;
}

/// Whether processes can make parts of the surface. Curvatures, cuts at the border of the image and
/// distances from contours on other planes are those of a whole surface.
bool vtkOrthogonalSliceReconstruction::CanBeDivided(const orthoslices::SortedSlices& sorted) const
{
  return !this->ComputeCurvatures && this->BorderContours != LEAVE_OPEN_AT_BORDER &&
    sorted.Others.Count() == 0;
}

/// Warns the user, once in a parallel run: all processes have the same to say.
void vtkOrthogonalSliceReconstruction::Warn(const std::string& text)
{
  if (this->Processes->IsFirst())
  {
    vtkWarningMacro(<< text);
  }
}
