// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/ExecuteWithVtk.h"

#include "Core/Base/Workers.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

#ifdef __linux__
#include <sched.h>
#endif

namespace orthoslices
{
namespace
{
/// Observers hear of progress after so much of it, or of seconds, whichever comes first: often
/// enough for a progress bar and for somebody who wants to abort, and seldom enough that it costs
/// nothing.
constexpr double ProgressStep = 0.002;
constexpr double SecondsBetweenEvents = 0.05;

/// Of what is left of the progress, for the next one of loops of which nobody knows the number. Of
/// about ten loops, as writing a surface has, the first then has a fifth and the last a fortieth of
/// the whole, and a tenth is left.
constexpr double ShareOfLoop = 0.2;

/// Whether somebody has asked VTK to run loops in one thread: by the environment, or because it
/// does otherwise by default.
bool IsSequentialByChoice()
{
  const char* chosen = std::getenv("VTK_SMP_BACKEND_IN_USE");
  std::string name = chosen ? chosen : "";
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return !VTK_SMP_DEFAULT_IMPLEMENTATION_SEQUENTIAL || name == "sequential";
}

/// The limit that the user has set; 0 if there is none.
int LimitOfThreads()
{
  const vtkSMPTools::Config config(vtk::detail::smp::vtkSMPToolsAPI::GetInstance());
  const char* inEnvironment = std::getenv("VTK_SMP_MAX_THREADS");
  const int most = inEnvironment ? std::atoi(inEnvironment) : 0;
  return config.MaxNumberOfThreads > 0 ? config.MaxNumberOfThreads : std::max(0, most);
}

/// The processors that this process may run on: fewer than the machine has where it is bound to
/// some of them, as ranks of a parallel ParaView are.
int CountProcessors()
{
#ifdef __linux__
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0)
  {
    return std::max(1, CPU_COUNT(&allowed));
  }
#endif
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Tells a filter's observers of progress, which never goes back.
class ProgressTeller
{
public:
  explicit ProgressTeller(vtkAlgorithm* filter)
    : Filter(filter)
  {
  }

  /// False if somebody has asked to abort.
  bool Tell(double progress)
  {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - this->Last;
    this->Furthest = std::max(this->Furthest, progress);
    if (this->Furthest >= this->Told + ProgressStep || passed.count() >= SecondsBetweenEvents)
    {
      this->Filter->UpdateProgress(this->Furthest);
      this->Told = this->Furthest;
      this->Last = now;
    }
    return !this->Filter->GetAbortExecute();
  }

private:
  vtkAlgorithm* Filter;
  double Furthest = 0.0;
  double Told = 0.0;
  std::chrono::steady_clock::time_point Last = std::chrono::steady_clock::now();
};
}

int NumberOfThreads()
{
  if (vtkSMPTools::IsParallelScope())
  {
    return 1;
  }
  if (std::string(vtkSMPTools::GetBackend()) != "Sequential")
  {
    return std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
  }
  if (IsSequentialByChoice())
  {
    return 1;
  }
  const int limit = LimitOfThreads();
  return limit > 0 ? std::min(limit, CountProcessors()) : CountProcessors();
}

Execution ExecuteWithVtk(vtkAlgorithm* filter)
{
  Execution execution = ExecuteOnThreads(NumberOfThreads());
  execution.Continue = [teller = std::make_shared<ProgressTeller>(filter)](double progress)
  { return teller->Tell(progress); };
  execution.Announce = [filter](const char* text) { filter->SetProgressText(text); };
  return execution;
}

Execution ExecuteLoop(vtkAlgorithm* filter, double firstProgress, double lastProgress)
{
  const Execution execution = ExecuteWithVtk(filter);
  return Watch(execution,
    [goOn = execution.Continue, firstProgress, lastProgress](std::size_t done, std::size_t count)
    {
      const double share = static_cast<double>(done) / static_cast<double>(count);
      if (!goOn(firstProgress + (lastProgress - firstProgress) * share))
      {
        throw Stopped();
      }
    });
}

Execution ExecuteLoops(vtkAlgorithm* filter, double firstProgress, double lastProgress)
{
  // All loops of what the caller does: copies of the execution have one state.
  auto begin = std::make_shared<double>(firstProgress);
  auto end = std::make_shared<double>(firstProgress);
  const Execution execution = ExecuteWithVtk(filter);
  return Watch(execution,
    [goOn = execution.Continue, begin, end, lastProgress](std::size_t done, std::size_t count)
    {
      if (done == 0)
      {
        *begin = *end;
        *end += ShareOfLoop * (lastProgress - *end);
      }
      const double share = static_cast<double>(done) / static_cast<double>(count);
      if (!goOn(*begin + (*end - *begin) * share))
      {
        throw Stopped();
      }
    });
}

ShareOfProgress::ShareOfProgress(vtkAlgorithm* filter, double first, double share)
  : Filter(filter)
  , Shift(filter->GetProgressShift())
  , Scale(filter->GetProgressScale())
{
  filter->SetProgressShiftScale(this->Shift + first * this->Scale, share * this->Scale);
}

ShareOfProgress::~ShareOfProgress()
{
  this->Filter->SetProgressShiftScale(this->Shift, this->Scale);
}
}
