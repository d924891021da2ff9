// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RunApart.h"

#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string>

#if defined(__unix__) || defined(__APPLE__)
#include <cerrno>
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>
#define ORTHOGONAL_SLICES_HAVE_FORK
#endif

namespace orthoslices
{
namespace baselines
{
namespace
{

//------------------------------------------------------------------------------
TimedSurface RunHere(const Baseline& method, const SliceSets& slices)
{
  const auto start = std::chrono::steady_clock::now();
  TimedSurface result;
  result.Surface = method.Reconstruct(slices);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  result.Seconds = elapsed.count();
  return result;
}

#ifdef ORTHOGONAL_SLICES_HAVE_FORK

// What the child says: one of these letters, the seconds, and the surface or the sentence.
constexpr char Done = 'D';
constexpr char Failed = 'F';

//------------------------------------------------------------------------------
std::string Pack(char kind, double seconds, const std::string& text)
{
  std::string message(1 + sizeof(seconds), kind);
  std::memcpy(&message[1], &seconds, sizeof(seconds));
  return message + text;
}

//------------------------------------------------------------------------------
std::string ToString(vtkPolyData* surface)
{
  if (surface->GetNumberOfPoints() == 0)
  {
    return std::string(); // the reader takes files without points for broken
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(surface);
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToNone();
  writer->WriteToOutputStringOn();
  if (!writer->Write())
  {
    throw std::runtime_error("the surface cannot be handed over");
  }
  return writer->GetOutputString();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> FromString(const std::string& text)
{
  if (text.empty())
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(text);
  reader->Update();
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
std::string MakeMessage(const Baseline& method, const SliceSets& slices)
{
  try
  {
    const TimedSurface result = RunHere(method, slices);
    return Pack(Done, result.Seconds, ToString(result.Surface));
  }
  catch (const std::exception& error)
  {
    return Pack(Failed, 0.0, error.what());
  }
}

//------------------------------------------------------------------------------
// Ends without any clean-up: files, threads and windows belong to the parent.
[[noreturn]] void RunChild(const Baseline& method, const SliceSets& slices, int output)
{
  vtkSMPTools::SetBackend("Sequential");
  const std::string message = MakeMessage(method, slices);
  for (std::size_t sent = 0; sent < message.size();)
  {
    const ssize_t count = write(output, message.data() + sent, message.size() - sent);
    if (count < 0 && errno != EINTR)
    {
      _exit(EXIT_FAILURE);
    }
    sent += static_cast<std::size_t>(count > 0 ? count : 0);
  }
  _exit(EXIT_SUCCESS);
}

//------------------------------------------------------------------------------
std::string ReadAll(int input)
{
  std::string text;
  char buffer[1 << 16];
  for (;;)
  {
    const ssize_t count = read(input, buffer, sizeof(buffer));
    if (count > 0)
    {
      text.append(buffer, static_cast<std::size_t>(count));
    }
    else if (count == 0 || errno != EINTR)
    {
      return text;
    }
  }
}

//------------------------------------------------------------------------------
void WaitFor(pid_t child)
{
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
  {
  }
  if (WIFSIGNALED(status))
  {
    throw Crash(strsignal(WTERMSIG(status)));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS)
  {
    throw Crash("exit status " + std::to_string(WEXITSTATUS(status)));
  }
}

//------------------------------------------------------------------------------
TimedSurface Unpack(const std::string& message)
{
  TimedSurface result;
  const std::size_t head = 1 + sizeof(result.Seconds);
  if (message.size() < head)
  {
    throw Crash("ended without a result");
  }
  if (message[0] != Done)
  {
    throw std::runtime_error(message.substr(head));
  }
  std::memcpy(&result.Seconds, &message[1], sizeof(result.Seconds));
  result.Surface = FromString(message.substr(head));
  return result;
}

//------------------------------------------------------------------------------
TimedSurface RunInChild(const Baseline& method, const SliceSets& slices)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    throw std::runtime_error("no pipe for a process");
  }
  const pid_t child = fork();
  if (child == 0)
  {
    close(ends[0]);
    RunChild(method, slices, ends[1]);
  }
  close(ends[1]);
  const std::string message = child > 0 ? ReadAll(ends[0]) : std::string();
  close(ends[0]);
  if (child < 0)
  {
    throw std::runtime_error("no process for the method");
  }
  WaitFor(child);
  return Unpack(message);
}

#endif

} // anonymous namespace

//------------------------------------------------------------------------------
TimedSurface RunApart(const Baseline& method, const SliceSets& slices)
{
#ifdef ORTHOGONAL_SLICES_HAVE_FORK
  return RunInChild(method, slices);
#else
  return RunHere(method, slices);
#endif
}

} // namespace baselines
} // namespace orthoslices
