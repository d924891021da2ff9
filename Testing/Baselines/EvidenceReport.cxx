// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Evidence.h"

#include "Core/Correspondence/ContourEllipse.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <ostream>
#include <stdexcept>

namespace orthoslices
{
namespace baselines
{

using namespace support;

namespace
{

//------------------------------------------------------------------------------
std::string DescribeTopology(const CountedTopology& topology)
{
  const auto plural = [](std::int64_t count, const std::string& word)
  { return std::to_string(count) + ' ' + word + (count == 1 ? "" : "s"); };
  std::string text = plural(topology.Components, "component");
  if (topology.Genus > 0)
  {
    text += ", " + plural(topology.Genus, "handle");
  }
  return text;
}

//------------------------------------------------------------------------------
std::string Describe(const Verdict& verdict)
{
  if (verdict.Right)
  {
    return "**right**";
  }
  std::string text = DescribeTopology(verdict.Topology);
  if (verdict.Errors.Missing > 0)
  {
    text += "; " + std::to_string(verdict.Errors.Missing) + " missing";
  }
  if (verdict.Errors.Wrong > 0)
  {
    text += "; " + std::to_string(verdict.Errors.Wrong) + " wrong";
  }
  return text;
}

//------------------------------------------------------------------------------
void PrintHead(const std::string& first, std::ostream& out)
{
  out << "| " << first << " |";
  for (const CorrespondenceCriterion criterion : AllCriteria)
  {
    out << ' ' << NameOf(criterion) << " |";
  }
  out << " orthogonal slices (ours) |\n|---|---|---|---|---|---|\n";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SurfaceOf(const TriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point3& p : mesh.Points)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : mesh.Triangles)
  {
    const vtkIdType ids[3] = { triangle[0], triangle[1], triangle[2] };
    triangles->InsertNextCell(3, ids);
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ContoursOf(const ContourStack& stack)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (Index contour = 0; contour < stack.Count(); ++contour)
  {
    const Index begin = stack.Offsets[contour], end = stack.Offsets[contour + 1];
    lines->InsertNextCell(end - begin + 1);
    for (Index i = begin; i < end; ++i)
    {
      const double z = stack.Coordinate[stack.Slice[contour]];
      lines->InsertCellPoint(points->InsertNextPoint(stack.U[i], stack.V[i], z));
    }
    lines->InsertCellPoint(begin);
  }
  auto contours = vtkSmartPointer<vtkPolyData>::New();
  contours->SetPoints(points);
  contours->SetLines(lines);
  return contours;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> GraphOf(const Evidence& evidence, const Verdict& verdict)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const ContourStack& stack = evidence.Stack;
  const std::vector<ContourEllipse> ellipses = FitEllipses(stack);
  for (Index i = 0; i < stack.Count(); ++i)
  {
    points->InsertNextPoint(
      ellipses[i].Center[0], ellipses[i].Center[1], stack.Coordinate[stack.Slice[i]]);
  }
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkUnsignedCharArray> right;
  right->SetName("Right");
  for (const Correspondence& pair : verdict.Pairs)
  {
    const vtkIdType ids[2] = { pair.First, pair.Second };
    lines->InsertNextCell(2, ids);
    right->InsertNextValue(CountMistakes({ pair }, evidence.Truth).Wrong == 0 ? 1 : 0);
  }
  auto graph = vtkSmartPointer<vtkPolyData>::New();
  graph->SetPoints(points);
  graph->SetLines(lines);
  graph->GetCellData()->AddArray(right);
  return graph;
}

//------------------------------------------------------------------------------
void WriteFile(vtkPolyData* data, const std::string& folder, std::string name)
{
  name.erase(std::remove(name.begin(), name.end(), ','), name.end());
  std::replace(name.begin(), name.end(), ' ', '-');
  const std::string file = folder + '/' + name + ".vtp";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToBinary();
  writer->SetFileName(file.c_str());
  if (!writer->Write())
  {
    throw std::runtime_error("cannot write " + file);
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void PrintEvidence(const std::vector<Evidence>& all, std::ostream& out)
{
  PrintHead("object", out);
  for (const Evidence& evidence : all)
  {
    const Solid& solid = evidence.Object.Shape;
    out << "| " << evidence.Object.Family << ": " << solid.Name << " ("
        << DescribeTopology({ solid.Components, solid.Genus }) << ") |";
    for (const Verdict& verdict : evidence.Verdicts)
    {
      out << ' ' << Describe(verdict) << " |";
    }
    out << ' ' << (evidence.OrthogonalRight ? "**right**" : DescribeTopology(evidence.Orthogonal))
        << " |\n";
  }
}

//------------------------------------------------------------------------------
void PrintFamilies(const std::vector<Evidence>& all, std::ostream& out)
{
  PrintHead("family", out);
  std::map<char, std::array<int, AllCriteria.size() + 1>> right;
  std::map<char, int> objects;
  for (const Evidence& evidence : all)
  {
    auto& counts = right[evidence.Object.Family];
    ++objects[evidence.Object.Family];
    for (std::size_t i = 0; i < AllCriteria.size(); ++i)
    {
      counts[i] += evidence.Verdicts[i].Right ? 1 : 0;
    }
    counts.back() += evidence.OrthogonalRight ? 1 : 0;
  }
  for (const auto& [family, counts] : right)
  {
    out << "| " << family << " |";
    for (const int count : counts)
    {
      out << ' ' << count << " of " << objects[family] << " |";
    }
    out << '\n';
  }
}

//------------------------------------------------------------------------------
void WriteEvidence(const Evidence& evidence, const std::string& folder)
{
  const std::string name = evidence.Object.Family + ("-" + evidence.Object.Shape.Name);
  WriteFile(SurfaceOf(evidence.Surface), folder, name + "-surface");
  WriteFile(ContoursOf(evidence.Stack), folder, name + "-contours");
  for (std::size_t i = 0; i < AllCriteria.size(); ++i)
  {
    WriteFile(GraphOf(evidence, evidence.Verdicts[i]), folder, name + '-' + NameOf(AllCriteria[i]));
  }
}

} // namespace baselines
} // namespace orthoslices
