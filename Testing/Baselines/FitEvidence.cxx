// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the weights of the evidence for joins, fitted to known surfaces
 *
 * Cuts the surfaces of Data by planes, as they are and turned, and takes all pairs of cycles of one
 * cell that may belong together. Two do if they bound one connected part of the surface in that
 * cell. Logistic regression gives the weights that make this most likely; they are printed beside
 * those in use.
 */

#include "LogisticRegression.h"
#include "PartsInCells.h"

#include "Core/Base/Vectors.h"
#include "Core/Cells/JoinEvidence.h"
#include "Core/Reconstruct.h"
#include "Support/NearestTriangle.h"
#include "Support/Random.h"
#include "Support/TextContours.h"
#include "Support/Vtk/DataSets.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

using namespace orthoslices;
using namespace orthoslices::baselines;
using namespace orthoslices::support;

namespace
{

const char* const Usage = R"(FitEvidence [options]
  --shapes A,B   only these of Data (all)
  --planes N,M   planes on each axis (16,32)
  --turns N      turned copies of each shape, besides the shape itself (3)
  --csv FILE     write the table of pairs, too
)";

struct Settings
{
  std::vector<std::string> Shapes;
  std::vector<int> Planes{ 16, 32 };
  int Turns = 3;
  std::string Csv;
};

/// A pair of cycles, and whether they bound one part of the surface.
struct Pair
{
  std::string Shape;
  int Planes, Turn;
  PairFeatures Features;
  bool Together;
};

constexpr int Count = 5; ///< weights to be fitted
const char* const Names[Count] = { "constant", "flatness D", "steepness T", "facing S",
  "distance d" };

//------------------------------------------------------------------------------
std::vector<std::string> Split(const std::string& list)
{
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  return parts;
}

Settings Parse(int argc, char* argv[])
{
  Settings settings;
  for (int i = 1; i < argc; i += 2)
  {
    const std::string option = argv[i];
    if (i + 1 == argc)
    {
      throw std::runtime_error("unknown option or no value: " + option);
    }
    const std::string value = argv[i + 1];
    if (option == "--shapes")
    {
      settings.Shapes = Split(value);
    }
    else if (option == "--planes")
    {
      settings.Planes.clear();
      for (const std::string& count : Split(value))
      {
        settings.Planes.push_back(std::stoi(count));
      }
    }
    else if (option == "--turns")
    {
      settings.Turns = std::stoi(value);
    }
    else if (option == "--csv")
    {
      settings.Csv = value;
    }
    else
    {
      throw std::runtime_error("unknown option: " + option);
    }
  }
  return settings;
}

//------------------------------------------------------------------------------
/// Turns all points by a random rotation; 0 is none.
void Turn(int turn, std::vector<Point3>& points)
{
  if (turn == 0)
  {
    return;
  }
  Random random(static_cast<std::uint64_t>(turn));
  const auto direction = [&]
  {
    Point3 d{ 0.0, 0.0, 0.0 };
    while (Dot(d, d) < 0.01 || Dot(d, d) > 1.0)
    {
      d = { random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0) };
    }
    return Unit(d);
  };
  const Point3 x = direction();
  const Point3 z = Unit(Cross(x, direction()));
  const Point3 y = Cross(z, x);
  for (Point3& p : points)
  {
    p = { Dot(x, p), Dot(y, p), Dot(z, p) };
  }
}

TriangleSurface ReadSurface(const DataSet& data, int turn)
{
  const TriangleMesh mesh = MeshOf(ReadTruth(data));
  TriangleSurface surface;
  surface.Points = mesh.Points;
  for (const auto& triangle : mesh.Triangles)
  {
    surface.Triangles.push_back({ static_cast<Index>(triangle[0]), static_cast<Index>(triangle[1]),
      static_cast<Index>(triangle[2]) });
  }
  Turn(turn, surface.Points);
  if (CloseSurface(surface).Kind != SurfaceProblemKind::None)
  {
    throw std::runtime_error(data.Name + " is not closed");
  }
  return surface;
}

/// Contours on `count` planes across each axis, at equal distances from half of one inside the box.
PieceSets Slice(const TriangleSurface& surface, int count)
{
  PieceSets sets = EmptySets();
  for (int axis = 0; axis < 3; ++axis)
  {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Point3& p : surface.Points)
    {
      low = std::min(low, p[axis]);
      high = std::max(high, p[axis]);
    }
    std::vector<double> planes;
    for (int i = 0; i < count; ++i)
    {
      planes.push_back(low + (i + 0.5) * (high - low) / count);
    }
    const auto slices = SliceSurface(surface, axis, planes, Precision::Double, Execution());
    for (int i = 0; i < count; ++i)
    {
      for (Index contour = 0; contour < slices[i].Count(); ++contour)
      {
        std::vector<std::array<double, 2>> vertices;
        for (Index v = slices[i].Offsets[contour]; v < slices[i].Offsets[contour + 1]; ++v)
        {
          vertices.push_back({ slices[i].U[v], slices[i].V[v] });
        }
        AddPiece(sets[axis], vertices, planes[i]);
      }
    }
  }
  return sets;
}

//------------------------------------------------------------------------------
/// Says which part of the surface a cycle bounds.
class Truth
{
public:
  Truth(const TriangleSurface& surface, const SpatialGrid& grid)
    : Parts(surface, grid)
    , Tree(TrianglesOf(surface))
  {
  }

  /// The part that most sides of the cycle lie on, which are cuts of its triangles.
  Index PartOf(const CycleGeometry& geometry, Index cycle)
  {
    const std::vector<Index> border = geometry.GetBorders({ cycle });
    std::map<Index, int> votes;
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      const Point3 middle = 0.5 *
        (geometry.Graph.PointAt(border[i]) +
          geometry.Graph.PointAt(border[(i + 1) % border.size()]));
      const auto triangle = static_cast<Index>(this->Tree.Find(middle).Triangle);
      ++votes[this->Parts.PartOf(triangle, geometry.Cycles.Cell[cycle])];
    }
    return std::max_element(
      votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
  }

private:
  static std::vector<NearestTriangle::Triangle> TrianglesOf(const TriangleSurface& surface)
  {
    std::vector<NearestTriangle::Triangle> triangles;
    for (const auto& t : surface.Triangles)
    {
      triangles.push_back({ surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]] });
    }
    return triangles;
  }

  PartsInCells Parts;
  NearestTriangle Tree;
};

/// Appends the pairs of one shape, cut by `planes` planes on each axis.
void AddPairs(const DataSet& data, int planes, int turn, std::vector<Pair>& pairs)
{
  const TriangleSurface surface = ReadSurface(data, turn);
  orthoslices::Options options;
  options.Orient = Orientation::AsDrawn;
  std::vector<Pair> found;
  Reconstruct(Slice(surface, planes), options, Execution(),
    [&](Stage stage, const StageTables& tables, const Reconstruction& result)
    {
      if (stage != Stage::FindJoins)
      {
        return;
      }
      found.clear();
      const CycleGeometry geometry = GeometryOf(result);
      Truth truth(surface, result.Grid);
      for (const MeasuredPair& pair :
        MeasurePairs({ geometry, result.Cells, tables.NodeNormals, result.Surface.CentralPoints }))
      {
        found.push_back({ data.Name, planes, turn, pair.Features,
          truth.PartOf(geometry, pair.First) == truth.PartOf(geometry, pair.Second) });
      }
    });
  pairs.insert(pairs.end(), found.begin(), found.end());
}

//------------------------------------------------------------------------------
Observation<Count> Observe(const Pair& pair)
{
  const PairFeatures& f = pair.Features;
  return { { 1.0, f.Flatness, f.Steepness, f.Facing, f.Distance / f.Step }, pair.Together };
}

/// How well log odds say what is true.
struct Quality
{
  int Right = 0, Missed = 0, Wrong = 0; ///< Missed: not joined, Wrong: joined
  double Surprise = 0.0;                ///< sum of -ln of the probability of what is true

  void Add(double logOdds, bool together)
  {
    this->Right += (logOdds > 0.0) == together ? 1 : 0;
    this->Missed += logOdds <= 0.0 && together ? 1 : 0;
    this->Wrong += logOdds > 0.0 && !together ? 1 : 0;
    this->Surprise += std::log1p(std::exp(together ? -logOdds : logOdds));
  }
};

void PrintQuality(const char* name, const Quality& quality, std::size_t count)
{
  std::printf("| %s | %.1f %% | %d | %d | %.3f |\n", name, 100.0 * quality.Right / count,
    quality.Missed, quality.Wrong, quality.Surprise / count);
}

/// Fits the weights to pairs with `loops` loops at most, and prints them.
void Fit(const char* title, const std::vector<Pair>& pairs, int loops)
{
  std::vector<Observation<Count>> observations;
  std::size_t together = 0;
  Quality inUse, fourOnly;
  const std::array<double, Count> weights{ JoinWeights.Constant, JoinWeights.Flatness,
    JoinWeights.Steepness, JoinWeights.Facing, JoinWeights.Distance };
  for (const Pair& pair : pairs)
  {
    if (pair.Features.Loops <= loops)
    {
      observations.push_back(Observe(pair));
      together += pair.Together ? 1 : 0;
      inUse.Add(EvidenceOf(pair.Features), pair.Together);
      fourOnly.Add(LogOdds<Count>(weights, observations.back().Features), pair.Together);
    }
  }
  const LogisticModel<Count> model = FitLogistic(observations);
  std::printf("\n%s: %zu pairs, %zu belong together%s\n\n", title, observations.size(), together,
    model.Converged ? "" : " (NOT CONVERGED)");
  std::printf("| weight | in use | fitted | standard error |\n|---|---|---|---|\n");
  for (int i = 0; i < Count; ++i)
  {
    std::printf(
      "| %s | %.1f | %.2f | %.2f |\n", Names[i], weights[i], model.Weights[i], model.Errors[i]);
  }
  Quality fitted;
  for (const Observation<Count>& each : observations)
  {
    fitted.Add(LogOdds<Count>(model.Weights, each.Features), each.Outcome);
  }
  std::printf(
    "\n| odds | right | missed | wrong | mean surprise (nats) |\n|---|---|---|---|---|\n");
  PrintQuality("in use, all features", inUse, observations.size());
  PrintQuality("in use, these features", fourOnly, observations.size());
  PrintQuality("fitted, these features", fitted, observations.size());
}

void WriteTable(const std::vector<Pair>& pairs, const std::string& file)
{
  std::ofstream out(file);
  out.precision(9);
  out << "shape,planes,turn,loops,flatness,steepness,facing,distance,disagreement,closeness,"
         "inequality,on_one_face,evidence,together\n";
  for (const Pair& pair : pairs)
  {
    const PairFeatures& f = pair.Features;
    out << pair.Shape << ',' << pair.Planes << ',' << pair.Turn << ',' << f.Loops << ','
        << f.Flatness << ',' << f.Steepness << ',' << f.Facing << ',' << f.Distance / f.Step << ','
        << f.Disagreement / f.Step << ',' << f.Closeness << ',' << f.Inequality << ','
        << f.OnOneFace << ',' << EvidenceOf(f) << ',' << pair.Together << '\n';
  }
  if (!out)
  {
    throw std::runtime_error("cannot write " + file);
  }
}

void Run(const Settings& settings)
{
  std::vector<Pair> pairs;
  std::printf("| shape | planes | pairs | belong together |\n|---|---|---|---|\n");
  for (const DataSet& data : AllDataSets())
  {
    if (!settings.Shapes.empty() &&
      std::find(settings.Shapes.begin(), settings.Shapes.end(), data.Name) == settings.Shapes.end())
    {
      continue;
    }
    for (const int planes : settings.Planes)
    {
      const std::size_t before = pairs.size();
      for (int turn = 0; turn <= settings.Turns; ++turn)
      {
        AddPairs(data, planes, turn, pairs);
      }
      const auto together = std::count_if(pairs.begin() + static_cast<std::ptrdiff_t>(before),
        pairs.end(), [](const Pair& pair) { return pair.Together; });
      std::printf("| %s | %d | %zu | %d |\n", data.Name.c_str(), planes, pairs.size() - before,
        static_cast<int>(together));
    }
  }
  Fit("Cycles of node points", pairs, 0);
  Fit("With isolated contours", pairs, 2);
  if (!settings.Csv.empty())
  {
    WriteTable(pairs, settings.Csv);
  }
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc == 2 && std::string(argv[1]) == "--help")
  {
    std::cout << Usage;
    return EXIT_SUCCESS;
  }
  try
  {
    Run(Parse(argc, argv));
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n' << Usage;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
