// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how the error of the surface falls with the number of planes
 *
 * Smooth solids are cut exactly by N planes on each axis, and their contours get vertices at fixed
 * parts of the spacing of the planes. Each point of the surfaces that the methods make of them is
 * compared with the nearest point of the solid: its distance, and the angle between the normals.
 * The order is the slope of a straight line through the logarithms: an error falls with N^-order.
 */

#include "Baseline.h"
#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/SliceSolid.h"
#include "Support/SmoothSolids.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "Core/Base/Vectors.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkOrthogonalSliceReconstruction.h"
#include "vtkPointData.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

using namespace orthoslices;
using namespace orthoslices::baselines;
using namespace orthoslices::support;

namespace
{

const char* const Usage = R"(CompareConvergence [options]
  --solids A,B        only these of torus, ellipsoid, gyroid, metaballs, knot
  --methods A,B       only these of smooth, fan, fan-centroid, coons and the baselines
  --planes N,M        planes on each axis (default 12,16,24,32,48,64)
  --baselines N       maximum planes for the baselines (default 32)
  --subdivisions N    parts of a slab in which contours get vertices (default 8)
  --csv FILE          write all figures, too
  --worst N           list the N points of each surface with the greatest errors
  --few-planes        instead, a solid of genus two with 14 planes in all
)";

struct Settings
{
  std::vector<std::string> Solids, Methods;
  std::vector<int> Planes{ 12, 16, 24, 32, 48, 64 };
  int MostForBaselines = 32;
  int Subdivisions = 8;
  int Worst = 0;
  std::string Csv;
};

struct Method
{
  std::string Name;
  bool IsBaseline;
  bool HasNormals; ///< better ones than those of its triangles
  std::function<vtkSmartPointer<vtkPolyData>(const SliceSets&)> Run;
};

/// What is measured of a surface.
enum Figure
{
  Rms,        ///< distance, weighted by the area around each point
  InnerRms,   ///< the same of points that are on no plane
  Max,        ///< distance
  NormalMean, ///< angle in radians, weighted by area
  NormalMax,
  FigureCount
};
const char* const FigureNames[] = { "RMS distance", "RMS distance inside patches", "max distance",
  "mean normal angle", "max normal angle" };
const char* const ColumnNames[] = { "rms", "inner_rms", "max", "normal_mean", "normal_max" };

struct Row
{
  std::string SolidName, MethodName;
  int Planes;
  double Spacing;
  std::int64_t Points, Triangles;
  std::array<double, FigureCount> Figures;
};

/// The error at a point of a surface.
struct PointError
{
  double Area = 0.0; ///< of the triangles around the point; zero if it belongs to none
  double Distance = 0.0;
  double Angle = 0.0;
  bool IsInner = true;
};

vtkSmartPointer<vtkPolyData> RunFilter(const SliceSets& slices, int type, int centralPoint)
{
  vtkNew<vtkOrthogonalSliceReconstruction> filter;
  filter->AutomaticAccuracyOff(); // the method's own error
  filter->SetPatchType(type);
  filter->SetCentralPoint(centralPoint);
  filter->ComputeNormalsOn();
  for (int axis = 0; axis < 3; ++axis)
  {
    filter->SetInputData(axis, slices.Families[axis]);
  }
  filter->Update();
  vtkSmartPointer<vtkPolyData> surface = filter->GetOutput();
  return surface;
}

std::vector<Method> AllMethods()
{
  using Filter = vtkOrthogonalSliceReconstruction;
  std::vector<Method> methods;
  const auto add = [&](const char* name, int type, int centralPoint)
  {
    methods.push_back({ name, false, type == Filter::SMOOTH,
      [=](const SliceSets& slices) { return RunFilter(slices, type, centralPoint); } });
  };
  add("smooth", Filter::SMOOTH, Filter::LEAST_SQUARES);
  add("coons", Filter::COONS, Filter::LEAST_SQUARES);
  add("fan", Filter::FAN, Filter::LEAST_SQUARES);
  add("fan-centroid", Filter::FAN, Filter::CENTROID);
  for (auto& baseline : MakeAllMethods())
  {
    if (baseline->Name().compare(0, 10, "orthogonal") != 0)
    {
      const std::shared_ptr<Baseline> shared = std::move(baseline);
      methods.push_back({ shared->Name(), true, false,
        [shared](const SliceSets& slices) { return shared->Reconstruct(slices); } });
    }
  }
  return methods;
}

SliceSets MakeSlices(const Solid& solid, const PlaneSets& planes, int subdivisions)
{
  const PieceSets pieces = SliceSolid(solid, planes, subdivisions, InPlaneGrid::Aligned);
  SliceSets slices;
  for (int axis = 0; axis < 3; ++axis)
  {
    slices.Families[axis] = MakePolyData(pieces[axis]);
  }
  return slices;
}

bool IsOnPlane(const Point3& p, const PlaneSets& planes)
{
  constexpr double tolerance = 1e-12;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto next =
      std::lower_bound(planes[axis].begin(), planes[axis].end(), p[axis] - tolerance);
    if (next != planes[axis].end() && *next <= p[axis] + tolerance)
    {
      return true;
    }
  }
  return false;
}

Point3 PlaceOf(vtkPolyData* surface, vtkIdType id)
{
  Point3 p;
  surface->GetPoint(id, p.data());
  return p;
}

/// Calls visit(cell, ids of the corners) for all triangles, of polygons and strips, too.
template <typename Visit>
void ForTriangles(vtkPolyData* surface, Visit&& visit)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, ids);
    const bool strip = surface->GetCellType(cell) == VTK_TRIANGLE_STRIP;
    for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType first = ids->GetId(strip ? i - 2 : 0);
      vtkIdType second = ids->GetId(i - 1), third = ids->GetId(i);
      if (strip && i % 2 == 1)
      {
        std::swap(second, third);
      }
      visit(cell, std::array<vtkIdType, 3>{ first, second, third });
    }
  }
}

std::vector<PointError> MeasurePoints(
  const SmoothSolid& solid, const PlaneSets& planes, bool hasNormals, vtkPolyData* surface)
{
  std::vector<PointError> errors(surface->GetNumberOfPoints());
  std::vector<Point3> normals(errors.size(), Point3{ 0.0, 0.0, 0.0 });
  ForTriangles(surface,
    [&](vtkIdType, const std::array<vtkIdType, 3>& ids)
    {
      const Point3 a = PlaceOf(surface, ids[0]);
      const Point3 area = 0.5 * Cross(PlaceOf(surface, ids[1]) - a, PlaceOf(surface, ids[2]) - a);
      for (const vtkIdType id : ids)
      {
        errors[id].Area += Length(area) / 3.0;
        normals[id] = normals[id] + area;
      }
    });
  vtkDataArray* own = hasNormals ? surface->GetPointData()->GetArray("Normals") : nullptr;
  for (std::size_t id = 0; id < errors.size(); ++id)
  {
    PointError& error = errors[id];
    if (error.Area == 0.0)
    {
      continue;
    }
    const Point3 p = PlaceOf(surface, id);
    Point3 normal;
    const Point3 q = solid.Project(p, normal);
    error.Distance = Length(p - q);
    if (own != nullptr)
    {
      own->GetTuple(id, normals[id].data());
    }
    error.Angle = std::atan2(Length(Cross(normals[id], normal)), Dot(normals[id], normal));
    error.IsInner = !IsOnPlane(p, planes);
  }
  return errors;
}

std::array<double, FigureCount> Summarize(const std::vector<PointError>& errors)
{
  std::array<double, FigureCount> figures{};
  double area = 0.0, innerArea = 0.0;
  for (const PointError& e : errors)
  {
    const double weighted = e.Area * e.Distance * e.Distance;
    area += e.Area;
    figures[Rms] += weighted;
    figures[NormalMean] += e.Area * e.Angle;
    figures[Max] = std::max(figures[Max], e.Area > 0.0 ? e.Distance : 0.0);
    figures[NormalMax] = std::max(figures[NormalMax], e.Area > 0.0 ? e.Angle : 0.0);
    if (e.IsInner)
    {
      innerArea += e.Area;
      figures[InnerRms] += weighted;
    }
  }
  figures[Rms] = std::sqrt(figures[Rms] / area);
  figures[InnerRms] = innerArea > 0.0 ? std::sqrt(figures[InnerRms] / innerArea) : 0.0;
  figures[NormalMean] /= area;
  return figures;
}

/// Places, cells and polygons of the greatest errors.
void ListWorst(const std::vector<PointError>& errors, int count, double spacing,
  vtkPolyData* surface, const std::function<double(const PointError&)>& figure)
{
  std::vector<vtkIdType> order(errors.size()), cellOf(errors.size(), -1);
  std::vector<int> degree(errors.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = static_cast<vtkIdType>(i);
  }
  count = std::min(count, static_cast<int>(order.size()));
  std::partial_sort(order.begin(), order.begin() + count, order.end(),
    [&](vtkIdType a, vtkIdType b) { return figure(errors[a]) > figure(errors[b]); });
  ForTriangles(surface,
    [&](vtkIdType cell, const std::array<vtkIdType, 3>& ids)
    {
      for (const vtkIdType id : ids)
      {
        cellOf[id] = cell;
        ++degree[id];
      }
    });
  for (int i = 0; i < count; ++i)
  {
    const vtkIdType id = order[i];
    const Point3 p = PlaceOf(surface, id);
    std::printf("  point %lld at %.4f %.4f %.4f, %d triangles, %s: distance %.3e = %.2e h, "
                "angle %.3e",
      static_cast<long long>(id), p[0], p[1], p[2], degree[id],
      errors[id].IsInner ? "inside" : "on a contour", errors[id].Distance,
      errors[id].Distance / spacing, errors[id].Angle);
    if (vtkDataArray* size = surface->GetCellData()->GetArray("PolygonSize"))
    {
      double cell[3];
      surface->GetCellData()->GetArray("GridCell")->GetTuple(cellOf[id], cell);
      std::printf(", polygon of %.0f in cell %.0f %.0f %.0f", size->GetTuple1(cellOf[id]), cell[0],
        cell[1], cell[2]);
    }
    std::printf("\n");
  }
}

Row Measure(const Settings& settings, const SmoothSolid& solid, const PlaneSets& planes,
  const SliceSets& slices, const Method& method)
{
  vtkSmartPointer<vtkPolyData> surface = method.Run(slices);
  const auto errors = MeasurePoints(solid, planes, method.HasNormals, surface);
  const int number = static_cast<int>(planes[0].size());
  const double spacing = (planes[0].back() - planes[0].front()) / (number - 1);
  if (settings.Worst > 0)
  {
    std::printf("%s, %s, %d planes\n", solid.Name.c_str(), method.Name.c_str(), number);
    ListWorst(
      errors, settings.Worst, spacing, surface, [](const PointError& e) { return e.Distance; });
    ListWorst(
      errors, settings.Worst, spacing, surface, [](const PointError& e) { return e.Angle; });
    std::fflush(stdout);
  }
  return { solid.Name, method.Name, number, spacing,
    std::count_if(errors.begin(), errors.end(), [](const PointError& e) { return e.Area > 0.0; }),
    surface->GetNumberOfCells(), Summarize(errors) };
}

/// The negative slope of the line through the logarithms; NaN if there are less than two.
double FitOrder(const std::vector<Row>& rows, Figure figure, int minPlanes)
{
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Row& row : rows)
  {
    if (row.Planes >= minPlanes && row.Figures[figure] > 0.0)
    {
      const double u = std::log(row.Planes), v = std::log(row.Figures[figure]);
      n += 1.0;
      x += u;
      y += v;
      xx += u * u;
      xy += u * v;
    }
  }
  return n < 2.0 ? NAN : -(n * xy - x * y) / (n * xx - x * x);
}

/// Rows of one solid, by methods in their order.
using RowsByMethod = std::vector<std::pair<std::string, std::vector<Row>>>;

RowsByMethod GroupByMethod(const std::vector<Row>& rows, const std::string& solid)
{
  RowsByMethod groups;
  for (const Row& row : rows)
  {
    if (row.SolidName != solid)
    {
      continue;
    }
    const auto group = std::find_if(groups.begin(), groups.end(),
      [&](const auto& candidate) { return candidate.first == row.MethodName; });
    (group != groups.end() ? *group : groups.emplace_back(row.MethodName, std::vector<Row>{}))
      .second.push_back(row);
  }
  return groups;
}

void PrintSolid(const std::vector<Row>& rows, const std::string& solid)
{
  std::printf("\n### %s\n\n| method | planes | points |", solid.c_str());
  for (const char* name : FigureNames)
  {
    std::printf(" %s |", name);
  }
  std::printf("\n|---|---|---|---|---|---|---|---|\n");
  for (const auto& group : GroupByMethod(rows, solid))
  {
    for (const Row& row : group.second)
    {
      std::printf("| %s | %d | %lld |", row.MethodName.c_str(), row.Planes,
        static_cast<long long>(row.Points));
      for (const double figure : row.Figures)
      {
        std::printf(" %.3e |", figure);
      }
      std::printf("\n");
    }
  }
}

void PrintSummary(const std::vector<Row>& rows, const std::vector<std::string>& solids)
{
  std::printf("\n### Orders: of all numbers of planes / of 24 and more\n\n| solid | method |");
  for (const char* name : FigureNames)
  {
    std::printf(" %s |", name);
  }
  std::printf("\n|---|---|---|---|---|---|---|\n");
  for (const std::string& solid : solids)
  {
    for (const auto& group : GroupByMethod(rows, solid))
    {
      std::printf("| %s | %s |", solid.c_str(), group.first.c_str());
      for (int figure = 0; figure < FigureCount; ++figure)
      {
        std::printf(" %.2f / %.2f |", FitOrder(group.second, static_cast<Figure>(figure), 0),
          FitOrder(group.second, static_cast<Figure>(figure), 24));
      }
      std::printf("\n");
    }
  }
}

void WriteCsv(const std::vector<Row>& rows, const std::string& name)
{
  std::ofstream file(name);
  file << "solid,method,planes,spacing,points,triangles";
  for (const char* column : ColumnNames)
  {
    file << "," << column;
  }
  file << "\n";
  for (const Row& row : rows)
  {
    file << row.SolidName << "," << row.MethodName << "," << row.Planes << "," << row.Spacing << ","
         << row.Points << "," << row.Triangles;
    for (const double figure : row.Figures)
    {
      file << "," << figure;
    }
    file << "\n";
  }
}

/// Mean distance of the triangles' middles, in per cent of the diagonal of the solid's box.
double MeanDistance(const SmoothSolid& solid, vtkPolyData* surface)
{
  double sum = 0.0, total = 0.0;
  ForTriangles(surface,
    [&](vtkIdType, const std::array<vtkIdType, 3>& ids)
    {
      const Point3 a = PlaceOf(surface, ids[0]), b = PlaceOf(surface, ids[1]),
                   c = PlaceOf(surface, ids[2]);
      const double area = Length(Cross(b - a, c - a));
      const Point3 middle = (1.0 / 3.0) * (a + b + c);
      Point3 normal;
      sum += area * Length(middle - solid.Project(middle, normal));
      total += area;
    });
  return 100.0 * sum / (total * Length(solid.High - solid.Low));
}

void CompareFewPlanes()
{
  const SmoothSolid solid = SmoothEight();
  std::printf("| planes | method | mean distance, %% of the diagonal | components | genus | ms |\n"
              "|---|---|---|---|---|---|\n");
  for (const std::array<int, 3>& count :
    { std::array<int, 3>{ 7, 4, 3 }, std::array<int, 3>{ 6, 5, 3 }, std::array<int, 3>{ 8, 4, 2 } })
  {
    PlaneSets planes = EqualPlanes(solid, count);
    const PieceSets pieces = SliceSolid(solid, planes, 24, InPlaneGrid::Free);
    for (const int type :
      { vtkOrthogonalSliceReconstruction::SMOOTH, vtkOrthogonalSliceReconstruction::FAN })
    {
      vtkNew<vtkOrthogonalSliceReconstruction> filter;
      filter->AutomaticAccuracyOff();
      filter->SetPatchType(type);
      filter->SetEdgeLength(0.1);
      for (int axis = 0; axis < 3; ++axis)
      {
        filter->SetInputData(axis, MakePolyData(pieces[axis]));
      }
      const auto start = std::chrono::steady_clock::now();
      filter->Update();
      const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      const SurfaceCheck check = CheckSurface(MeshOf(filter->GetOutput()));
      std::printf("| %d + %d + %d | %s | %.4f | %lld | %lld | %.0f |\n", count[0], count[1],
        count[2], type == vtkOrthogonalSliceReconstruction::SMOOTH ? "smooth" : "fan",
        MeanDistance(solid, filter->GetOutput()), static_cast<long long>(check.Components),
        static_cast<long long>(check.TotalGenus()), 1000.0 * seconds);
    }
  }
}

bool IsWanted(const std::vector<std::string>& names, const std::string& name)
{
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

void MeasureSolid(const Settings& settings, const SmoothSolid& solid, std::vector<Row>& rows)
{
  const std::vector<Method> methods = AllMethods();
  for (const int number : settings.Planes)
  {
    const PlaneSets planes = EqualPlanes(solid, { number, number, number });
    const SliceSets slices = MakeSlices(solid, planes, settings.Subdivisions);
    for (const Method& method : methods)
    {
      if (!IsWanted(settings.Methods, method.Name) ||
        (method.IsBaseline && number > settings.MostForBaselines))
      {
        continue;
      }
      try
      {
        rows.push_back(Measure(settings, solid, planes, slices, method));
      }
      catch (const std::exception& error)
      {
        std::cerr << solid.Name << ", " << method.Name << ", " << number
                  << " planes: " << error.what() << std::endl;
      }
    }
  }
}

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
  const std::map<std::string, std::function<void(const std::string&)>> options{
    { "--solids", [&](const std::string& value) { settings.Solids = Split(value); } },
    { "--methods", [&](const std::string& value) { settings.Methods = Split(value); } },
    { "--planes",
      [&](const std::string& value)
      {
        settings.Planes.clear();
        for (const std::string& number : Split(value))
        {
          settings.Planes.push_back(std::max(2, std::atoi(number.c_str())));
        }
      } },
    { "--baselines",
      [&](const std::string& value) { settings.MostForBaselines = std::atoi(value.c_str()); } },
    { "--subdivisions",
      [&](const std::string& value)
      { settings.Subdivisions = std::max(1, std::atoi(value.c_str())); } },
    { "--csv", [&](const std::string& value) { settings.Csv = value; } },
    { "--worst", [&](const std::string& value) { settings.Worst = std::atoi(value.c_str()); } },
  };
  for (int i = 1; i < argc; i += 2)
  {
    const auto option = options.find(argv[i]);
    if (option == options.end() || i + 1 == argc)
    {
      std::cout << Usage;
      std::exit(std::string(argv[i]) == "--help" ? EXIT_SUCCESS : EXIT_FAILURE);
    }
    option->second(argv[i + 1]);
  }
  return settings;
}

} // namespace

int main(int argc, char* argv[])
{
  vtkObject::GlobalWarningDisplayOff();
  if (argc == 2 && std::string(argv[1]) == "--few-planes")
  {
    CompareFewPlanes();
    return EXIT_SUCCESS;
  }
  const Settings settings = Parse(argc, argv);
  std::vector<Row> rows;
  std::vector<std::string> solids;
  for (const SmoothSolid& solid : AllSmoothSolids())
  {
    if (IsWanted(settings.Solids, solid.Name))
    {
      MeasureSolid(settings, solid, rows);
      PrintSolid(rows, solid.Name);
      std::fflush(stdout);
      solids.push_back(solid.Name);
    }
  }
  PrintSummary(rows, solids);
  if (!settings.Csv.empty())
  {
    WriteCsv(rows, settings.Csv);
  }
  return EXIT_SUCCESS;
}
