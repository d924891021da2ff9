// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   medians and counts of each method over all cases, as plain text or Markdown
 */

#ifndef OrthoSlicesMethodSummary_h
#define OrthoSlicesMethodSummary_h

#include "Comparison.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace orthoslices
{
namespace baselines
{

/// Rounded to DIGITS after the point; "-" if not finite.
std::string FormatNumber(double value, int digits);

/// The median as FormatNumber() writes it; "-" without values.
std::string FormatMedian(std::vector<double> values, int digits);

/// The figures of one method over several cases. A run that failed counts as infinitely far off.
struct MethodSummary
{
  std::string MethodName;
  std::size_t Runs = 0;
  std::size_t Right = 0;        ///< runs with the right topology
  std::size_t Watertight = 0;   ///< runs without open edges
  std::size_t CrossingFree = 0; ///< runs without triangles that cross, where counted
  std::vector<double> RootMeanSquares;
  std::vector<double> Hausdorffs;
  std::vector<double> Normals;
  double Seconds = 0.0;

  void Add(const Row& row);
};

/// One summary for each method, in the order in which the methods occur.
std::vector<MethodSummary> SummarizeByMethod(const std::vector<Row>& rows);

/// One Markdown table for each comparison: a line for each method with medians over the cases.
void PrintMarkdownSummaries(const std::vector<Row>& rows, std::ostream& out);

/**
 * One Markdown table for each comparison: a line for each method and a column for each noise, with
 * the median of the RMS distance and the counts of good surfaces.
 */
void PrintNoiseTables(const std::vector<Row>& rows, std::ostream& out);

/**
 * One Markdown table with a line for each comparison and a column for each method: the median of
 * the RMS distance, and in brackets the median of the normals' deviation in degrees and the number
 * of surfaces with the right topology. "-" where a method was not run, or failed on most cases.
 */
void PrintComparisonTable(const std::vector<Row>& rows, std::ostream& out);

} // namespace baselines
} // namespace orthoslices

#endif
