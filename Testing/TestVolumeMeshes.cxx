// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   mesh generators fill the surfaces with tetrahedra, and tell regions apart by the seeds
 */

#include "vtkOrthogonalSliceReconstruction.h"

#include "Support/AnalyticSolids.h"
#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/SharpestFold.h"
#include "Support/SliceSolid.h"
#include "Support/Vtk/DataSets.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkDoubleArray.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A program with its arguments, quietly. 0 if it ended well.
int RunProgram(const std::string& command)
{
  return std::system((command + " > /dev/null 2>&1").c_str());
}

/// Whether a program is installed; its package has its name.
bool IsThere(const std::string& program) { return RunProgram("command -v " + program) == 0; }

/// A folder of this test's own, which goes with it.
class Folder
{
public:
  Folder()
    : Path(std::filesystem::temp_directory_path() /
        (std::string("VolumeMeshes-") +
          ::testing::UnitTest::GetInstance()->current_test_info()->name()))
  {
    std::filesystem::create_directories(this->Path);
  }
  ~Folder() { std::filesystem::remove_all(this->Path); }
  Folder(const Folder&) = delete;
  void operator=(const Folder&) = delete;
  std::string File(const std::string& name) const { return (this->Path / name).string(); }

private:
  std::filesystem::path Path;
};

double ValueAt(vtkTable* table, const char* column, vtkIdType row)
{
  return vtkDoubleArray::SafeDownCast(table->GetColumnByName(column))->GetValue(row);
}

/// TetGen's format: points, triangles, holes, and regions with their numbers, which are those of
/// the components. Seeds of cavities are holes.
void WriteForTetGen(const TriangleMesh& mesh, vtkTable* components, const std::string& name)
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
  for (const bool isHole : { true, false })
  {
    std::ostringstream seeds;
    int count = 0;
    for (vtkIdType row = 0; row < components->GetNumberOfRows(); ++row)
    {
      if ((ValueAt(components, "Volume", row) < 0.0) == isHole)
      {
        seeds << count++ << std::setprecision(17);
        for (const char* column : { "SeedX", "SeedY", "SeedZ" })
        {
          seeds << " " << ValueAt(components, column, row);
        }
        seeds << (isHole ? std::string() : " " + std::to_string(row)) << "\n";
      }
    }
    file << count << "\n" << seeds.str();
  }
}

/// The triangles in STL format, as text with as many digits as float has.
void WriteStl(const TriangleMesh& mesh, const std::string& name)
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

/// The volumes of the tetrahedra of each region that TetGen wrote.
std::map<int, double> VolumesOfRegions(const std::string& name)
{
  std::ifstream nodes(name + ".1.node"), elements(name + ".1.ele");
  std::size_t count = 0, number = 0, dimension, attributes, marks;
  nodes >> count >> dimension >> attributes >> marks;
  std::vector<Point3> points(count);
  for (Point3& p : points)
  {
    nodes >> number >> p[0] >> p[1] >> p[2];
    for (std::size_t i = 0; i < attributes + marks; ++i)
    {
      double ignored;
      nodes >> ignored;
    }
  }
  std::map<int, double> volumes;
  elements >> count >> dimension >> attributes;
  for (std::size_t i = 0; i < count; ++i)
  {
    std::array<std::size_t, 4> corners;
    double region = -1.0;
    elements >> number >> corners[0] >> corners[1] >> corners[2] >> corners[3];
    if (attributes > 0)
    {
      elements >> region;
    }
    std::array<Point3, 3> sides;
    for (int k = 0; k < 3; ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        sides[k][axis] = points[corners[k + 1]][axis] - points[corners[0]][axis];
      }
    }
    const auto& [a, b, c] = sides;
    volumes[static_cast<int>(region)] +=
      std::abs(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
        a[2] * (b[0] * c[1] - b[1] * c[0])) /
      6.0;
  }
  return volumes;
}

const DataSet& DataNamed(const std::string& name)
{
  static const std::vector<DataSet> all = AllDataSets();
  return *std::find_if(
    all.begin(), all.end(), [&](const DataSet& data) { return data.Name == name; });
}

/// A mesh of good tetrahedra by TetGen; false if it fails. Files are named `name`.
bool MeshWithTetGen(FilterRun& run, const std::string& name)
{
  auto* components = vtkTable::SafeDownCast(run.Filter->GetOutputDataObject(7));
  WriteForTetGen(MeshOf(run.Filter->GetOutput()), components, name + ".smesh");
  return RunProgram("tetgen -pq1.4A " + name + ".smesh") == 0;
}
}

//----------------------------------------------------------------------------
TEST(VolumeMeshes, TetGenFillsTheBodyAndLeavesTheCavityOut)
{
  if (!IsThere("tetgen"))
  {
    GTEST_SKIP() << "tetgen was not found";
  }
  const Solid solid = HollowBall();
  FilterRun run(SliceSolid(solid, EqualPlanes(solid, { 16, 16, 16 }), 6, InPlaneGrid::Free));
  run.Update();
  ASSERT_EQ(FieldValue(run.Filter->GetOutput(), "NumberOfComponents"), 2);
  const Folder folder;
  ASSERT_TRUE(MeshWithTetGen(run, folder.File("ball")));
  const std::map<int, double> volumes = VolumesOfRegions(folder.File("ball"));
  const double body = CheckSurface(MeshOf(run.Filter->GetOutput())).TotalVolume();
  ASSERT_EQ(volumes.size(), 1u);
  EXPECT_NEAR(volumes.begin()->second, body, 1e-6 * body);
}

//----------------------------------------------------------------------------
/// Mesh generators refuse triangles that lie on each other, or fill what is between with thousands.
TEST(VolumeMeshes, NoTrianglesLieOnEachOther)
{
  for (const char* name :
    { "aorta", "boot", "heart", "knot", "lbl_lumbar3", "lbl_stomach", "neuron", "pelvis", "skull" })
  {
    SCOPED_TRACE(name);
    FilterRun run(ReadPieceSets(DataNamed(name), 16));
    run.Update();
    EXPECT_GT(SharpestFold(MeshOf(run.Filter->GetOutput())), 9.9);
  }
}

//----------------------------------------------------------------------------
/// Where the ends of a side that is tiny cannot become one, nothing is split around it: else there would
/// be a thousand triangles more at one place, and smaller ones.
TEST(VolumeMeshes, TrianglesDoNotGatherAtTinySides)
{
  FilterRun run(ReadPieceSets(DataNamed("neuron"), 32));
  run.Update();
  EXPECT_LT(run.Filter->GetOutput()->GetNumberOfPolys(), 10000);
}

//----------------------------------------------------------------------------
/// Shapes of the data folder, thin ones among them.
TEST(VolumeMeshes, TetGenFillsShapesOfTheDataFolder)
{
  if (!IsThere("tetgen"))
  {
    GTEST_SKIP() << "tetgen was not found";
  }
  for (const char* name : { "aorta", "heart", "lbl_lumbar3", "lbl_stomach", "neuron" })
  {
    SCOPED_TRACE(name);
    FilterRun run(ReadPieceSets(DataNamed(name), 16));
    run.Update();
    const Folder folder;
    ASSERT_TRUE(MeshWithTetGen(run, folder.File(name)));
    double sum = 0.0;
    for (const auto& volume : VolumesOfRegions(folder.File(name)))
    {
      sum += volume.second;
    }
    const double body = CheckSurface(MeshOf(run.Filter->GetOutput())).TotalVolume();
    EXPECT_NEAR(sum, body, 1e-6 * body);
  }
}

//----------------------------------------------------------------------------
TEST(VolumeMeshes, GmshFillsShapesOfTheDataFolder)
{
  if (!IsThere("gmsh"))
  {
    GTEST_SKIP() << "gmsh was not found";
  }
  for (const char* name : { "heart", "lbl_lumbar3", "lbl_stomach" })
  {
    SCOPED_TRACE(name);
    FilterRun run(ReadPieceSets(DataNamed(name), 16));
    run.Update();
    const Folder folder;
    WriteStl(MeshOf(run.Filter->GetOutput()), folder.File("shape.stl"));
    std::ofstream(folder.File("shape.geo"))
      << "Merge \"shape.stl\";\nSurface Loop(1) = {1};\nVolume(1) = {1};\n";
    ASSERT_EQ(
      RunProgram("cd " + folder.File("") + " && gmsh -3 -format msh2 -o shape.msh shape.geo"), 0);
    std::ifstream mesh(folder.File("shape.msh"));
    std::string word;
    std::int64_t elements = 0;
    while (mesh >> word && word != "$Elements")
    {
    }
    mesh >> elements;
    EXPECT_GT(elements, 2 * run.Filter->GetOutput()->GetNumberOfPolys());
  }
}
