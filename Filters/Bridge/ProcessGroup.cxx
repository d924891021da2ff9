// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/ProcessGroup.h"

#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// What all processes send in one call together: MPI counts in int.
constexpr long long MostBytes = 1LL << 30;

void Require(int success)
{
  if (success == 0)
  {
    throw ProcessFailure("The processes could not exchange data.");
  }
}
}

ProcessGroup::ProcessGroup(vtkMultiProcessController* controller, vtkInformation* request)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (controller == nullptr || controller->GetNumberOfProcesses() < 2 ||
    request->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) != controller->GetNumberOfProcesses() ||
    request->Get(Pipeline::UPDATE_PIECE_NUMBER()) != controller->GetLocalProcessId())
  {
    return;
  }
  this->Controller = controller;
  this->Processes.Rank = controller->GetLocalProcessId();
  this->Processes.Count = controller->GetNumberOfProcesses();
  this->Processes.Gather = [this](const Ranks::Bytes& own) { return this->Exchange(own, false); };
}

/// The bytes of all processes, of which the sizes are known.
std::vector<Ranks::Bytes> ProcessGroup::ExchangeBytes(
  const Ranks::Bytes& own, const std::vector<long long>& sizes)
{
  const std::size_t count = sizes.size();
  std::vector<Ranks::Bytes> all(count);
  const long long chunk = std::max(1LL, MostBytes / static_cast<long long>(count));
  const long long most = *std::max_element(sizes.begin(), sizes.end());
  Ranks::Bytes received;
  for (long long done = 0; done < most; done += chunk)
  {
    std::vector<vtkIdType> lengths(count), offsets(count);
    vtkIdType total = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      lengths[i] = static_cast<vtkIdType>(std::min(chunk, std::max(0LL, sizes[i] - done)));
      offsets[i] = total;
      total += lengths[i];
    }
    received.resize(static_cast<std::size_t>(total) + 1); // never without an address
    const vtkIdType length = lengths[this->Processes.Rank];
    const char* from = length > 0 ? own.data() + done : received.data();
    Require(
      this->Controller->AllGatherV(from, received.data(), length, lengths.data(), offsets.data()));
    for (std::size_t i = 0; i < count; ++i)
    {
      all[i].insert(
        all[i].end(), received.begin() + offsets[i], received.begin() + offsets[i] + lengths[i]);
    }
  }
  return all;
}

/// The bytes of all processes. If any has failed, these are its reasons: then throws ProcessFailure.
std::vector<Ranks::Bytes> ProcessGroup::Exchange(const Ranks::Bytes& own, bool failed)
{
  const std::size_t count = static_cast<std::size_t>(this->Processes.Count);
  const long long mine[2] = { static_cast<long long>(own.size()), failed ? 1 : 0 };
  std::vector<long long> states(2 * count);
  Require(this->Controller->AllGather(mine, states.data(), 2));
  bool anyFailed = false;
  std::vector<long long> sizes(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    sizes[i] = states[2 * i];
    anyFailed |= states[2 * i + 1] != 0;
  }
  if (!anyFailed)
  {
    return this->ExchangeBytes(own, sizes);
  }
  // Reasons only.
  this->Left = true;
  for (std::size_t i = 0; i < count; ++i)
  {
    sizes[i] = states[2 * i + 1] != 0 ? sizes[i] : 0;
  }
  const std::vector<Ranks::Bytes> reasons = this->ExchangeBytes(own, sizes);
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (states[2 * i + 1] != 0)
    {
      text += (text.empty() ? "Process " : " Process ") + std::to_string(i) + ": " +
        std::string(reasons[i].begin(), reasons[i].end());
    }
  }
  throw ProcessFailure(text);
}

void ProcessGroup::Fail(const std::string& why)
{
  if (!this->IsParallel() || this->Left)
  {
    return;
  }
  try
  {
    this->Exchange(Ranks::Bytes(why.begin(), why.end()), true);
  }
  catch (const ProcessFailure&)
  {
    this->Left = true; // which is what was wanted
  }
}

void ProcessGroup::Finish()
{
  if (this->IsParallel() && !this->Left)
  {
    this->Exchange({}, false);
  }
}
}
