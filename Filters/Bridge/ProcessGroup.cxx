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

/// Bytes of each process in one call.
long long ChunkOf(std::size_t processes)
{
  return std::max(1LL, MostBytes / static_cast<long long>(processes));
}
}

/// What one call for all processes sends and receives.
struct ProcessGroup::Room
{
  std::vector<vtkIdType> Lengths, Offsets;
  Ranks::Bytes Received;
  std::vector<Ranks::Bytes> All; ///< of each process

  explicit Room(const std::vector<long long>& sizes)
    : Lengths(sizes.size())
    , Offsets(sizes.size())
    , All(sizes.size())
  {
    const long long chunk = ChunkOf(sizes.size());
    long long total = 1; // never without an address
    for (std::size_t i = 0; i < sizes.size(); ++i)
    {
      total += std::min(chunk, sizes[i]);
      this->All[i].reserve(static_cast<std::size_t>(sizes[i]));
    }
    this->Received.resize(static_cast<std::size_t>(total));
  }
};

void ProcessGroup::Require(int success)
{
  if (success == 0)
  {
    this->Left = true;
    throw ProcessFailure("The processes could not exchange data.");
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
  this->States.resize(3 * static_cast<std::size_t>(this->Processes.Count));
  this->Processes.Gather = [this](const Ranks::Bytes& own) { return this->Exchange(own, false); };
}

/// Memory for what all processes send, or none. If any of them has none, all leave.
std::unique_ptr<ProcessGroup::Room> ProcessGroup::MakeRoom(const std::vector<long long>& sizes)
{
  std::unique_ptr<Room> room;
  try
  {
    room = std::make_unique<Room>(sizes);
  }
  catch (const std::exception&) // not enough memory, or more than there can be
  {
  }
  const long long own = room != nullptr ? 1 : 0;
  const auto first = this->States.begin() + 2 * this->Processes.Count;
  this->Require(this->Controller->AllGather(&own, &*first, 1));
  const auto lacking = std::find(first, this->States.end(), 0);
  if (lacking != this->States.end())
  {
    this->Left = true;
    throw ProcessFailure("Process " + std::to_string(lacking - first) +
      ": has not enough memory for what the processes exchange.");
  }
  return room;
}

/// The bytes of all processes, of which the sizes are known. Once there is room for them, nothing is
/// allocated any more, so that none leaves between two calls for all.
std::vector<Ranks::Bytes> ProcessGroup::ExchangeBytes(
  const Ranks::Bytes& own, const std::vector<long long>& sizes)
{
  const long long most = *std::max_element(sizes.begin(), sizes.end());
  if (most == 0)
  {
    return std::vector<Ranks::Bytes>(sizes.size());
  }
  const std::unique_ptr<Room> room = this->MakeRoom(sizes);
  const long long chunk = ChunkOf(sizes.size());
  for (long long done = 0; done < most; done += chunk)
  {
    vtkIdType total = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i)
    {
      room->Lengths[i] = static_cast<vtkIdType>(std::min(chunk, std::max(0LL, sizes[i] - done)));
      room->Offsets[i] = total;
      total += room->Lengths[i];
    }
    const vtkIdType length = room->Lengths[this->Processes.Rank];
    const char* from = length > 0 ? own.data() + done : room->Received.data();
    this->Require(this->Controller->AllGatherV(
      from, room->Received.data(), length, room->Lengths.data(), room->Offsets.data()));
    for (std::size_t i = 0; i < sizes.size(); ++i)
    {
      const auto first = room->Received.begin() + room->Offsets[i];
      room->All[i].insert(room->All[i].end(), first, first + room->Lengths[i]);
    }
  }
  return std::move(room->All);
}

/// The bytes of all processes. If any has failed, these are its reasons: then throws ProcessFailure.
std::vector<Ranks::Bytes> ProcessGroup::Exchange(const Ranks::Bytes& own, bool failed)
{
  const std::size_t count = static_cast<std::size_t>(this->Processes.Count);
  const long long mine[2] = { static_cast<long long>(own.size()), failed ? 1 : 0 };
  std::vector<long long>& states = this->States;
  std::vector<long long> sizes(count);
  this->Require(this->Controller->AllGather(mine, states.data(), 2));
  bool anyFailed = false;
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
  catch (...)
  {
    // The others have heard of it, which is what was wanted, or cannot be told.
    this->Left = true;
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
