// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/DescribeProblems.h"

#include "Bridge/DescribeReport.h"

#include <algorithm>
#include <sstream>

namespace orthoslices
{
namespace
{
/// Of many unusable contours so many are named; the others are counted.
constexpr std::size_t ListedProblems = 10;

struct KindTexts
{
  const char* Name; ///< in the table
  const char* Is;   ///< "the contour ..."
  const char* Were; ///< "<number> ...", for one line that counts
  const char* Size; ///< what the size is: ", ... <size>"; null where it is not worth a word
};

/// In the order of ProblemKind.
constexpr KindTexts Texts[] = { { "NotFinite", "has a coordinate that is not finite",
                                  "with coordinates that are not finite: left out", nullptr },
  { "OffPlane", "leaves its plane", "that leave their plane: left out", "by up to" },
  { "Open", "is open", "that are open: left out", nullptr },
  { "CrossesItself", "crosses itself", "that cross themselves", nullptr },
  { "CrossesOther", "crosses another contour of its slice", "that cross others of their slice",
    nullptr },
  { "TooShort", "is a single point or segment", "of one or two points that join nothing: left out",
    "of a length of up to" },
  { "Flat", "has no area", "without area: left out", "of a length of up to" },
  { "MovedOntoPlane", "was moved onto its plane", "with points beside their plane: moved onto it",
    "by up to" },
  { "GapClosed", "had a gap", "with a gap: closed", "the longest gap" },
  { "OverrunTrimmed", "ran past its start", "that ran past their start: trimmed",
    "by a length of up to" },
  { "ClosedAlongBorder", "ends at the border of the image",
    "that end at the border of the image: closed along it", nullptr },
  { "LeftOpen", "ends at the border of the image",
    "that end at the border of the image: the surface is left open there", nullptr },
  { "LoopsUnited", "overlaps another contour of its slice",
    "that cross or overlap others of their slice: taken together", nullptr },
  { "BridgeRemoved", "has a bridge that is drawn twice",
    "with a bridge that is drawn there and back: left out", nullptr },
  { "LoopSplit", "touches itself", "that touch or cross themselves: split there", nullptr },
  { "DrawnTwice", "is drawn twice", "that are drawn twice: counted once",
    "at a distance of up to" } };
static_assert(sizeof(Texts) / sizeof(Texts[0]) == ProblemKindCount, "a text for each kind");

const KindTexts& TextsOf(ProblemKind kind) { return Texts[static_cast<int>(kind)]; }

std::string PlaceOf(const Problem& problem)
{
  std::ostringstream text;
  text << "port " << problem.Port << " (" << AxisNames[problem.Axis] << "-slices), cell "
       << problem.Cell;
  return text.str();
}

std::string PointOf(const Problem& problem)
{
  std::ostringstream text;
  text << "(" << problem.Where[0] << ", " << problem.Where[1] << ", " << problem.Where[2] << ")";
  return text.str();
}
}

const char* NameOf(ProblemKind kind) { return TextsOf(kind).Name; }

std::string DescribeProblems(const std::vector<Problem>& problems)
{
  std::ostringstream text;
  for (std::size_t i = 0; i < problems.size() && i < ListedProblems; ++i)
  {
    text << "\n  " << PlaceOf(problems[i]) << ": the contour " << TextsOf(problems[i].Kind).Is
         << " at " << PointOf(problems[i]);
  }
  if (problems.size() > ListedProblems)
  {
    text << "\n  and " << problems.size() - ListedProblems << " more";
  }
  return text.str();
}

std::string DescribeMended(const std::vector<Problem>& problems)
{
  std::ostringstream text;
  for (int i = 0; i < ProblemKindCount; ++i)
  {
    const auto kind = static_cast<ProblemKind>(i);
    const Problem* first = nullptr;
    std::size_t count = 0;
    double greatest = 0.0;
    for (const Problem& problem : problems)
    {
      if (problem.Kind == kind)
      {
        first = first == nullptr ? &problem : first;
        greatest = std::max(greatest, problem.Size);
        ++count;
      }
    }
    if (first == nullptr)
    {
      continue;
    }
    text << "\n  " << count << (count > 1 ? " contours " : " contour ") << TextsOf(kind).Were;
    if (TextsOf(kind).Size != nullptr && greatest > 0.0)
    {
      text << ", " << TextsOf(kind).Size << " " << greatest;
    }
    text << "; " << (count > 1 ? "the first: " : "") << PlaceOf(*first) << ", at "
         << PointOf(*first);
  }
  return text.str();
}
}
