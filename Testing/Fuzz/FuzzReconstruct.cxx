// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A target of libFuzzer: reconstructs small sets of contours as the filter does, from polylines in
 * any frame and with any labels to one surface for each label, and checks each surface exactly.
 *
 * FuzzInput.h says what the inputs are. A failure is printed as such text, and as slices along the
 * axes of the frame, to become a regression test.
 */

#include "FuzzChanges.h"

#include "Core/Frames/SplitByLabel.h"
#include "Core/Patches/SharedPatches.h"
#include "Core/ReconstructSorted.h"
#include "Support/CheckBounds.h"
#include "Support/CheckEmbedding.h"
#include "Support/ReconstructionMesh.h"
#include "Support/ReduceInput.h"
#include "Support/Stages.h"
#include "Support/TurnedSlices.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// The port of contours of any families.
constexpr int AnyPort = 3;

/// From coordinates along the edges of the cells to those of the world.
Matrix3 FrameMatrix(const FuzzInput& input)
{
  constexpr double radians = 3.14159265358979323846 / 24.0; // 7.5 degrees
  Matrix3 matrix = UnitMatrix();
  matrix[0][1] = input.Frame[3].Value() / 16.0;
  matrix[0][2] = input.Frame[4].Value() / 16.0;
  matrix[1][2] = input.Frame[5].Value() / 16.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (input.Frame[axis].Value() != 0.0)
    {
      const Matrix3 turn = RotationAround(UnitMatrix()[axis], radians * input.Frame[axis].Value());
      Matrix3 columns = Transpose(matrix);
      for (Point3& column : columns)
      {
        column = Apply(turn, column);
      }
      matrix = Transpose(columns);
    }
  }
  return matrix;
}

double Place(const FuzzInput& input, double x)
{
  const double rounded = input.Has('Q') ? std::round(64.0 * x) / 64.0 : x;
  const double placed = input.Has('T') ? 1e-9 * rounded
    : input.Has('B')                   ? 1e6 + 1e-3 * rounded
                                       : rounded;
  return input.Has('F') ? static_cast<float>(placed) : placed;
}

/// A vertex of a piece along the edges of the cells.
Point3 VertexOf(const FuzzPiece& piece, const std::array<FuzzNumber, 2>& vertex)
{
  const double u = vertex[0].Value(), v = vertex[1].Value();
  const double w = piece.Plane.Value() + 0x1p-7 * (vertex[0].Height + vertex[1].Height);
  if (piece.Axis == FuzzPiece::Oblique)
  {
    return { 0.6 * w - 0.8 * u, 0.8 * w + 0.6 * u, v };
  }
  Point3 point;
  point[FirstAxis(piece.Axis)] = u;
  point[SecondAxis(piece.Axis)] = v;
  point[piece.Axis] = w;
  return point;
}

/// The polylines in the world with the label of each.
Polylines MakeLines(const FuzzInput& input, std::vector<Index>& labels)
{
  const Matrix3 matrix = FrameMatrix(input);
  Polylines lines;
  std::array<std::int64_t, 4> cells{};
  for (const FuzzPiece& piece : input.Pieces)
  {
    const bool isOblique = piece.Axis == FuzzPiece::Oblique;
    if (piece.Vertices.empty() || (!isOblique && input.Has(static_cast<char>('X' + piece.Axis))))
    {
      continue;
    }
    for (const auto& vertex : piece.Vertices)
    {
      const Point3 point = Apply(matrix, VertexOf(piece, vertex));
      lines.X.push_back(Place(input, point[0]));
      lines.Y.push_back(Place(input, point[1]));
      lines.Z.push_back(Place(input, point[2]));
    }
    const int own = isOblique ? AnyPort : piece.Axis;
    const int port = input.Has('A') ? AnyPort : piece.Port >= 0 ? piece.Port : own;
    lines.Offsets.push_back(static_cast<Index>(lines.X.size()));
    lines.Closed.push_back(piece.Open ? 0 : 1);
    lines.From.Port.push_back(static_cast<std::int8_t>(port));
    lines.From.Block.push_back(0);
    lines.From.Cell.push_back(cells[port]++);
    labels.push_back(piece.Label >= 0 ? piece.Label : NoLabel);
  }
  return lines;
}

Options MakeOptions(const FuzzInput& input)
{
  Options options;
  options.Invalid = input.Has('M') ? InvalidContours::Mend : InvalidContours::LeaveOut;
  options.AtBorder = input.Has('K') ? BorderContours::LeaveOpen
    : input.Has('R')                ? BorderContours::Refuse
                                    : BorderContours::CloseAlong;
  options.SinglePrecision = input.Has('F');
  options.Orient = input.Has('D') ? Orientation::AsDrawn : Orientation::ByNesting;
  options.Crossing = input.Has('L') ? CrossingContours::LeaveOut : CrossingContours::Repair;
  options.Loops = input.Has('E') ? LoopRule::EvenOdd
    : input.Has('N')             ? LoopRule::NonZero
                                 : LoopRule::Union;
  options.Virtual = input.Has('V') ? VirtualSlices::Automatic : VirtualSlices::Off;
  options.Ends = input.Has('H') ? EndCaps::HalfSlice
    : input.Has('P')            ? EndCaps::Flat
                                : EndCaps::Dome;
  options.Central =
    input.Has('C') ? CentralPointMethod::Centroid : CentralPointMethod::LeastSquares;
  return options;
}

FrameOptions MakeFrameOptions(const FuzzInput& input, const Options& options)
{
  FrameOptions frame;
  frame.Choice = input.Has('G') ? FrameChoice::Given
    : input.Has('W')            ? FrameChoice::World
                                : FrameChoice::Automatic;
  const Matrix3 edges = Transpose(FrameMatrix(input));
  for (int axis = 0; axis < 3; ++axis)
  {
    frame.Given[axis] = Cross(edges[FirstAxis(axis)], edges[SecondAxis(axis)]);
  }
  frame.PlaneTolerance = options.PlaneTolerance;
  return frame;
}

//--------------------------------------------------------------------------------------------------
// Checks.

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

/// The length of the longest side of the box around the mesh.
double SizeOf(const TriangleMesh& mesh)
{
  double size = 0.0;
  for (const Point3& p : mesh.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      size = std::max(size, std::abs(p[axis] - mesh.Points.front()[axis]));
    }
  }
  return size;
}

/// Grid vertices on the wrong side (G3). On a contour, both sides are right.
std::string FindWrongSides(const Contours& contours, const SpatialGrid& grid,
  Orientation orientation, const TriangleMesh& mesh)
{
  const double reach =
    contours.Count() == 0 ? 0.0 : *std::max_element(grid.Step.begin(), grid.Step.end());
  const double tolerance = std::max(64.0 * reach, 1e-5 * SizeOf(mesh));
  for (const Point3& p : CheckGridVertices(mesh, contours, grid, orientation, 64, 1).Wrong)
  {
    if (!IsOnContour(contours, p, tolerance))
    {
      return "wrong side: (" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " +
        std::to_string(p[2]) + ")\n";
    }
  }
  return std::string();
}

/// What leaves its bounds (G7) along the axes of the frame. Where these are not those of the world,
/// the mesh was mapped there and back, by no more than rounding.
std::string FindExcess(const Contours& contours, const AxisFrame& frame, const Options& options,
  const TriangleMesh& mesh)
{
  if (frame.IsWorld())
  {
    return DescribeExcess(mesh, contours, options.SinglePrecision);
  }
  double largest = 0.0;
  for (const Point3& p : mesh.Points)
  {
    largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  const Point3 excess = FindExcess(mesh, contours, options.SinglePrecision);
  const bool isOutside = *std::max_element(excess.begin(), excess.end()) >
    64.0 * std::numeric_limits<double>::epsilon() * largest;
  return isOutside ? DescribeExcess(mesh, contours, options.SinglePrecision) : std::string();
}

/// Items one by one, the last one first.
Execution Backwards()
{
  Execution execution;
  execution.For = [](std::size_t count, const Execution::Range& run)
  {
    for (std::size_t i = count; i > 0; --i)
    {
      run(i - 1, i);
    }
  };
  return execution;
}

/// Whether another order of the work gives the same surface (G5).
bool IsSame(const TriangleMesh& mesh, const Reconstruction& other)
{
  const TriangleMesh second = other.Refused ? TriangleMesh() : MeshOf(other);
  return second.Points == mesh.Points && second.Triangles == mesh.Triangles;
}

/// Edges, vertices and triangles that meet (G1 to G3, G6). In axes that are not those of the world
/// the surface is embedded along them, exactly; in the world it is so but for rounding, which turns
/// slivers over.
std::string FindFlawsOf(
  const SortedSlices& sorted, const Options& settings, const TriangleMesh& mesh)
{
  if (sorted.Frame.IsWorld())
  {
    return DescribeFlaws(mesh);
  }
  std::ostringstream text;
  const SurfaceCheck check = CheckSurface(mesh);
  if (!check.IsClosedManifold())
  {
    text << check << "\n";
  }
  return text.str() + FindFlaws(sorted.Slices, settings);
}

/// One structure: what is wrong with its surface. `settings` get what its slices are read with.
std::string FindFaults(
  const SortedSlices& sorted, Options& settings, bool isTwice, SharedPatches& sharedTwice)
{
  const Reconstruction result = ReconstructSorted(SortedSlices(sorted), settings, Execution());
  const TriangleMesh mesh = result.Refused ? TriangleMesh() : MeshOf(result);
  std::string faults;
  if (isTwice)
  {
    Options again = settings;
    again.Patching.Shared = settings.Patching.Shared == nullptr ? nullptr : &sharedTwice;
    const Reconstruction other = ReconstructSorted(SortedSlices(sorted), again, Backwards());
    faults += IsSame(mesh, other) ? "" : "another surface if work is done in another order\n";
  }
  if (result.Refused)
  {
    return faults;
  }
  TriangleMesh along = mesh;
  for (Point3& p : along.Points)
  {
    p = sorted.Frame.IsWorld() ? p : sorted.Frame.ToAxes(p);
  }
  settings.Quantum = result.Grid.Quantum;
  SpatialGrid grid;
  const Contours contours = UsableContours(sorted.Slices, settings, grid);
  return faults + FindFlawsOf(sorted, settings, mesh) +
    FindExcess(contours, sorted.Frame, settings, along) +
    FindWrongSides(contours, grid, settings.Orient, along);
}

/// Prints an input with its faults, also as few slices along the axes of the frame, if these alone
/// have a fault, too.
[[noreturn]] void Fail(const FuzzInput& input, const SortedSlices& sorted, const Options& settings,
  const std::string& faults)
{
  std::cerr << WriteFuzzInput(input) << faults;
  Options alone = settings;
  alone.Patching.Shared = nullptr;
  std::cerr << "Along the axes" << (sorted.Frame.IsWorld() ? "" : " of the frame") << ":\n"
            << Describe(sorted.Slices, alone);
  if (!FindFlaws(sorted.Slices, alone).empty())
  {
    const PieceSets reduced = Reduce(sorted.Slices, alone, 300);
    std::cerr << "Reduced:\n" << Describe(reduced, alone) << FindFlaws(reduced, alone);
  }
  std::abort();
}

void Try(const FuzzInput& input, bool isTwice)
{
  std::vector<Index> labels;
  const Polylines lines = MakeLines(input, labels);
  Options options = MakeOptions(input);
  const SortedSlices sorted = SortByPlanes(lines, MakeFrameOptions(input, options));
  std::vector<SortedSlices> parts{ sorted };
  SharedPatches shared, sharedTwice;
  if (input.HasLabels())
  {
    parts = SplitByLabel(sorted, labels, FuzzInput::Labels);
    options.Patching.Shared = &shared;
  }
  for (const SortedSlices& part : parts)
  {
    Options settings = options;
    const std::string faults = FindFaults(part, settings, isTwice, sharedTwice);
    if (!faults.empty())
    {
      Fail(input, part, settings, faults);
    }
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
  FuzzInput input = ReadFuzzInput(std::string(reinterpret_cast<const char*>(data), size));
  for (std::size_t i = 1 + random.Below(4); i > 0; --i)
  {
    ChangeFuzzInput(input, random);
  }
  const std::string text = WriteFuzzInput(input);
  const std::size_t length = std::min(maximum, text.size());
  std::memcpy(data, text.data(), length);
  return length;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  // One in eight inputs is reconstructed twice; which ones depends on nothing but their bytes.
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    sum = 31 * sum + data[i];
  }
  Try(ReadFuzzInput(std::string(reinterpret_cast<const char*>(data), size)), sum % 8 == 0);
  return 0;
}
