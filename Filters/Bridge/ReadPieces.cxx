// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/ReadPieces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
/// Appends the cells of one vtkCellArray to polylines.
class PieceReader
{
public:
  PieceReader(vtkPolyData* input, bool round, int port, Index block, Polylines& lines)
    : Round(round)
    , Port(port)
    , Block(block)
    , Points(input->GetPoints()->GetData())
    , Ghosts(vtkUnsignedCharArray::SafeDownCast(
        input->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName())))
    , Target(lines)
  {
  }

  void Read(vtkCellArray* cells, bool polygons, vtkIdType firstCell);

private:
  void AddPoint(vtkIdType point);
  void AddCell(vtkIdType cell, vtkIdType count, const vtkIdType* points, bool polygon);

  bool Round;
  int Port;
  Index Block;
  vtkDataArray* Points;
  vtkUnsignedCharArray* Ghosts;
  Polylines& Target;
};

void PieceReader::AddPoint(vtkIdType point)
{
  double x[3];
  if (auto* floats = vtkFloatArray::FastDownCast(this->Points))
  {
    std::copy_n(floats->GetPointer(3 * point), 3, x);
  }
  else if (auto* doubles = vtkDoubleArray::FastDownCast(this->Points))
  {
    std::copy_n(doubles->GetPointer(3 * point), 3, x);
  }
  else
  {
    this->Points->GetTuple(point, x);
  }
  for (int i = 0; i < 3 && this->Round; ++i)
  {
    // Volatile, because GCC 12 at -O3 vectorizes the conversion to float and back away.
    volatile float rounded = static_cast<float>(x[i]);
    x[i] = rounded;
  }
  this->Target.X.push_back(x[0]);
  this->Target.Y.push_back(x[1]);
  this->Target.Z.push_back(x[2]);
}

void PieceReader::AddCell(vtkIdType cell, vtkIdType count, const vtkIdType* points, bool polygon)
{
  const unsigned char hidden =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  if (count < 2 || (this->Ghosts && (this->Ghosts->GetValue(cell) & hidden)))
  {
    return;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    this->AddPoint(points[i]);
  }
  Polylines& lines = this->Target;
  const Index first = lines.Offsets.back();
  const bool repeated =
    lines.PointAt(first) == lines.PointAt(static_cast<Index>(lines.X.size()) - 1);
  if (repeated)
  {
    lines.X.pop_back();
    lines.Y.pop_back();
    lines.Z.pop_back();
  }
  lines.Offsets.push_back(static_cast<Index>(lines.X.size()));
  lines.Closed.push_back(polygon || repeated ? 1 : 0);
  lines.From.Port.push_back(static_cast<std::int8_t>(this->Port));
  lines.From.Block.push_back(this->Block);
  lines.From.Cell.push_back(cell);
}

void PieceReader::Read(vtkCellArray* cells, bool polygons, vtkIdType firstCell)
{
  const std::size_t count = this->Target.X.size() + cells->GetNumberOfConnectivityIds();
  for (std::vector<double>* values : { &this->Target.X, &this->Target.Y, &this->Target.Z })
  {
    values->reserve(count);
  }
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(i, size, points);
    this->AddCell(firstCell + i, size, points, polygons);
  }
}
}

void VisitPolyData(
  vtkDataObject* input, const std::function<void(vtkPolyData* data, Index block)>& visit)
{
  if (auto* data = vtkPolyData::SafeDownCast(input))
  {
    visit(data, 0);
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (composite == nullptr)
  {
    return;
  }
  const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    if (auto* data = vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject()))
    {
      visit(data, static_cast<Index>(blocks->GetCurrentFlatIndex()));
    }
  }
}

void ReadPieces(vtkDataObject* input, int port, bool doublePrecision, Polylines& lines)
{
  VisitPolyData(input,
    [&](vtkPolyData* data, Index block)
    {
      if (data->GetPoints() == nullptr)
      {
        return;
      }
      PieceReader reader(data, !doublePrecision, port, block, lines);
      const vtkIdType verts = data->GetNumberOfVerts();
      reader.Read(data->GetLines(), false, verts);
      reader.Read(data->GetPolys(), true, verts + data->GetNumberOfLines());
    });
}
}
