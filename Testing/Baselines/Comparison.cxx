// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison.h"

#include "CaseFolder.h"
#include "MethodSummary.h"
#include "NoisyContours.h"
#include "RunApart.h"

#include "Support/CheckEmbedding.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkNew.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <exception>
#include <iomanip>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace orthoslices
{
namespace baselines
{
namespace
{

constexpr Comparison AllComparisons[] = { Comparison::SamePlanes, Comparison::SameNumber,
  Comparison::SparseZ };

//------------------------------------------------------------------------------
void Measure(const Task& task, std::int64_t samples, Outcome& outcome)
{
  Row& row = outcome.Figures;
  row.Shape = support::MeasureTopology(outcome.Surface);
  const auto deviation = support::MeasureDeviation(outcome.Surface, task.Truth, samples);
  if (!deviation)
  {
    row.Status = "empty surface";
    return;
  }
  row.Figures = deviation->ScaledBy(1.0 / task.Spacing);
  row.IsTopologyRight = row.Shape.IsClosedManifold() &&
    row.Shape.Components == task.TruthShape.Components && row.Shape.Genus == task.TruthShape.Genus;
}

//------------------------------------------------------------------------------
std::string FormatGenus(const support::Topology& shape)
{
  return shape.Genus ? std::to_string(*shape.Genus) : "-";
}

//------------------------------------------------------------------------------
using Cells = std::vector<std::string>;

const Cells Heading{ "comparison", "N", "case", "method", "RMS/h", "mean/h", "Hausdorff/h",
  "normals", "components", "genus", "watertight", "topology", "seconds" };

//------------------------------------------------------------------------------
Cells FormatRow(const Row& row)
{
  Cells cells{ row.ComparisonName, std::to_string(row.Number), row.CaseName, row.MethodName };
  if (!row.Figures)
  {
    cells.push_back(row.Status);
    return cells;
  }
  const support::Deviation& d = *row.Figures;
  for (const double length : { d.RootMeanSquare, d.Mean, d.Hausdorff })
  {
    cells.push_back(FormatNumber(length, 4));
  }
  cells.push_back(FormatNumber(d.NormalDegrees, 2));
  cells.push_back(std::to_string(row.Shape.Components));
  cells.push_back(FormatGenus(row.Shape));
  cells.push_back(row.Shape.IsWatertight() ? "yes" : "no");
  cells.push_back(row.IsTopologyRight ? "right" : "wrong");
  cells.push_back(FormatNumber(row.Seconds, 3));
  return cells;
}

//------------------------------------------------------------------------------
// Text columns to the left, numbers to the right; a status may be longer than its column.
void PrintAligned(const std::vector<Cells>& lines, std::size_t textColumns, std::ostream& out)
{
  std::vector<std::size_t> widths;
  for (const Cells& line : lines)
  {
    widths.resize(std::max(widths.size(), line.size()), 0);
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      const bool isStatus = i >= textColumns && i + 1 == line.size() && i + 1 < widths.size();
      widths[i] = isStatus ? widths[i] : std::max(widths[i], line[i].size());
    }
  }
  for (const Cells& line : lines)
  {
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      out << (i == 0 ? "" : "  ") << std::setw(static_cast<int>(widths[i]))
          << (i < textColumns ? std::left : std::right) << line[i];
    }
    out << '\n';
  }
}

//------------------------------------------------------------------------------
Cells FormatSummary(const MethodSummary& summary)
{
  const std::string runs = " of " + std::to_string(summary.Runs);
  return { summary.MethodName, FormatMedian(summary.RootMeanSquares, 4),
    FormatMedian(summary.Hausdorffs, 4), FormatMedian(summary.Normals, 2),
    std::to_string(summary.Watertight) + runs, std::to_string(summary.Right) + runs,
    FormatNumber(summary.Seconds, 2) };
}

//------------------------------------------------------------------------------
void PrintSummary(const std::vector<Row>& rows, std::ostream& out)
{
  std::vector<Cells> lines{ { "medians of " + rows.front().ComparisonName, "RMS/h", "Hausdorff/h",
    "normals", "watertight", "topology right", "seconds (sum)" } };
  for (const MethodSummary& summary : SummarizeByMethod(rows))
  {
    lines.push_back(FormatSummary(summary));
  }
  PrintAligned(lines, 1, out);
}

//------------------------------------------------------------------------------
// Double quotes where the text asks for them (RFC 4180).
std::string QuoteCsv(const std::string& text)
{
  if (text.find_first_of(",\"\n") == std::string::npos)
  {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text)
  {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + '"';
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::string NameOf(Comparison comparison)
{
  switch (comparison)
  {
    case Comparison::SamePlanes:
      return "same-planes";
    case Comparison::SameNumber:
      return "same-number";
    default:
      return "sparse-z";
  }
}

//------------------------------------------------------------------------------
Comparison ComparisonFromName(const std::string& name)
{
  for (const Comparison comparison : AllComparisons)
  {
    if (NameOf(comparison) == name)
    {
      return comparison;
    }
  }
  throw std::runtime_error("there is no comparison \"" + name + "\"");
}

//------------------------------------------------------------------------------
Task MakeTask(const std::string& folder, const std::string& name, Comparison kind, int number)
{
  Task task;
  task.CaseName = name;
  task.Kind = kind;
  task.Number = number;
  task.Truth = ReadTruth(folder, name);
  task.TruthShape = support::MeasureTopology(task.Truth);
  switch (kind)
  {
    case Comparison::SamePlanes:
      task.Orthogonal = ReadSlices(folder, name, number);
      task.Parallel = task.Orthogonal;
      break;
    case Comparison::SameNumber:
      task.Orthogonal = CutSurface(task.Truth, { number, number, number });
      task.Parallel = CutSurface(task.Truth, { 0, 0, 3 * number });
      break;
    case Comparison::SparseZ:
      task.Orthogonal = CutSurface(task.Truth, { number, number, number / 4 });
      task.Parallel = task.Orthogonal;
      break;
  }
  task.Spacing = MeanSpacing(task.Orthogonal);
  if (!(task.Spacing > 0.0))
  {
    throw std::runtime_error("the slices of " + name + " have no spacing");
  }
  return task;
}

//------------------------------------------------------------------------------
Task WithNoise(const Task& task, double percent)
{
  constexpr std::uint64_t seed = 2004;
  Task noisy = task;
  noisy.NoisePercent = percent;
  noisy.Orthogonal = AddNoise(task.Orthogonal, 0.01 * percent * task.Spacing, seed);
  noisy.Parallel = AddNoise(task.Parallel, 0.01 * percent * task.Spacing, seed);
  return noisy;
}

//------------------------------------------------------------------------------
Outcome RunMethod(const Baseline& method, const Task& task, std::int64_t samples)
{
  Outcome outcome;
  outcome.Surface = vtkSmartPointer<vtkPolyData>::New();
  Row& row = outcome.Figures;
  row.CaseName = task.CaseName;
  row.ComparisonName = NameOf(task.Kind);
  row.Number = task.Number;
  row.NoisePercent = task.NoisePercent;
  row.MethodName = method.Name();
  try
  {
    const TimedSurface result = RunApart(method, task.SlicesFor(method));
    outcome.Surface = result.Surface;
    row.Seconds = result.Seconds;
    Measure(task, samples, outcome);
  }
  catch (const Crash& crash)
  {
    row.Status = std::string("crashed: ") + crash.what();
  }
  catch (const std::exception& error)
  {
    row.Status = std::string("failed: ") + error.what();
  }
  return outcome;
}

//------------------------------------------------------------------------------
void CountCrossings(Outcome& outcome)
{
  if (!outcome.Figures.Figures)
  {
    return;
  }
  vtkNew<vtkTriangleFilter> triangles; // ruled surfaces are strips
  triangles->SetInputData(outcome.Surface);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  outcome.Figures.Crossings = support::CountCrossings(support::MeshOf(triangles->GetOutput()));
}

//------------------------------------------------------------------------------
void PrintTable(const std::vector<Row>& rows, std::ostream& out)
{
  std::vector<std::pair<std::string, std::vector<Row>>> groups;
  for (const Row& row : rows)
  {
    if (groups.empty() || groups.back().first != row.ComparisonName)
    {
      groups.push_back({ row.ComparisonName, {} });
    }
    groups.back().second.push_back(row);
  }
  for (const auto& [name, members] : groups)
  {
    std::vector<Cells> lines{ Heading };
    std::transform(members.begin(), members.end(), std::back_inserter(lines), FormatRow);
    PrintAligned(lines, 4, out);
    out << '\n';
    PrintSummary(members, out);
    out << '\n';
  }
}

//------------------------------------------------------------------------------
void WriteCsv(const std::vector<Row>& rows, std::ostream& out)
{
  out << "comparison,N,noise_percent,case,method,status,rms_h,mean_h,hausdorff_h,normal_degrees,"
         "components,genus,"
         "watertight,closed_manifold,topology_right,open_edges,non_manifold_edges,triangles,"
         "crossings,seconds\n";
  for (const Row& row : rows)
  {
    const support::Deviation d = row.Figures.value_or(support::Deviation());
    out << row.ComparisonName << ',' << row.Number << ',' << row.NoisePercent << ','
        << QuoteCsv(row.CaseName) << ',' << row.MethodName << ',' << QuoteCsv(row.Status) << ','
        << d.RootMeanSquare << ',' << d.Mean << ',' << d.Hausdorff << ',' << d.NormalDegrees << ','
        << row.Shape.Components << ',' << (row.Shape.Genus ? std::to_string(*row.Shape.Genus) : "")
        << ',' << row.Shape.IsWatertight() << ',' << row.Shape.IsClosedManifold() << ','
        << row.IsTopologyRight << ',' << row.Shape.OpenEdges << ',' << row.Shape.NonManifoldEdges
        << ',' << row.Shape.Triangles << ','
        << (row.Crossings ? std::to_string(*row.Crossings) : "") << ',' << row.Seconds << '\n';
  }
}

} // namespace baselines
} // namespace orthoslices
