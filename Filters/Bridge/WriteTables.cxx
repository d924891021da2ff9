// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/WriteTables.h"

#include "Bridge/AddColumn.h"
#include "Bridge/DescribeProblems.h"
#include "Bridge/DescribeReport.h"
#include "Core/Reconstruction.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <sstream>
#include <string>

namespace orthoslices
{
namespace
{
/// As users name a slice: "y = 0.25".
std::string NameOfSlice(int axis, double coordinate)
{
  std::ostringstream text;
  text << AxisNames[axis] << " = " << coordinate;
  return text.str();
}

const char* NameOfKind(UndecidedKind kind)
{
  return kind == UndecidedKind::TwoCycles    ? "two openings"
    : kind == UndecidedKind::IsolatedContour ? "isolated contour"
                                             : "two isolated contours";
}

const char* NameOfChoice(UndecidedChoice choice)
{
  return choice == UndecidedChoice::Joined ? "joined"
    : choice == UndecidedChoice::Separate  ? "separate"
                                           : "separate, as joined parts would cross";
}
}

void WriteHistogram(const Reconstruction& result, vtkTable* table)
{
  const std::vector<Index>& histogram = result.PolygonSizes;
  auto* size = AddColumn<vtkIdTypeArray>(table, "PolygonSize");
  auto* count = AddColumn<vtkIdTypeArray>(table, "Count");
  const auto smallest =
    std::find_if(histogram.begin(), histogram.end(), [](Index n) { return n > 0; });
  for (auto i = smallest; i != histogram.end(); ++i)
  {
    size->InsertNextValue(i - histogram.begin());
    count->InsertNextValue(*i);
  }
}

namespace
{
/// The columns that both tables end with.
struct AgreementColumns
{
  explicit AgreementColumns(vtkTable* table)
    : NodePoints(AddColumn<vtkIdTypeArray>(table, "NodePoints"))
    , RootMeanSquare(AddColumn<vtkDoubleArray>(table, "RmsDisagreement"))
    , Greatest(AddColumn<vtkDoubleArray>(table, "MaxDisagreement"))
  {
  }
  void Add(const Agreement& agreement)
  {
    this->NodePoints->InsertNextValue(agreement.NodePoints);
    this->RootMeanSquare->InsertNextValue(agreement.RootMeanSquare());
    this->Greatest->InsertNextValue(agreement.Greatest);
  }

  vtkIdTypeArray* NodePoints;
  vtkDoubleArray* RootMeanSquare;
  vtkDoubleArray* Greatest;
};

/// Whether each contour lies on a slice across the axis that has the number of its port.
bool AreOfTheirPorts(const ContourList& members)
{
  for (std::size_t i = 0; i < members.Port.size(); ++i)
  {
    if (members.Port[i] != members.Axis[i] && !members.IsVirtual(i))
    {
      return false;
    }
  }
  return true;
}
}

void WriteContourTable(const Reconstruction& result, vtkTable* table)
{
  const ContourList& members = result.Members;
  const bool hasBlocks =
    std::any_of(members.Block.begin(), members.Block.end(), [](Index block) { return block > 0; });
  auto* port = AddColumn<vtkIntArray>(table, "Port");
  auto* block = hasBlocks ? AddColumn<vtkIdTypeArray>(table, "Block") : nullptr;
  auto* cell = AddColumn<vtkIdTypeArray>(table, "Cell");
  auto* sliceAxis = AreOfTheirPorts(members) ? nullptr : AddColumn<vtkIntArray>(table, "SliceAxis");
  auto* plane = AddColumn<vtkIntArray>(table, "SlicePlane");
  auto* coordinate = AddColumn<vtkDoubleArray>(table, "PlaneCoordinate");
  AgreementColumns columns(table);
  for (std::size_t i = 0; i < result.Members.Cell.size(); ++i)
  {
    if (result.Members.IsVirtual(i))
    {
      continue;
    }
    const int axis = result.Members.Axis[i];
    port->InsertNextValue(members.Port.empty() ? axis : members.Port[i]);
    if (block != nullptr)
    {
      block->InsertNextValue(members.Block[i]);
    }
    if (sliceAxis != nullptr)
    {
      sliceAxis->InsertNextValue(axis);
    }
    cell->InsertNextValue(result.Members.Cell[i]);
    plane->InsertNextValue(result.Members.Plane[i]);
    coordinate->InsertNextValue(result.Grid.Planes[axis][result.Members.Plane[i]]);
    columns.Add(result.Agreement.OfContour[i]);
  }
}

void WriteSliceTable(const Reconstruction& result, vtkTable* table)
{
  auto* axes = AddColumn<vtkIntArray>(table, "SliceAxis");
  auto* planes = AddColumn<vtkIntArray>(table, "SlicePlane");
  auto* coordinate = AddColumn<vtkDoubleArray>(table, "PlaneCoordinate");
  AgreementColumns columns(table);
  auto* overruled = AddColumn<vtkIdTypeArray>(table, "OverruledVertices");
  auto* snipped = AddColumn<vtkIdTypeArray>(table, "SnippedCrossings");
  vtkDoubleArray* shift[3] = { AddColumn<vtkDoubleArray>(table, "ShiftX"),
    AddColumn<vtkDoubleArray>(table, "ShiftY"), AddColumn<vtkDoubleArray>(table, "ShiftZ") };
  auto* name = AddColumn<vtkStringArray>(table, "SliceName");
  auto* isVirtual =
    result.Grid.HasVirtual() ? AddColumn<vtkUnsignedCharArray>(table, "Virtual") : nullptr;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (Index plane = 0; plane < result.Grid.Count(axis); ++plane)
    {
      axes->InsertNextValue(axis);
      planes->InsertNextValue(plane);
      coordinate->InsertNextValue(result.Grid.Planes[axis][plane]);
      columns.Add(result.Agreement.OfPlane[axis][plane]);
      overruled->InsertNextValue(0);
      snipped->InsertNextValue(0);
      name->InsertNextValue(NameOfSlice(axis, result.Grid.Planes[axis][plane]));
      if (isVirtual != nullptr)
      {
        isVirtual->InsertNextValue(result.Grid.IsVirtual(axis, plane) ? 1 : 0);
      }
      for (int i = 0; i < 3; ++i)
      {
        shift[i]->InsertNextValue(result.Agreement.Shift[axis][plane][i]);
      }
    }
  }
  for (const Repair& repair : result.Repairs)
  {
    vtkIdTypeArray* column = repair.Kind == RepairKind::VertexRelabelled ? overruled
      : repair.Kind == RepairKind::CrossingsSnipped                      ? snipped
                                                                         : nullptr;
    if (column != nullptr)
    {
      const vtkIdType row = result.Grid.SliceNumber(repair.Axis, repair.Plane);
      column->SetValue(row, column->GetValue(row) + (column == snipped ? 2 : 1));
    }
  }
}

void WriteUndecidedTable(const Reconstruction& result, vtkTable* table)
{
  PointColumns where(table, { "X", "Y", "Z" });
  auto* kind = AddColumn<vtkIntArray>(table, "Kind");
  auto* choice = AddColumn<vtkIntArray>(table, "Choice");
  auto* evidence = AddColumn<vtkDoubleArray>(table, "Evidence");
  auto* rank = AddColumn<vtkIntArray>(table, "PlaneRank");
  auto* axis = AddColumn<vtkIntArray>(table, "PlaneAxis");
  auto* coordinate = AddColumn<vtkDoubleArray>(table, "PlaneCoordinate");
  auto* settles = AddColumn<vtkIdTypeArray>(table, "PlaneSettles");
  auto* kindName = AddColumn<vtkStringArray>(table, "KindName");
  auto* choiceName = AddColumn<vtkStringArray>(table, "ChoiceName");
  auto* planeName = AddColumn<vtkStringArray>(table, "PlaneName");
  for (const UndecidedPlace& place : result.Undecided.Places)
  {
    where.InsertNext(place.Where);
    kind->InsertNextValue(static_cast<int>(place.Kind));
    choice->InsertNextValue(static_cast<int>(place.Choice));
    evidence->InsertNextValue(place.Evidence);
    const ProposedPlane plane = place.PlaneRank < 0 ? ProposedPlane{ -1, 0.0, 0, 0.0 }
                                                    : result.Undecided.Planes[place.PlaneRank];
    rank->InsertNextValue(place.PlaneRank);
    axis->InsertNextValue(plane.Axis);
    coordinate->InsertNextValue(plane.Coordinate);
    settles->InsertNextValue(plane.Settles);
    kindName->InsertNextValue(NameOfKind(place.Kind));
    choiceName->InsertNextValue(NameOfChoice(place.Choice));
    planeName->InsertNextValue(
      place.PlaneRank < 0 ? std::string() : NameOfSlice(plane.Axis, plane.Coordinate));
  }
}

void WriteProblemTable(const Reconstruction& result, vtkTable* table)
{
  auto* port = AddColumn<vtkIntArray>(table, "Port");
  auto* cell = AddColumn<vtkIdTypeArray>(table, "Cell");
  auto* axis = AddColumn<vtkIntArray>(table, "SliceAxis");
  auto* kind = AddColumn<vtkIntArray>(table, "Kind");
  auto* name = AddColumn<vtkStringArray>(table, "KindName");
  auto* leftOut = AddColumn<vtkUnsignedCharArray>(table, "LeftOut");
  PointColumns where(table, { "X", "Y", "Z" });
  auto* size = AddColumn<vtkDoubleArray>(table, "Size");
  for (const auto* problems : { &result.Mended, &result.Invalid, &result.CrossingProblems })
  {
    for (const Problem& problem : *problems)
    {
      port->InsertNextValue(problem.Port);
      cell->InsertNextValue(problem.Cell);
      axis->InsertNextValue(problem.Axis);
      kind->InsertNextValue(static_cast<int>(problem.Kind));
      name->InsertNextValue(NameOf(problem.Kind));
      leftOut->InsertNextValue(problem.IsLeftOut ? 1 : 0);
      where.InsertNext(problem.Where);
      size->InsertNextValue(problem.Size);
    }
  }
}
}
