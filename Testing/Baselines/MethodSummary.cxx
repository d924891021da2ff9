// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MethodSummary.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iterator>
#include <limits>
#include <ostream>
#include <set>
#include <sstream>

namespace orthoslices
{
namespace baselines
{
namespace
{

//------------------------------------------------------------------------------
std::vector<Row> Select(const std::vector<Row>& rows, const std::function<bool(const Row&)>& wanted)
{
  std::vector<Row> selected;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(selected), wanted);
  return selected;
}

//------------------------------------------------------------------------------
std::vector<std::string> ComparisonsOf(const std::vector<Row>& rows)
{
  std::vector<std::string> names;
  for (const Row& row : rows)
  {
    if (std::find(names.begin(), names.end(), row.ComparisonName) == names.end())
    {
      names.push_back(row.ComparisonName);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
std::set<double> NoisesOf(const std::vector<Row>& rows)
{
  std::set<double> noises;
  for (const Row& row : rows)
  {
    noises.insert(row.NoisePercent);
  }
  return noises;
}

//------------------------------------------------------------------------------
std::size_t CountCases(const std::vector<Row>& rows)
{
  std::set<std::string> names;
  for (const Row& row : rows)
  {
    names.insert(row.CaseName);
  }
  return names.size();
}

//------------------------------------------------------------------------------
// Without trailing zeros: 5, 0.5.
std::string FormatPercent(double percent)
{
  std::ostringstream text;
  text << percent << " %";
  return text.str();
}

//------------------------------------------------------------------------------
void PrintMarkdownSummary(const std::vector<Row>& rows, std::ostream& out)
{
  out << "| " << rows.front().ComparisonName << ", N = " << rows.front().Number
      << " | RMS/h | Hausdorff/h | normals (deg) | watertight | topology right | seconds |\n"
      << "|---|--:|--:|--:|--:|--:|--:|\n";
  for (const MethodSummary& summary : SummarizeByMethod(rows))
  {
    const std::string runs = " of " + std::to_string(summary.Runs);
    out << "| " << summary.MethodName << " | " << FormatMedian(summary.RootMeanSquares, 3) << " | "
        << FormatMedian(summary.Hausdorffs, 2) << " | " << FormatMedian(summary.Normals, 1) << " | "
        << summary.Watertight << runs << " | " << summary.Right << runs << " | "
        << FormatNumber(summary.Seconds, 1) << " |\n";
  }
}

//------------------------------------------------------------------------------
// RMS distance, and how many surfaces have the right topology, are watertight, do not cross.
std::string FormatNoiseCell(const MethodSummary& summary)
{
  std::ostringstream text;
  text << FormatMedian(summary.RootMeanSquares, 3) << " (" << summary.Right << ", "
       << summary.Watertight << ", " << summary.CrossingFree << ')';
  return text.str();
}

//------------------------------------------------------------------------------
void PrintNoiseTable(const std::vector<Row>& rows, std::ostream& out)
{
  const std::set<double> noises = NoisesOf(rows);
  out << "| " << rows.front().ComparisonName << ", N = " << rows.front().Number << ": noise";
  for (const double noise : noises)
  {
    out << " | " << FormatPercent(noise);
  }
  out << " |\n|---|";
  for (std::size_t i = 0; i < noises.size(); ++i)
  {
    out << "---|";
  }
  out << '\n';
  for (const MethodSummary& method : SummarizeByMethod(rows))
  {
    out << "| " << method.MethodName;
    for (const double noise : noises)
    {
      const auto summaries = SummarizeByMethod(Select(rows,
        [&](const Row& r)
        { return r.MethodName == method.MethodName && r.NoisePercent == noise; }));
      out << " | " << (summaries.empty() ? "-" : FormatNoiseCell(summaries.front()));
    }
    out << " |\n";
  }
}

//------------------------------------------------------------------------------
std::string FormatComparisonCell(const std::vector<Row>& rows)
{
  const auto summaries = SummarizeByMethod(rows);
  const std::string distance =
    summaries.empty() ? "-" : FormatMedian(summaries.front().RootMeanSquares, 3);
  if (distance == "-")
  {
    return distance;
  }
  const MethodSummary& summary = summaries.front();
  return distance + " (" + FormatMedian(summary.Normals, 0) + "°, " +
    std::to_string(summary.Right) + ")";
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::string FormatNumber(double value, int digits)
{
  if (!std::isfinite(value))
  {
    return "-";
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

//------------------------------------------------------------------------------
std::string FormatMedian(std::vector<double> values, int digits)
{
  if (values.empty())
  {
    return "-";
  }
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return FormatNumber(0.5 * (values[half] + values[(values.size() - 1) / 2]), digits);
}

//------------------------------------------------------------------------------
void MethodSummary::Add(const Row& row)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  ++this->Runs;
  this->Right += row.IsTopologyRight;
  this->Watertight += row.Shape.IsWatertight();
  this->CrossingFree += row.Crossings && *row.Crossings == 0;
  this->Seconds += row.Seconds;
  this->RootMeanSquares.push_back(row.Figures ? row.Figures->RootMeanSquare : none);
  this->Hausdorffs.push_back(row.Figures ? row.Figures->Hausdorff : none);
  this->Normals.push_back(row.Figures ? row.Figures->NormalDegrees : none);
}

//------------------------------------------------------------------------------
std::vector<MethodSummary> SummarizeByMethod(const std::vector<Row>& rows)
{
  std::vector<MethodSummary> summaries;
  for (const Row& row : rows)
  {
    const auto same = [&row](const MethodSummary& s) { return s.MethodName == row.MethodName; };
    auto found = std::find_if(summaries.begin(), summaries.end(), same);
    if (found == summaries.end())
    {
      summaries.emplace_back();
      found = summaries.end() - 1;
      found->MethodName = row.MethodName;
    }
    found->Add(row);
  }
  return summaries;
}

//------------------------------------------------------------------------------
void PrintMarkdownSummaries(const std::vector<Row>& rows, std::ostream& out)
{
  for (const std::string& name : ComparisonsOf(rows))
  {
    PrintMarkdownSummary(
      Select(rows, [&name](const Row& r) { return r.ComparisonName == name; }), out);
    out << '\n';
  }
}

//------------------------------------------------------------------------------
void PrintNoiseTables(const std::vector<Row>& rows, std::ostream& out)
{
  for (const std::string& name : ComparisonsOf(rows))
  {
    PrintNoiseTable(Select(rows, [&name](const Row& r) { return r.ComparisonName == name; }), out);
    out << "\nMedian of RMS/h over the cases (of " << CountCases(rows)
        << " surfaces, how many have the right topology, are watertight, have no triangles that "
           "cross).\nNoise: standard deviation of each vertex within its plane, in per cent of "
           "h.\n\n";
  }
}

//------------------------------------------------------------------------------
void PrintComparisonTable(const std::vector<Row>& rows, std::ostream& out)
{
  const std::vector<MethodSummary> methods = SummarizeByMethod(rows);
  std::string rule = "|---|";
  out << "| planes |";
  for (const MethodSummary& method : methods)
  {
    out << ' ' << method.MethodName << " |";
    rule += "---|";
  }
  out << '\n' << rule << '\n';
  for (const std::string& comparison : ComparisonsOf(rows))
  {
    out << "| " << comparison << " |";
    for (const MethodSummary& method : methods)
    {
      out << ' '
          << FormatComparisonCell(Select(rows,
               [&](const Row& row)
               { return row.ComparisonName == comparison && row.MethodName == method.MethodName; }))
          << " |";
    }
    out << '\n';
  }
}

} // namespace baselines
} // namespace orthoslices
