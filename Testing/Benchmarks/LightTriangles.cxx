// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * All triangles against few, as *Automatic Accuracy* makes them: how many, how well shaped, how
 * accurate and how fast.
 *
 *   LightTriangles [--planes N,...] [--families xyz,...] [--samples N] [--stages]
 *     [--accuracy VALUE] [--keep] [--write FOLDER] FOLDER ...
 *
 * A folder has contours in nN_x.vtp, nN_y.vtp and nN_z.vtp for N planes per axis, and the surface
 * that they are cuts of in truth.vtp. One row for each folder, number of planes and choice of
 * families. RMS distances from the truth are in mean plane spacings; a fold is the angle between two
 * triangles at a common side; seconds are those of one
 * thread, from contours to triangles in memory. Crossings are those of the few triangles, decided
 * exactly. --stages prints the seconds of each stage, of all and of few triangles; --accuracy takes
 * this *Accuracy* instead of the automatic one, --keep is *Keep Contour Vertices*. --write leaves
 * the few triangles as NAME-N.smesh for TetGen and NAME-N.stl, text of nine digits, for Gmsh.
 */

#include "Bridge/ReadPieces.h"
#include "Core/ReconstructSorted.h"
#include "Core/Surface/TriangleMeasures.h"
#include "Support/CheckEmbedding.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SharpestFold.h"
#include "Support/Vtk/SurfaceMetrics.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkXMLPolyDataReader.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
struct Arguments
{
  std::vector<std::string> Planes{ "16", "32" };
  std::vector<std::string> Families{ "xyz" };
  std::vector<std::filesystem::path> Folders;
  std::filesystem::path Written; ///< folder for the few triangles; empty: none
  std::int64_t Samples = 30000;
  double Accuracy = 0.0; ///< 0: automatic
  bool Keep = false;
  bool Stages = false;

  /// Of the surface with few triangles, or with all.
  PatchOptions Patching(bool isLight) const
  {
    PatchOptions patching;
    patching.OwnAccuracy = isLight && !(this->Accuracy > 0.0);
    patching.Accuracy = isLight ? this->Accuracy : 0.0;
    patching.KeepContours = isLight && this->Keep;
    return patching;
  }
};

std::vector<std::string> Split(const char* text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  return parts;
}

vtkSmartPointer<vtkPolyData> Read(const std::filesystem::path& file)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> PolyDataOf(const TriangleMesh& mesh)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point3& point : mesh.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : mesh.Triangles)
  {
    const vtkIdType ids[3] = { triangle[0], triangle[1], triangle[2] };
    triangles->InsertNextCell(3, ids);
  }
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

/// A surface, and what is printed of it.
struct Run
{
  TriangleMesh Mesh;
  TriangleQuality Quality;
  double Distance = 0.0;
  double Seconds = 0.0;
  std::map<Stage, double> Stages;
};

Run Reconstruct(
  const Polylines& lines, const PatchOptions& patching, vtkPolyData* truth, std::int64_t samples)
{
  Run run;
  Options options;
  options.Patching = patching;
  const std::clock_t start = std::clock();
  std::clock_t last = start;
  const Reconstruction result =
    ReconstructSorted(SortByPlanes(lines, FrameOptions()), options, Execution(),
      [&](Stage stage, const StageTables&, const Reconstruction&)
      {
        const std::clock_t now = std::clock();
        run.Stages[stage] += double(now - last) / CLOCKS_PER_SEC;
        last = now;
      });
  run.Seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  run.Mesh = MeshOf(result);
  std::vector<double> points;
  std::vector<long long> ids;
  for (const Point3& point : run.Mesh.Points)
  {
    points.insert(points.end(), point.begin(), point.end());
  }
  for (const auto& triangle : run.Mesh.Triangles)
  {
    ids.insert(ids.end(), triangle.begin(), triangle.end());
  }
  run.Quality = MeasureQuality(
    points.data(), ids.data(), static_cast<std::int64_t>(run.Mesh.Triangles.size()), Execution());
  const auto deviation = MeasureDeviation(PolyDataOf(run.Mesh), truth, samples);
  run.Distance = deviation ? deviation->RootMeanSquare / MinMeanSpacing(result.Grid) : 0.0;
  return run;
}

void PrintRow(const std::string& name, const Run& all, const Run& few)
{
  const auto count = [](const Run& run) { return run.Mesh.Triangles.size(); };
  std::printf("| %s | %zu | %zu | %.2f | %.3f | %.2f | %.1f → %.1f | %.1g → %.2g | %.2g → %.2g | "
              "%.2g → %.2g | %.2f → %.2f | %.2f | %zu |\n",
    name.c_str(), count(all), count(few), double(count(few)) / double(count(all)), all.Distance,
    few.Distance / all.Distance, 100.0 * all.Quality.ShareAbove20Degrees,
    100.0 * few.Quality.ShareAbove20Degrees, all.Quality.SmallestAngle, few.Quality.SmallestAngle,
    all.Quality.LargestAspectRatio, few.Quality.LargestAspectRatio, SharpestFold(all.Mesh),
    SharpestFold(few.Mesh), all.Seconds, few.Seconds, few.Seconds / all.Seconds,
    FindMeetings(few.Mesh).size());
  std::fflush(stdout);
}

void PrintStages(const Run& all, const Run& few)
{
  for (const auto& [stage, seconds] : all.Stages)
  {
    const auto found = few.Stages.find(stage);
    std::printf("  %-24s %8.3f %8.3f\n", NameOf(stage), seconds,
      found == few.Stages.end() ? 0.0 : found->second);
  }
}

Polylines ReadFamilies(
  const std::filesystem::path& folder, const std::string& planes, const std::string& families)
{
  Polylines lines;
  for (int axis = 0; axis < 3; ++axis)
  {
    const char letter = static_cast<char>('x' + axis);
    if (families.find(letter) != std::string::npos)
    {
      ReadPieces(Read(folder / ("n" + planes + "_" + letter + ".vtp")), axis, true, lines);
    }
  }
  return lines;
}

/// The file format of TetGen: points, triangles, no holes and no regions.
void WriteForTetGen(const TriangleMesh& mesh, const std::filesystem::path& name)
{
  std::ofstream file(name);
  file << std::setprecision(17) << mesh.Points.size() << " 3 0 0\n";
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const Point3& p = mesh.Points[i];
    file << i << " " << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  file << mesh.Triangles.size() << " 0\n";
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    file << "3 " << a << " " << b << " " << c << "\n";
  }
  file << "0\n0\n";
}

/// Text with as many digits as float has.
void WriteStl(const TriangleMesh& mesh, const std::filesystem::path& name)
{
  std::ofstream file(name);
  file << std::setprecision(9) << "solid\n";
  for (const auto& triangle : mesh.Triangles)
  {
    file << "facet normal 0 0 0\nouter loop\n";
    for (const std::int64_t corner : triangle)
    {
      const Point3& p = mesh.Points[corner];
      file << "vertex " << p[0] << " " << p[1] << " " << p[2] << "\n";
    }
    file << "endloop\nendfacet\n";
  }
  file << "endsolid\n";
}

void RunFolder(const std::filesystem::path& folder, const Arguments& arguments)
{
  const auto truth = Read(folder / "truth.vtp");
  for (const std::string& planes : arguments.Planes)
  {
    for (const std::string& families : arguments.Families)
    {
      const Polylines lines = ReadFamilies(folder, planes, families);
      const Run all = Reconstruct(lines, arguments.Patching(false), truth, arguments.Samples);
      const Run few = Reconstruct(lines, arguments.Patching(true), truth, arguments.Samples);
      const std::string of = families == "xyz" ? "" : " " + families;
      const std::string shape = folder.filename().string();
      PrintRow(shape + ", " + planes + of, all, few);
      if (!arguments.Written.empty())
      {
        const std::string name = shape + "-" + planes + (of.empty() ? of : "-" + families);
        WriteForTetGen(few.Mesh, arguments.Written / (name + ".smesh"));
        WriteStl(few.Mesh, arguments.Written / (name + ".stl"));
      }
      if (arguments.Stages)
      {
        PrintStages(all, few);
      }
    }
  }
}

Arguments Parse(int argc, char* argv[])
{
  Arguments arguments;
  for (int i = 1; i < argc; ++i)
  {
    const std::string option = argv[i];
    const bool hasValue = i + 1 < argc;
    if (option == "--planes" && hasValue)
    {
      arguments.Planes = Split(argv[++i]);
    }
    else if (option == "--families" && hasValue)
    {
      arguments.Families = Split(argv[++i]);
    }
    else if (option == "--samples" && hasValue)
    {
      arguments.Samples = std::atoll(argv[++i]);
    }
    else if (option == "--accuracy" && hasValue)
    {
      arguments.Accuracy = std::atof(argv[++i]);
    }
    else if (option == "--write" && hasValue)
    {
      arguments.Written = argv[++i];
      std::filesystem::create_directories(arguments.Written);
    }
    else if (option == "--keep")
    {
      arguments.Keep = true;
    }
    else if (option == "--stages")
    {
      arguments.Stages = true;
    }
    else
    {
      arguments.Folders.emplace_back(option);
    }
  }
  return arguments;
}
}

int main(int argc, char* argv[])
{
  const Arguments arguments = Parse(argc, argv);
  if (arguments.Folders.empty())
  {
    std::fprintf(stderr,
      "usage: %s [--planes N,...] [--families xyz,...] [--samples N] [--stages]\n"
      "  [--accuracy VALUE] [--keep] [--write FOLDER] FOLDER ...\n",
      argv[0]);
    return 2;
  }
  std::printf(
    "| shape, planes | all | few | share | RMS of all | × | above 20°, %% | smallest "
    "angle, degrees | largest aspect ratio | sharpest fold, degrees | seconds | × | crossings |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::filesystem::path& folder : arguments.Folders)
  {
    RunFolder(folder, arguments);
  }
  return 0;
}
