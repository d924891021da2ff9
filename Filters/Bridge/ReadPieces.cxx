// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/ReadPieces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
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
/// Appends the cells of one vtkCellArray to pieces.
class PieceReader
{
public:
  PieceReader(vtkPolyData* input, bool round, Pieces& pieces)
    : Round(round)
    , Points(input->GetPoints()->GetData())
    , Ghosts(vtkUnsignedCharArray::SafeDownCast(
        input->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName())))
    , Target(pieces)
  {
  }

  void Read(vtkCellArray* cells, bool polygons, vtkIdType firstCell);

private:
  void AddPoint(vtkIdType point);
  void AddCell(vtkIdType cell, vtkIdType count, const vtkIdType* points, bool polygon);

  bool Round;
  vtkDataArray* Points;
  vtkUnsignedCharArray* Ghosts;
  Pieces& Target;
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
  if (this->Round)
  {
    std::transform(x, x + 3, x, [](double value) { return static_cast<float>(value); });
  }
  this->Target.U.push_back(x[FirstAxis(this->Target.Axis)]);
  this->Target.V.push_back(x[SecondAxis(this->Target.Axis)]);
  this->Target.W.push_back(x[this->Target.Axis]);
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
  Pieces& pieces = this->Target;
  const std::size_t first = pieces.Offsets.back();
  const bool repeated = pieces.U.back() == pieces.U[first] && pieces.V.back() == pieces.V[first] &&
    pieces.W.back() == pieces.W[first];
  if (repeated)
  {
    pieces.U.pop_back();
    pieces.V.pop_back();
    pieces.W.pop_back();
  }
  pieces.Offsets.push_back(static_cast<Index>(pieces.U.size()));
  pieces.Cell.push_back(cell);
  pieces.Closed.push_back(polygon || repeated ? 1 : 0);
}

void PieceReader::Read(vtkCellArray* cells, bool polygons, vtkIdType firstCell)
{
  const std::size_t count = this->Target.U.size() + cells->GetNumberOfConnectivityIds();
  for (std::vector<double>* values : { &this->Target.U, &this->Target.V, &this->Target.W })
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

Pieces ReadPieces(vtkPolyData* input, int axis, bool doublePrecision)
{
  Pieces pieces;
  pieces.Axis = axis;
  if (input->GetPoints() == nullptr)
  {
    return pieces;
  }
  PieceReader reader(input, !doublePrecision, pieces);
  const vtkIdType verts = input->GetNumberOfVerts();
  reader.Read(input->GetLines(), false, verts);
  reader.Read(input->GetPolys(), true, verts + input->GetNumberOfLines());
  return pieces;
}
}
