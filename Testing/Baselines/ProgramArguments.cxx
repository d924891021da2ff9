// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramArguments.h"

#include <exception>
#include <fstream>
#include <sstream>

namespace orthoslices
{
namespace baselines
{

//------------------------------------------------------------------------------
std::vector<std::string> SplitAtCommas(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  return parts;
}

//------------------------------------------------------------------------------
std::int64_t ParsePositive(const std::string& text)
{
  std::size_t used = 0;
  long long number = 0;
  try
  {
    number = std::stoll(text, &used);
  }
  catch (const std::exception&)
  {
    used = 0;
  }
  if (used == 0 || used != text.size() || number < 1 || number > 1000000000)
  {
    throw std::runtime_error("\"" + text + "\" is not a positive number");
  }
  return number;
}

//------------------------------------------------------------------------------
void WriteCsvFile(const std::vector<Row>& rows, const std::string& name)
{
  std::ofstream file(name);
  WriteCsv(rows, file);
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + name);
  }
}

} // namespace baselines
} // namespace orthoslices
