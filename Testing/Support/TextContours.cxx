// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/TextContours.h"

#include <cstdlib>
#include <iostream>
#include <sstream>

namespace orthoslices
{
namespace support
{
namespace
{
[[noreturn]] void Fail(const std::string& line)
{
  std::cerr << "Not a contour: \"" << line << "\"\n";
  std::abort();
}

/// Reads one number from the text at `place` and moves on.
double ReadNumber(const std::string& line, std::size_t& place)
{
  const char* begin = line.c_str() + place;
  char* end = nullptr;
  const double value = std::strtod(begin, &end);
  if (end == begin)
  {
    Fail(line);
  }
  place += static_cast<std::size_t>(end - begin);
  return value;
}

bool Skip(const std::string& line, std::size_t& place, char expected)
{
  const bool found = place < line.size() && line[place] == expected;
  place += found ? 1 : 0;
  return found;
}

void SkipBlanks(const std::string& line, std::size_t& place)
{
  while (Skip(line, place, ' '))
  {
  }
}

void ReadVertices(const std::string& line, std::size_t place, double plane, Pieces& pieces)
{
  for (SkipBlanks(line, place); place < line.size(); SkipBlanks(line, place))
  {
    pieces.U.push_back(ReadNumber(line, place));
    if (!Skip(line, place, ','))
    {
      Fail(line);
    }
    pieces.V.push_back(ReadNumber(line, place));
    pieces.W.push_back(Skip(line, place, ',') ? ReadNumber(line, place) : plane);
  }
}

void ReadLine(const std::string& line, PieceSets& sets)
{
  const std::size_t axis = std::string("xyz").find(line[0]);
  std::size_t place = 1;
  if (axis == std::string::npos || !Skip(line, place, '='))
  {
    Fail(line);
  }
  const double plane = ReadNumber(line, place);
  SkipBlanks(line, place);
  const bool open = line.compare(place, 4, "open") == 0;
  place += open ? 4 : 0;
  if (!Skip(line, place, ':'))
  {
    Fail(line);
  }
  Pieces& pieces = sets[axis];
  ReadVertices(line, place, plane, pieces);
  pieces.Offsets.push_back(static_cast<Index>(pieces.U.size()));
  pieces.Cell.push_back(pieces.Count());
  pieces.Closed.push_back(open ? 0 : 1);
}
}

PieceSets EmptySets()
{
  PieceSets sets;
  for (int axis = 0; axis < 3; ++axis)
  {
    sets[axis].Axis = axis;
  }
  return sets;
}

PieceSets ParsePieces(const std::string& text)
{
  PieceSets sets = EmptySets();
  std::string line;
  for (std::size_t i = 0; i <= text.size(); ++i)
  {
    const bool ends = i == text.size() || text[i] == '\n' || text[i] == ';';
    if (ends && !line.empty())
    {
      ReadLine(line, sets);
      line.clear();
    }
    else if (!ends && (text[i] != ' ' || !line.empty()))
    {
      line += text[i];
    }
  }
  return sets;
}

Contours ParseContours(const std::string& text)
{
  Contours contours;
  for (const Pieces& pieces : ParsePieces(text))
  {
    for (Index i = 0; i < pieces.Count(); ++i)
    {
      const auto begin = pieces.Offsets[i];
      const auto end = pieces.Offsets[i + 1];
      contours.U.insert(contours.U.end(), pieces.U.begin() + begin, pieces.U.begin() + end);
      contours.V.insert(contours.V.end(), pieces.V.begin() + begin, pieces.V.begin() + end);
      contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
      contours.Axis.push_back(static_cast<std::int8_t>(pieces.Axis));
      contours.Coordinate.push_back(pieces.W[begin]);
      contours.Plane.push_back(0);
      contours.Cell.push_back(pieces.Cell[i]);
    }
  }
  return contours;
}

std::string ToText(const PieceSets& sets)
{
  std::ostringstream text;
  text.precision(17);
  for (const Pieces& pieces : sets)
  {
    for (Index i = 0; i < pieces.Count(); ++i)
    {
      const Index begin = pieces.Offsets[i];
      const double plane = pieces.W[begin];
      text << "xyz"[pieces.Axis] << '=' << plane << (pieces.Closed[i] ? ":" : " open:");
      for (Index vertex = begin; vertex < pieces.Offsets[i + 1]; ++vertex)
      {
        text << ' ' << pieces.U[vertex] << ',' << pieces.V[vertex];
        if (pieces.W[vertex] != plane)
        {
          text << ',' << pieces.W[vertex];
        }
      }
      text << '\n';
    }
  }
  return text.str();
}

void AddContour(
  Contours& contours, const std::vector<std::array<double, 2>>& vertices, double plane)
{
  for (const auto& vertex : vertices)
  {
    contours.U.push_back(vertex[0]);
    contours.V.push_back(vertex[1]);
  }
  contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
  contours.Axis.push_back(2);
  contours.Coordinate.push_back(plane);
  contours.Cell.push_back(contours.Count() - 1);
}

bool HasVertex(const Contours& contours, const std::array<double, 2>& place)
{
  for (std::size_t i = 0; i < contours.U.size(); ++i)
  {
    if (contours.U[i] == place[0] && contours.V[i] == place[1])
    {
      return true;
    }
  }
  return false;
}

void AddPiece(Pieces& pieces, const std::vector<std::array<double, 2>>& vertices, double plane)
{
  for (const auto& vertex : vertices)
  {
    pieces.U.push_back(vertex[0]);
    pieces.V.push_back(vertex[1]);
    pieces.W.push_back(plane);
  }
  pieces.Offsets.push_back(static_cast<Index>(pieces.U.size()));
  pieces.Cell.push_back(pieces.Count());
  pieces.Closed.push_back(1);
}

} // namespace support
} // namespace orthoslices
