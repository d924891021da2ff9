// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/PieceMarks.h"

#include "Bridge/TakePiece.h"
#include "Core/Patches/DivideCycles.h"
#include "Core/Reconstruction.h"

namespace orthoslices
{
std::vector<float> SelectNormals(
  const std::vector<float>& normals, const std::vector<std::int64_t>& points)
{
  std::vector<float> selected;
  selected.reserve(3 * points.size());
  for (const std::int64_t point : points)
  {
    if (point < 0)
    {
      selected.insert(selected.end(), 3, 0.0f);
      continue;
    }
    const auto first = normals.begin() + static_cast<std::ptrdiff_t>(3 * point);
    selected.insert(selected.end(), first, first + 3);
  }
  return selected;
}

PieceMarks::PieceMarks(const Reconstruction& result, const Ranks& ranks)
  : FirstInner(result.Surface.MeshOffsets.back())
  , Shared{ ranks, {}, {}, !result.Normals.Normals.empty() }
{
  const ImprovedTriangles& improved = result.Surface.Improved;
  if (improved.IsPart)
  {
    this->PartsOfPoints = improved.OtherParts;
    this->Ids = improved.Ids;
    this->TrianglesBefore = improved.TrianglesBefore;
    return;
  }
  this->PartsOfPoints = FindPartsOfPoints(GeometryOf(result), result.Surface.Meshes, *result.Part);
  const InnerPatches& inner = result.Surface.Inner;
  const std::vector<std::int64_t> own{ inner.PointOffsets.back() - inner.Count(),
    result.Surface.TriangleCount() };
  const auto all = GatherValues(ranks, own);
  for (int rank = 0; rank < ranks.Rank; ++rank)
  {
    this->InnerBefore += all[rank][0];
    this->TrianglesBefore += all[rank][1];
  }
}

std::vector<float> PieceMarks::Apply(const std::vector<float>& normals, vtkPolyData* surface)
{
  const std::vector<vtkIdType> used = KeepUsedPoints(surface);
  std::vector<vtkIdType> ids(used.size());
  std::vector<unsigned char> isDuplicate(used.size(), 0);
  this->Shared.IsShared.assign(used.size(), 0);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    ids[i] = !this->Ids.empty() ? static_cast<vtkIdType>(this->Ids[used[i]])
                                : used[i] + (used[i] < this->FirstInner ? 0 : this->InnerBefore);
    if (used[i] < static_cast<vtkIdType>(this->PartsOfPoints.size()))
    {
      const std::uint8_t parts = this->PartsOfPoints[used[i]];
      isDuplicate[i] = (parts & BeforePart) != 0 ? 1 : 0;
      this->Shared.IsShared[i] = parts != 0 ? 1 : 0;
    }
  }
  this->Shared.Ids.assign(ids.begin(), ids.end());
  MarkPiece(ids, this->TrianglesBefore, isDuplicate, surface);
  return normals.empty()
    ? normals
    : SelectNormals(normals, std::vector<std::int64_t>(used.begin(), used.end()));
}
}
