// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what the programs that compare methods read from the command line, and where they write
 */

#ifndef OrthoSlicesProgramArguments_h
#define OrthoSlicesProgramArguments_h

#include "Comparison.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace orthoslices
{
namespace baselines
{

/// The parts of a list such as "a,b,c".
std::vector<std::string> SplitAtCommas(const std::string& text);

/// A whole number from 1 to 10 ^ 9. THROWS std::runtime_error if it is none.
std::int64_t ParsePositive(const std::string& text);

/**
 * Arguments are switches, for which findSwitch(option, options) returns the flag to set, and
 * options followed by a value, which parseValue(option, value, options) takes. THROWS
 * std::runtime_error if a value is missing, and what parseValue throws.
 */
template <typename Options, typename FindSwitch, typename ParseValue>
Options ParseArguments(
  const std::vector<std::string>& arguments, FindSwitch&& findSwitch, ParseValue&& parseValue)
{
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& option = arguments[i];
    if (bool* const flag = findSwitch(option, options))
    {
      *flag = true;
    }
    else if (i + 1 < arguments.size())
    {
      parseValue(option, arguments[++i], options);
    }
    else
    {
      throw std::runtime_error("unknown option or no value: " + option);
    }
  }
  return options;
}

/// Writes rows as comma-separated values. THROWS std::runtime_error if the file cannot be written.
void WriteCsvFile(const std::vector<Row>& rows, const std::string& name);

} // namespace baselines
} // namespace orthoslices

#endif
