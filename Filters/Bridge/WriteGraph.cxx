// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/WriteGraph.h"

#include "Bridge/PointArrays.h"
#include "Core/Reconstruction.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>

namespace orthoslices
{
namespace
{
/// Values of the array "Kind" below those of RepairKind.
constexpr int NodeKind = 0;
constexpr int ArcKind = 1;
constexpr int IsolatedKind = 2;

/// How far each contour is from the others that it meets, as the table of contours has it, by the
/// number that arcs and isolated contours have of theirs (Reconstruction::ArcSources).
class ContourDisagreement
{
public:
  explicit ContourDisagreement(const Reconstruction& result);

  /// 0 for what has no source.
  double Of(std::int64_t source) const;

private:
  using Place = std::tuple<int, std::int64_t, std::int64_t>; ///< port, block and cell
  const PolylineSources& Sources;
  std::map<Place, double> Values;
};

ContourDisagreement::ContourDisagreement(const Reconstruction& result)
  : Sources(result.Sources)
{
  const ContourList& members = result.Members;
  for (std::size_t i = 0; i < members.Port.size(); ++i)
  {
    if (!members.IsVirtual(i))
    {
      // A contour made of several cells is listed under one of them, and several under the same.
      double& value = this->Values[{ members.Port[i], members.Block[i], members.Cell[i] }];
      value = std::max(value, result.Agreement.OfContour[i].RootMeanSquare());
    }
  }
}

double ContourDisagreement::Of(std::int64_t source) const
{
  if (source < 0 || source >= static_cast<std::int64_t>(this->Sources.Cell.size()))
  {
    return 0.0;
  }
  const auto found = this->Values.find(
    { this->Sources.Port[source], this->Sources.Block[source], this->Sources.Cell[source] });
  return found == this->Values.end() ? 0.0 : found->second;
}

/// Writes the cells of port 1 with their arrays: node points, repairs, arcs, isolated contours.
class GraphWriter
{
public:
  GraphWriter(const Reconstruction& result, vtkPolyData* graph);

  void AddNodes();
  void AddRepairs();
  void AddArcs(const Execution& execution);
  void AddIsolated();

private:
  void AddArc(Index arc, double length);
  /// The values of one cell, in the order of the arrays.
  struct Row
  {
    int Kind;
    double Disagreement;
    int Axis;
    int Plane;
    double Length;
    int Component;
    double RepairSize;
    double OfSlice;   ///< RMS disagreement of the slice; of a node point, its own
    double OfContour; ///< the same of the contour
    bool Virtual;     ///< an arc or contour of a virtual slice, or a node point on one
  };
  void AddRow(const Row& row);
  void ListIds(Index arc, std::vector<vtkIdType>& ids) const;
  double SumLength(const std::vector<vtkIdType>& ids) const;
  double OfSlice(int axis, Index plane) const
  {
    return this->Result.Agreement.OfPlane[axis][plane].RootMeanSquare();
  }

  const Reconstruction& Result;
  const ContourDisagreement Contours;
  const NodeGraph& Drawn; ///< with all vertices of contours
  vtkPolyData* Graph;
  GridEdgeCode Code;
  std::vector<vtkIdType> Ids; ///< points of the line that is being written
  vtkNew<vtkCellArray> Verts, Lines;
  vtkNew<vtkDoubleArray> Disagreement, Length;
  vtkNew<vtkFloatArray> RepairSize, SliceDisagreement, ContourDisagreements;
  vtkNew<vtkUnsignedCharArray> Kind, Virtual;
  vtkNew<vtkIntArray> SliceAxis, SlicePlane, ComponentId;
};

GraphWriter::GraphWriter(const Reconstruction& result, vtkPolyData* graph)
  : Result(result)
  , Contours(result)
  , Drawn(DrawnGraph(result))
  , Graph(graph)
  , Code(result.Grid)
{
  this->Kind->SetName("Kind");
  this->Disagreement->SetName("Disagreement");
  this->SliceAxis->SetName("SliceAxis");
  this->SlicePlane->SetName("SlicePlane");
  this->Length->SetName("Length");
  this->ComponentId->SetName("ComponentId");
  this->RepairSize->SetName("RepairSize");
  this->SliceDisagreement->SetName("SliceRmsDisagreement");
  this->ContourDisagreements->SetName("ContourRmsDisagreement");
  const vtkIdType cells = vtkIdType(this->Drawn.Nodes) + result.Crossings.Count() +
    result.Isolated.Count() + static_cast<vtkIdType>(result.Repairs.size());
  vtkDataArray* arrays[] = { this->Kind, this->Disagreement, this->SliceAxis, this->SlicePlane,
    this->Length, this->ComponentId, this->RepairSize, this->SliceDisagreement,
    this->ContourDisagreements };
  for (vtkDataArray* array : arrays)
  {
    array->Allocate(cells);
    graph->GetCellData()->AddArray(array);
  }
  // What is shown first has the colors of these: slices that agree little with the others stand out.
  graph->GetCellData()->SetScalars(this->SliceDisagreement);
  if (result.Grid.HasVirtual())
  {
    this->Virtual->SetName("Virtual");
    this->Virtual->Allocate(cells);
    graph->GetCellData()->AddArray(this->Virtual);
  }
  const vtkIdType ids = vtkIdType(this->Drawn.Count()) + 2 * vtkIdType(result.Crossings.Count());
  if (ids < std::numeric_limits<std::int32_t>::max())
  {
    this->Verts->Use32BitStorage();
    this->Lines->Use32BitStorage();
  }
  const vtkIdType verts = this->Drawn.Nodes + static_cast<vtkIdType>(result.Repairs.size());
  this->Verts->AllocateExact(verts, verts);
  this->Lines->AllocateExact(result.Crossings.Count() + result.Isolated.Count(),
    ids + result.Isolated.Count() + static_cast<vtkIdType>(result.Isolated.Points.size() / 3));
  graph->SetVerts(this->Verts);
  graph->SetLines(this->Lines);
}

void GraphWriter::AddRow(const Row& row)
{
  this->Kind->InsertNextValue(static_cast<unsigned char>(row.Kind));
  this->Disagreement->InsertNextValue(row.Disagreement);
  this->SliceAxis->InsertNextValue(row.Axis);
  this->SlicePlane->InsertNextValue(row.Plane);
  this->Length->InsertNextValue(row.Length);
  this->ComponentId->InsertNextValue(row.Component);
  this->RepairSize->InsertNextValue(static_cast<float>(row.RepairSize));
  this->SliceDisagreement->InsertNextValue(static_cast<float>(row.OfSlice));
  this->ContourDisagreements->InsertNextValue(static_cast<float>(row.OfContour));
  if (this->Result.Grid.HasVirtual())
  {
    this->Virtual->InsertNextValue(row.Virtual ? 1 : 0);
  }
}

void GraphWriter::AddNodes()
{
  for (vtkIdType node = 0; node < this->Drawn.Nodes; ++node)
  {
    this->Verts->InsertNextCell(1, &node);
    const Index index = static_cast<Index>(node);
    const double disagreement = this->Result.Nodes.Disagreement(index);
    const GridEdge edge =
      this->Code.Decode(this->Result.Crossings.Edge[this->Result.Nodes.First[index]]);
    this->AddRow({ NodeKind, disagreement, -1, -1, 0.0, this->Drawn.Component[index], 0.0,
      disagreement, disagreement, !AreReal(this->Result.Grid, edge) });
  }
}

void GraphWriter::AddRepairs()
{
  vtkIdType point =
    this->Graph->GetNumberOfPoints() - static_cast<vtkIdType>(this->Result.Repairs.size());
  for (const Repair& repair : this->Result.Repairs)
  {
    this->Verts->InsertNextCell(1, &point);
    ++point;
    this->AddRow({ static_cast<int>(repair.Kind), 0.0, repair.Axis, repair.Plane, 0.0, -1,
      repair.Size, 0.0, 0.0, false });
  }
}

double GraphWriter::SumLength(const std::vector<vtkIdType>& ids) const
{
  double length = 0.0;
  double a[3], b[3];
  for (std::size_t i = 1; i < ids.size(); ++i)
  {
    this->Graph->GetPoint(ids[i - 1], a);
    this->Graph->GetPoint(ids[i], b);
    length += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }
  return length;
}

/// The points of an arc, from node point to node point.
void GraphWriter::ListIds(Index arc, std::vector<vtkIdType>& ids) const
{
  const NodeGraph& graph = this->Drawn;
  ids.assign(1, this->Result.Nodes.NodeOf[arc]);
  for (Index i = 0; i < graph.PointCount(arc); ++i)
  {
    ids.push_back(graph.FirstPoint(arc) + i);
  }
  ids.push_back(this->Result.Nodes.NodeOf[this->Result.Crossings.Next[arc]]);
}

void GraphWriter::AddArc(Index arc, double length)
{
  const GridCrossings& crossings = this->Result.Crossings;
  this->ListIds(arc, this->Ids);
  this->Lines->InsertNextCell(static_cast<vtkIdType>(this->Ids.size()), this->Ids.data());
  const GridEdge edge = this->Code.Decode(crossings.Edge[arc]);
  const bool first = crossings.Family[arc] == 0;
  const int axis = first ? FirstAxis(edge.Direction) : SecondAxis(edge.Direction);
  const Index plane = first ? edge.First : edge.Second;
  this->AddRow({ ArcKind, 0.0, axis, plane, length,
    this->Result.Graph.Component[this->Result.Nodes.NodeOf[arc]], 0.0, this->OfSlice(axis, plane),
    this->Contours.Of(this->Result.ArcSources[arc]),
    IsVirtualSlice(this->Result.Grid, edge, crossings.Family[arc]) });
}

void GraphWriter::AddArcs(const Execution& execution)
{
  const GridCrossings& crossings = this->Result.Crossings;
  std::vector<double> lengths(static_cast<std::size_t>(crossings.Count()), 0.0);
  execution.For(lengths.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<vtkIdType> ids;
      for (Index arc = static_cast<Index>(begin); arc < static_cast<Index>(end); ++arc)
      {
        if (!crossings.IsRemoved(arc))
        {
          this->ListIds(arc, ids);
          lengths[arc] = this->SumLength(ids);
        }
      }
    });
  ForInOrder(execution, lengths.size(),
    [&](std::size_t i)
    {
      const Index arc = static_cast<Index>(i);
      if (!crossings.IsRemoved(arc))
      {
        this->AddArc(arc, lengths[i]);
      }
    });
}

void GraphWriter::AddIsolated()
{
  const IsolatedContours& isolated = this->Result.Isolated;
  for (Index i = 0; i < isolated.Count(); ++i)
  {
    this->Ids.clear();
    for (Index p = isolated.Offsets[i]; p < isolated.Offsets[i + 1]; ++p)
    {
      this->Ids.push_back(vtkIdType(this->Drawn.Count()) + p);
    }
    this->Ids.push_back(this->Ids.front());
    const vtkIdType count = static_cast<vtkIdType>(this->Ids.size());
    this->Lines->InsertNextCell(count, this->Ids.data());
    const Index loop = isolated.Loop[i];
    const int component =
      loop == IsolatedContours::None ? -1 : this->Drawn.Component[this->Drawn.Nodes + loop];
    this->AddRow({ IsolatedKind, 0.0, isolated.Axis[i], isolated.Plane[i],
      this->SumLength(this->Ids), component, 0.0,
      this->OfSlice(isolated.Axis[i], isolated.Plane[i]), this->Contours.Of(isolated.Source[i]),
      this->Result.Grid.IsVirtual(isolated.Axis[i], isolated.Plane[i]) });
  }
}
}

void WriteGraph(const Reconstruction& result, const Execution& execution, bool doublePrecision,
  vtkPolyData* graph)
{
  std::vector<double> others = result.Isolated.Points;
  for (const Repair& repair : result.Repairs)
  {
    others.insert(others.end(), repair.Where.begin(), repair.Where.end());
  }
  const NodeGraph& drawn = DrawnGraph(result);
  const vtkIdType graphPoints = drawn.Count();
  auto points = NewPoints(doublePrecision, graphPoints + static_cast<vtkIdType>(others.size() / 3));
  CopyPoints(drawn.Points, 0, execution, points);
  CopyPoints(others, graphPoints, execution, points);
  graph->SetPoints(points);
  GraphWriter writer(result, graph);
  writer.AddNodes();
  writer.AddRepairs();
  writer.AddArcs(execution);
  writer.AddIsolated();
}
}
