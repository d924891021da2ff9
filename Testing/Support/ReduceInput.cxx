// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/ReduceInput.h"

#include "Support/CheckBounds.h"
#include "Support/CheckEmbedding.h"
#include "Support/ReconstructionMesh.h"
#include "Support/Stages.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace orthoslices
{
namespace support
{
namespace
{
struct Vertex
{
  double U, V, W;
};

struct Piece
{
  int Axis;
  std::uint8_t Closed;
  std::vector<Vertex> Vertices;
};

std::vector<Piece> TakeApart(const PieceSets& sets)
{
  std::vector<Piece> list;
  for (const Pieces& pieces : sets)
  {
    for (Index i = 0; i < pieces.Count(); ++i)
    {
      list.push_back({ pieces.Axis, pieces.Closed[i], {} });
      for (Index v = pieces.Offsets[i]; v < pieces.Offsets[i + 1]; ++v)
      {
        list.back().Vertices.push_back({ pieces.U[v], pieces.V[v], pieces.W[v] });
      }
    }
  }
  return list;
}

PieceSets PutTogether(const std::vector<Piece>& list)
{
  PieceSets sets = EmptySets();
  for (const Piece& piece : list)
  {
    Pieces& pieces = sets[piece.Axis];
    for (const Vertex& vertex : piece.Vertices)
    {
      pieces.U.push_back(vertex.U);
      pieces.V.push_back(vertex.V);
      pieces.W.push_back(vertex.W);
    }
    pieces.Offsets.push_back(static_cast<Index>(pieces.U.size()));
    pieces.Cell.push_back(pieces.Count());
    pieces.Closed.push_back(piece.Closed);
  }
  return sets;
}

class Reducer
{
public:
  Reducer(const PieceSets& sets, const Options& options, int trials)
    : Settings(options)
    , List(TakeApart(sets))
    , Left(trials)
  {
  }

  PieceSets Run()
  {
    std::size_t before;
    do
    {
      before = this->Size();
      this->DropPieces();
      this->DropVertices();
    } while (this->Size() < before && this->Left > 0);
    this->Shorten();
    return PutTogether(this->List);
  }

private:
  std::size_t Size() const
  {
    std::size_t size = this->List.size();
    for (const Piece& piece : this->List)
    {
      size += piece.Vertices.size();
    }
    return size;
  }

  /// Keeps the smaller list if it fails, too.
  bool Try(std::vector<Piece>&& smaller)
  {
    if (this->Left-- <= 0 || FindFlaws(PutTogether(smaller), this->Settings).empty())
    {
      return false;
    }
    this->List = std::move(smaller);
    return true;
  }

  /// Removes ranges of items, long ones first.
  template <typename Items>
  void DropRanges(std::size_t count, Items&& items)
  {
    for (std::size_t range = std::max<std::size_t>(1, count / 2); range > 0; range /= 2)
    {
      for (std::size_t i = 0; i + range <= items(this->List).size();)
      {
        std::vector<Piece> smaller = this->List;
        auto& all = items(smaller);
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(i),
          all.begin() + static_cast<std::ptrdiff_t>(i + range));
        i += this->Try(std::move(smaller)) ? 0 : 1;
      }
    }
  }

  void DropPieces()
  {
    this->DropRanges(
      this->List.size(), [](std::vector<Piece>& list) -> std::vector<Piece>& { return list; });
  }

  void DropVertices()
  {
    for (std::size_t p = 0; p < this->List.size(); ++p)
    {
      this->DropRanges(this->List[p].Vertices.size(),
        [p](std::vector<Piece>& list) -> std::vector<Vertex>& { return list[p].Vertices; });
    }
  }

  /// Few digits where these do as well.
  void Shorten()
  {
    for (std::size_t p = 0; p < this->List.size(); ++p)
    {
      for (std::size_t v = 0; v < this->List[p].Vertices.size(); ++v)
      {
        for (double Vertex::*coordinate : { &Vertex::U, &Vertex::V })
        {
          bool done = false;
          for (double unit = 1.0; !done && unit > 1e-5; unit *= 0.1)
          {
            std::vector<Piece> simpler = this->List;
            double& x = simpler[p].Vertices[v].*coordinate;
            const double old = x;
            x = std::round(x / unit) * unit;
            done = x == old || this->Try(std::move(simpler));
          }
        }
      }
    }
  }

  Options Settings;
  std::vector<Piece> List;
  int Left;
};
}

std::string FindFlaws(const PieceSets& sets, const Options& options)
{
  const Reconstruction result = Reconstruct(PieceSets(sets), options, Execution());
  if (result.Refused)
  {
    return std::string();
  }
  SpatialGrid grid;
  const TriangleMesh mesh = MeshOf(result);
  return DescribeFlaws(mesh) +
    DescribeExcess(mesh, UsableContours(sets, options, grid), options.SinglePrecision);
}

PieceSets Reduce(PieceSets sets, const Options& options, int trials)
{
  return Reducer(sets, options, trials).Run();
}

std::string Describe(const PieceSets& sets, const Options& options)
{
  std::ostringstream text;
  text << "// " << (options.SinglePrecision ? "float" : "double")
       << (options.Orient == Orientation::AsDrawn ? ", as drawn" : ", by nesting")
       << (options.Crossing == CrossingContours::Repair      ? ", repair"
              : options.Crossing == CrossingContours::Refuse ? ", refuse"
                                                             : ", leave out")
       << (options.Loops == LoopRule::Union        ? ""
              : options.Loops == LoopRule::EvenOdd ? ", even-odd"
                                                   : ", non-zero")
       << (options.Central == CentralPointMethod::Centroid ? ", centroid" : ", least squares")
       << (options.Virtual == VirtualSlices::Off ? "" : ", virtual slices")
       << (options.Invalid == InvalidContours::Refuse        ? ", refuse invalid"
              : options.Invalid == InvalidContours::LeaveOut ? ", leave invalid out"
                                                             : ", mend invalid")
       << "\n"
       << ToText(sets);
  return text.str();
}

} // namespace support
} // namespace orthoslices
