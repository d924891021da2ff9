// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A target of libFuzzer: reconstructs small sets of contours and checks each surface exactly.
 *
 * The input is text that is read without ever failing, so that every change of it means something:
 *
 *   FD                   flags: D as drawn, F float, C centroid, L crossing contours left out,
 *                        T tiny (times 1e-9), B features of 1e-3 at 1e6, V virtual slices where
 *                        they are needed, M unusable contours mended, X, Y, Z without the
 *                        slices of this axis
 *   z2: 0,0 4,0 4,4      contour on z = 2; small integers, so that coincidences are frequent
 *   x1o: 0,0 4m1,0e-2    open piece; m adds multiples of 2^-22, e of 2^-50
 *
 * Coordinates as in Support/TextContours.h. A failure is printed as such text, to become a
 * regression test.
 */

#include "Support/CheckBounds.h"
#include "Support/CheckEmbedding.h"
#include "Support/Random.h"
#include "Support/ReconstructionMesh.h"
#include "Support/ReduceInput.h"
#include "Support/Stages.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr std::size_t MaxPieces = 24;
constexpr std::size_t MaxVertices = 24;
constexpr int Greatest = 12;
constexpr const char* Flags = "DFCLTBVMXYZ";

struct Number
{
  int Whole = 0, Middle = 0, Last = 0;

  double Value() const { return this->Whole + this->Middle * 0x1p-22 + this->Last * 0x1p-50; }
};

struct FuzzPiece
{
  int Axis = 0;
  bool Open = false;
  Number Plane;
  std::vector<std::array<Number, 2>> Vertices;
};

struct FuzzInput
{
  std::string Flags;
  std::vector<FuzzPiece> Pieces;

  bool Has(char flag) const { return this->Flags.find(flag) != std::string::npos; }
};

int ReadDigits(const std::string& text, std::size_t& place, int maximum)
{
  const bool negative = place < text.size() && text[place] == '-';
  place += negative ? 1 : 0;
  int value = 0;
  while (place < text.size() && std::isdigit(static_cast<unsigned char>(text[place])))
  {
    value = std::min(maximum, 10 * value + (text[place++] - '0'));
  }
  return negative ? -value : value;
}

Number ReadNumber(const std::string& text, std::size_t& place)
{
  Number number;
  number.Whole = ReadDigits(text, place, Greatest);
  while (place < text.size() && (text[place] == 'm' || text[place] == 'e'))
  {
    int& part = text[place] == 'm' ? number.Middle : number.Last;
    part = ReadDigits(text, ++place, 9);
  }
  return number;
}

bool StartsNumber(char c) { return c == '-' || std::isdigit(static_cast<unsigned char>(c)); }

FuzzInput Parse(const std::string& text)
{
  FuzzInput input;
  std::vector<Number> numbers;
  const auto finish = [&]
  {
    if (!input.Pieces.empty())
    {
      FuzzPiece& piece = input.Pieces.back();
      for (std::size_t i = 0; i < numbers.size() && piece.Vertices.size() < MaxVertices; ++i)
      {
        if (i == 0)
        {
          piece.Plane = numbers[0];
        }
        else if (i % 2 == 0)
        {
          piece.Vertices.push_back({ numbers[i - 1], numbers[i] });
        }
      }
    }
    numbers.clear();
  };
  for (std::size_t place = 0; place < text.size();)
  {
    const char c = text[place];
    if (c >= 'x' && c <= 'z')
    {
      finish();
      if (input.Pieces.size() == MaxPieces)
      {
        break;
      }
      input.Pieces.emplace_back();
      input.Pieces.back().Axis = c - 'x';
    }
    if (StartsNumber(c))
    {
      numbers.push_back(ReadNumber(text, place));
      continue;
    }
    if (c == 'o' && !input.Pieces.empty())
    {
      input.Pieces.back().Open = true;
    }
    if (std::strchr(Flags, c) != nullptr && c != '\0' && !input.Has(c))
    {
      input.Flags += c;
    }
    ++place;
  }
  finish();
  return input;
}

void Write(const Number& number, std::string& text)
{
  text += std::to_string(number.Whole);
  text += number.Middle == 0 ? "" : "m" + std::to_string(number.Middle);
  text += number.Last == 0 ? "" : "e" + std::to_string(number.Last);
}

std::string Write(const FuzzInput& input)
{
  std::string text = input.Flags + "\n";
  for (const FuzzPiece& piece : input.Pieces)
  {
    text += static_cast<char>('x' + piece.Axis);
    Write(piece.Plane, text);
    text += piece.Open ? "o:" : ":";
    for (const auto& vertex : piece.Vertices)
    {
      text += ' ';
      Write(vertex[0], text);
      text += ',';
      Write(vertex[1], text);
    }
    text += '\n';
  }
  return text;
}

double Place(const FuzzInput& input, const Number& number)
{
  const double x = number.Value();
  const double placed = input.Has('T') ? 1e-9 * x : input.Has('B') ? 1e6 + 1e-3 * x : x;
  return input.Has('F') ? static_cast<float>(placed) : placed;
}

PieceSets MakeSets(const FuzzInput& input)
{
  PieceSets sets = EmptySets();
  for (const FuzzPiece& piece : input.Pieces)
  {
    std::vector<std::array<double, 2>> vertices;
    for (const auto& vertex : piece.Vertices)
    {
      vertices.push_back({ Place(input, vertex[0]), Place(input, vertex[1]) });
    }
    if (vertices.size() >= 2 && !input.Has(static_cast<char>('X' + piece.Axis)))
    {
      AddPiece(sets[piece.Axis], vertices, Place(input, piece.Plane));
      sets[piece.Axis].Closed.back() = piece.Open ? 0 : 1;
    }
  }
  return sets;
}

Options MakeOptions(const FuzzInput& input)
{
  Options options;
  options.Invalid = input.Has('M') ? InvalidContours::Mend : InvalidContours::LeaveOut;
  options.SinglePrecision = input.Has('F');
  options.Orient = input.Has('D') ? Orientation::AsDrawn : Orientation::ByNesting;
  options.Crossing = input.Has('L') ? CrossingContours::LeaveOut : CrossingContours::Repair;
  options.Loops = input.Has('E') ? LoopRule::EvenOdd
    : input.Has('N')             ? LoopRule::NonZero
                                 : LoopRule::Union;
  options.Virtual = input.Has('V') ? VirtualSlices::Automatic : VirtualSlices::Off;
  options.Central =
    input.Has('C') ? CentralPointMethod::Centroid : CentralPointMethod::LeastSquares;
  return options;
}

/// Whether the point lies on a contour of one of its slices, or next to it.
bool IsOnContour(const Contours& contours, const Point3& p, double tolerance)
{
  for (Index c = 0; c < contours.Count(); ++c)
  {
    const int axis = contours.Axis[c];
    const Index begin = contours.Offsets[c], end = contours.Offsets[c + 1];
    for (Index i = begin; i < end && contours.Coordinate[c] == p[axis]; ++i)
    {
      const Index j = i + 1 < end ? i + 1 : begin;
      const double u = contours.U[i] - p[FirstAxis(axis)], v = contours.V[i] - p[SecondAxis(axis)];
      const double du = contours.U[j] - contours.U[i], dv = contours.V[j] - contours.V[i];
      const double t = std::clamp(-(u * du + v * dv) / (du * du + dv * dv), 0.0, 1.0);
      if (std::hypot(u + t * du, v + t * dv) <= tolerance)
      {
        return true;
      }
    }
  }
  return false;
}

/// Grid vertices on the wrong side (G3). On a contour, both sides are right.
std::string FindWrongSides(const PieceSets& sets, const Options& options, const TriangleMesh& mesh)
{
  SpatialGrid grid;
  const Contours contours = UsableContours(sets, options, grid);
  const double reach =
    contours.Count() == 0 ? 0.0 : *std::max_element(grid.Step.begin(), grid.Step.end());
  double size = 0.0;
  for (const Point3& p : mesh.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      size = std::max(size, std::abs(p[axis] - mesh.Points.front()[axis]));
    }
  }
  for (const Point3& p : CheckGridVertices(mesh, contours, grid, options.Orient, 64, 1).Wrong)
  {
    if (!IsOnContour(contours, p, std::max(64.0 * reach, 1e-5 * size)))
    {
      return "wrong side: (" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " +
        std::to_string(p[2]) + ")\n";
    }
  }
  return std::string();
}

//--------------------------------------------------------------------------------------------------
// Changes of an input.

/// One plane of a box, or a contour of any kind on it.
FuzzPiece Rectangle(
  int axis, int plane, const std::array<int, 3>& low, const std::array<int, 3>& high)
{
  FuzzPiece piece;
  piece.Axis = axis;
  piece.Plane.Whole = plane;
  const int u = FirstAxis(axis), v = SecondAxis(axis);
  for (const auto& corner : { std::array<int, 2>{ low[u], low[v] }, { high[u], low[v] },
         { high[u], high[v] }, { low[u], high[v] } })
  {
    piece.Vertices.push_back({ Number{ corner[0], 0, 0 }, Number{ corner[1], 0, 0 } });
  }
  return piece;
}

/// A box with some of the planes that cut it.
void AddBox(FuzzInput& input, Random& random)
{
  std::array<int, 3> low, high;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = static_cast<int>(random.Below(6));
    high[axis] = low[axis] + 1 + static_cast<int>(random.Below(5));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int plane = low[axis]; plane <= high[axis]; ++plane)
    {
      if (random.Chance(0.4) && input.Pieces.size() < MaxPieces)
      {
        input.Pieces.push_back(Rectangle(axis, plane, low, high));
      }
    }
  }
}

void ChangeNumber(Number& number, Random& random)
{
  switch (random.Below(8))
  {
    case 0:
      number.Middle = static_cast<int>(random.Below(7)) - 3;
      break;
    case 1:
      number.Last = static_cast<int>(random.Below(7)) - 3;
      break;
    case 2:
      number.Middle = number.Last = 0;
      break;
    default:
      number.Whole =
        std::clamp(number.Whole + static_cast<int>(random.Below(7)) - 3, -Greatest, Greatest);
  }
}

void ChangePiece(FuzzPiece& piece, Random& random)
{
  auto& vertices = piece.Vertices;
  const auto at = [&]
  { return vertices.begin() + static_cast<std::ptrdiff_t>(random.Below(vertices.size())); };
  if (vertices.empty())
  {
    vertices.emplace_back();
    return;
  }
  switch (random.Below(10))
  {
    case 0:
      ChangeNumber(piece.Plane, random);
      break;
    case 1:
      vertices.erase(at());
      break;
    case 2:
    case 3:
    {
      const std::array<Number, 2> copy = *at();
      const auto inserted = vertices.insert(at(), copy);
      ChangeNumber((*inserted)[random.Below(2)], random);
      break;
    }
    case 4:
      random.Chance(0.5) ? std::reverse(vertices.begin(), vertices.end()) : std::swap(*at(), *at());
      break;
    case 5:
      piece.Open = random.Chance(0.2);
      piece.Axis = random.Chance(0.3) ? static_cast<int>(random.Below(3)) : piece.Axis;
      break;
    default:
      ChangeNumber((*at())[random.Below(2)], random);
  }
}

void Change(FuzzInput& input, Random& random)
{
  const std::size_t count = input.Pieces.size();
  const std::size_t choice = count == 0 ? 0 : random.Below(16);
  if (choice == 0)
  {
    AddBox(input, random);
  }
  else if (choice == 1 && count < MaxPieces)
  {
    FuzzPiece copy = input.Pieces[random.Below(count)];
    copy.Plane.Whole += static_cast<int>(random.Below(3)) - 1;
    input.Pieces.push_back(copy);
  }
  else if (choice == 2)
  {
    input.Pieces.erase(input.Pieces.begin() + static_cast<std::ptrdiff_t>(random.Below(count)));
  }
  else if (choice == 3)
  {
    const char flag = Flags[random.Below(std::strlen(Flags))];
    const std::size_t place = input.Flags.find(flag);
    place == std::string::npos ? input.Flags.push_back(flag)
                               : static_cast<void>(input.Flags.erase(place, 1));
  }
  else
  {
    ChangePiece(input.Pieces[random.Below(count)], random);
  }
}
}

//--------------------------------------------------------------------------------------------------
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maximum);

extern "C" std::size_t LLVMFuzzerCustomMutator(
  std::uint8_t* data, std::size_t size, std::size_t maximum, unsigned int seed)
{
  Random random(seed);
  if (random.Chance(0.1))
  {
    return LLVMFuzzerMutate(data, size, maximum);
  }
  FuzzInput input = Parse(std::string(reinterpret_cast<const char*>(data), size));
  for (std::size_t i = 1 + random.Below(4); i > 0; --i)
  {
    Change(input, random);
  }
  const std::string text = Write(input);
  const std::size_t length = std::min(maximum, text.size());
  std::memcpy(data, text.data(), length);
  return length;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const FuzzInput input = Parse(std::string(reinterpret_cast<const char*>(data), size));
  const PieceSets sets = MakeSets(input);
  const Options options = MakeOptions(input);
  const Reconstruction result = Reconstruct(PieceSets(sets), options, Execution());
  if (result.Refused)
  {
    return 0;
  }
  const TriangleMesh mesh = MeshOf(result);
  SpatialGrid grid;
  std::string flaws = DescribeFlaws(mesh) +
    DescribeExcess(mesh, UsableContours(sets, options, grid), options.SinglePrecision);
  if (!flaws.empty())
  {
    const PieceSets reduced = Reduce(sets, options, 300);
    std::cerr << Describe(sets, options) << flaws << "Reduced:\n"
              << Describe(reduced, options) << FindFlaws(reduced, options);
    std::abort();
  }
  flaws = FindWrongSides(sets, options, mesh);
  if (!flaws.empty())
  {
    std::cerr << Describe(sets, options) << flaws;
    std::abort();
  }
  return 0;
}
