// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesProcessGroup_h
#define OrthoSlicesProcessGroup_h

#include "Core/Base/Ranks.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

class vtkInformation;
class vtkMultiProcessController;

namespace orthoslices
{
/// Why this process cannot go on: another one, or itself, has failed or was aborted.
struct ProcessFailure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/**
 * The processes of a parallel run in which a filter works, one piece each, on VTK's controller.
 *
 * Every exchange begins with the state of each process, and with whether each has the memory for
 * what comes. One that fails or is aborted says so in the place of its next exchange, with Fail();
 * then all others leave their work with ProcessFailure and exchange nothing any more. As all
 * processes pass the same exchanges, and Finish() at the end, none waits for one that has gone.
 */
class ProcessGroup
{
public:
  /// Those of a controller, or one process alone if it is null or the request is not that of the
  /// process's own piece of as many as there are processes.
  ProcessGroup(vtkMultiProcessController* controller, vtkInformation* request);
  ProcessGroup(const ProcessGroup&) = delete;
  void operator=(const ProcessGroup&) = delete;

  const Ranks& GetRanks() const { return this->Processes; }
  bool IsParallel() const { return this->Processes.AreSeveral(); }
  bool IsFirst() const { return this->Processes.Rank == 0; }

  /// This process leaves its work: tells all others why.
  void Fail(const std::string& why);
  /// All has been done, here and everywhere; else throws ProcessFailure.
  void Finish();

private:
  struct Room;

  void Require(int success);
  std::unique_ptr<Room> MakeRoom(const std::vector<long long>& sizes);
  std::vector<Ranks::Bytes> Exchange(const Ranks::Bytes& own, bool failed);
  std::vector<Ranks::Bytes> ExchangeBytes(
    const Ranks::Bytes& own, const std::vector<long long>& sizes);

  vtkMultiProcessController* Controller = nullptr;
  Ranks Processes;
  /// What all processes say of an exchange: two numbers of each, then one of each.
  std::vector<long long> States;
  bool Left = false; ///< nothing is exchanged any more
};
}

#endif
