// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   methods against a known surface: one row of figures each, and tables of the rows
 */

#ifndef OrthoSlicesComparison_h
#define OrthoSlicesComparison_h

#include "Baseline.h"

#include "Support/Vtk/SurfaceMetrics.h"

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace orthoslices
{
namespace baselines
{

/// Which planes the methods get.
enum class Comparison
{
  SamePlanes, ///< N planes per axis; methods for parallel slices use the N z-slices
  SameNumber, ///< N planes per axis, or 3 N z-slices for methods for parallel slices
  SparseZ     ///< N x N x N / 4 planes: thick slices
};

/// "same-planes", "same-number" or "sparse-z".
std::string NameOf(Comparison comparison);

/// @throw std::runtime_error if there is no such comparison.
Comparison ComparisonFromName(const std::string& name);

/// A shape, and the slices of it that the methods get.
struct Task
{
  std::string CaseName;
  Comparison Kind = Comparison::SamePlanes;
  int Number = 32;
  vtkSmartPointer<vtkPolyData> Truth;
  support::Topology TruthShape;
  SliceSets Orthogonal; ///< for methods that use three families
  SliceSets Parallel;   ///< for methods that use the z-slices only
  double Spacing = 0.0; ///< h of the orthogonal slices
  double NoisePercent = 0.0;

  const SliceSets& SlicesFor(const Baseline& method) const
  {
    return method.UsesFamilies()[0] ? this->Orthogonal : this->Parallel;
  }
};

/**
 * Reads the slices of a case for Comparison::SamePlanes, or cuts all of them from the known
 * surface for the other two.
 * @throw std::runtime_error if files are missing.
 */
Task MakeTask(const std::string& folder, const std::string& name, Comparison kind, int number);

/// The task with noise of a standard deviation of PERCENT of h on all contours (AddNoise()).
Task WithNoise(const Task& task, double percent);

/// What one method made of a task.
struct Row
{
  std::string CaseName;
  std::string ComparisonName;
  int Number = 0;
  double NoisePercent = 0.0;
  std::string MethodName;
  std::string Status = "ok";                 ///< or why there are no figures
  std::optional<support::Deviation> Figures; ///< in units of h
  support::Topology Shape;
  bool IsTopologyRight = false;          ///< closed manifold with the truth's components and genus
  std::optional<std::int64_t> Crossings; ///< pairs of triangles that cross; only if counted
  double Seconds = 0.0;
};

/// Result of a run: the row, and the surface, empty if the method failed.
struct Outcome
{
  Row Figures;
  vtkSmartPointer<vtkPolyData> Surface;
};

/**
 * Runs METHOD in a process of its own (RunApart()) and measures its surface with SAMPLES samples. A
 * method that throws, reports errors, crashes or returns nothing gives a row that says so.
 */
Outcome RunMethod(const Baseline& method, const Task& task, std::int64_t samples);

/// Counts the pairs of triangles that cross, for the row of the outcome.
void CountCrossings(Outcome& outcome);

/// Aligned plain text, and at the end of each comparison the medians and counts of each method.
void PrintTable(const std::vector<Row>& rows, std::ostream& out);

/// Comma-separated values with a heading.
void WriteCsv(const std::vector<Row>& rows, std::ostream& out);

} // namespace baselines
} // namespace orthoslices

#endif
