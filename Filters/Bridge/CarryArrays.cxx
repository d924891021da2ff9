// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/CarryArrays.h"

#include "Core/Reconstruction.h"
#include "Core/Surface/PatchSources.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <set>

namespace orthoslices
{
namespace
{
constexpr std::size_t NotOnSurface = static_cast<std::size_t>(-1);

/// Names of the cell arrays that graph and surface have of their own.
constexpr const char* OwnNames[] = { "Kind", "Disagreement", "SliceAxis", "SlicePlane", "Length",
  "ComponentId", "RepairSize", "SliceRmsDisagreement", "ContourRmsDisagreement", "Virtual",
  "GridCell", "PolygonSize", "Repaired" };

/// Whether the array says on which slice a contour of vtkOrthogonalSlicer lies.
bool IsOfSlicer(const std::string& name)
{
  return name == "PlaneIndex" || name == "PlaneCoordinate";
}

/// Fills a new array with tuples of the contours.
class TupleWriter
{
public:
  TupleWriter(const ContourArray& from, vtkIdType count)
    : From(from)
    , To(vtkSmartPointer<vtkAbstractArray>::Take(from.Values->NewInstance()))
  {
    this->To->SetName(from.Name.c_str());
    this->To->SetNumberOfComponents(from.Values->GetNumberOfComponents());
    this->To->CopyComponentNames(from.Values);
    this->To->SetNumberOfTuples(count);
    if (vtkDataArray::SafeDownCast(from.Values) != nullptr)
    {
      this->Bytes = static_cast<std::size_t>(from.Values->GetDataTypeSize()) *
        this->To->GetNumberOfComponents();
      this->Source = static_cast<const char*>(from.Values->GetVoidPointer(0));
      this->Target = static_cast<char*>(this->To->GetVoidPointer(0));
    }
  }

  /// Sets the tuples from `first` to `end` - 1 to that of a polyline; to none if it is negative.
  void Fill(vtkIdType first, vtkIdType end, std::int64_t line)
  {
    const vtkIdType tuple = line < 0 ? this->From.Null() : static_cast<vtkIdType>(line);
    for (vtkIdType i = first; i < end; ++i)
    {
      if (this->Bytes > 0)
      {
        std::memcpy(
          this->Target + i * this->Bytes, this->Source + tuple * this->Bytes, this->Bytes);
      }
      else
      {
        this->To->SetTuple(i, tuple, this->From.Values);
      }
    }
  }

  vtkAbstractArray* GetArray() const { return this->To; }

private:
  const ContourArray& From;
  vtkSmartPointer<vtkAbstractArray> To;
  std::size_t Bytes = 0; ///< of a tuple of numbers
  const char* Source = nullptr;
  char* Target = nullptr;
};

/// The polyline of each arc and loop of G; negative where there is none or it lacks the array.
std::vector<std::int64_t> SourcesWith(
  const std::vector<std::uint8_t>& has, const Reconstruction& result)
{
  const auto only = [&](std::int64_t line) { return line >= 0 && has[line] != 0 ? line : -1; };
  std::vector<std::int64_t> sources(result.Graph.Offsets.size() - 1, -1);
  std::transform(result.ArcSources.begin(), result.ArcSources.end(), sources.begin(), only);
  for (Index i = 0; i < result.Isolated.Count(); ++i)
  {
    if (result.Isolated.Loop[i] != IsolatedContours::None)
    {
      sources[result.Graph.Arcs + result.Isolated.Loop[i]] = only(result.Isolated.Source[i]);
    }
  }
  return sources;
}
}

ArrayCarrier::ArrayCarrier(const std::vector<vtkDataObject*>& inputs, const Reconstruction& result,
  const std::string& ownName)
  : Arrays(ReadContourArrays(inputs, result.Sources))
{
  std::set<std::string> own(std::begin(OwnNames), std::end(OwnNames));
  own.insert(ownName);
  std::set<std::string> taken = own;
  for (const ContourArray& array : this->Arrays)
  {
    taken.insert(array.Name);
  }
  for (ContourArray& array : this->Arrays)
  {
    if (own.count(array.Name) > 0)
    {
      while (!taken.insert(array.Name).second)
      {
        array.Name = "Input" + array.Name;
      }
    }
  }
}

void ArrayCarrier::ChooseContours(const Reconstruction& result, const Execution& execution)
{
  this->FirstTriangles = result.Surface.Offsets;
  std::vector<const std::vector<std::uint8_t>*> chosen;
  for (const ContourArray& array : this->Arrays)
  {
    if (IsOfSlicer(array.Name))
    {
      this->Choice.push_back(NotOnSurface);
      continue;
    }
    const auto same = std::find_if(chosen.begin(), chosen.end(),
      [&](const std::vector<std::uint8_t>* has) { return *has == array.Has; });
    this->Choice.push_back(static_cast<std::size_t>(same - chosen.begin()));
    if (same == chosen.end())
    {
      chosen.push_back(&array.Has);
      this->OfPatch.push_back(FindPatchSources(
        GeometryOf(result), result.Surface.Meshes, SourcesWith(array.Has, result), execution));
    }
  }
}

void ArrayCarrier::AddToGraph(const Reconstruction& result, vtkCellData* graph) const
{
  if (this->Arrays.empty())
  {
    return;
  }
  // Node points and repairs come first.
  std::vector<std::int64_t> lines(result.Graph.Nodes + result.Repairs.size(), -1);
  for (Index arc = 0; arc < result.Crossings.Count(); ++arc)
  {
    if (!result.Crossings.IsRemoved(arc))
    {
      lines.push_back(result.ArcSources[arc]);
    }
  }
  lines.insert(lines.end(), result.Isolated.Source.begin(), result.Isolated.Source.end());
  const vtkIdType count = static_cast<vtkIdType>(lines.size());
  for (const ContourArray& array : this->Arrays)
  {
    TupleWriter writer(array, count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      writer.Fill(i, i + 1, lines[i]);
    }
    graph->AddArray(writer.GetArray());
  }
}

void ArrayCarrier::AddToSurface(vtkCellData* surface) const
{
  for (std::size_t i = 0; i < this->Arrays.size(); ++i)
  {
    if (this->Choice[i] == NotOnSurface)
    {
      continue;
    }
    const std::vector<std::int64_t>& ofPatch = this->OfPatch[this->Choice[i]];
    TupleWriter writer(this->Arrays[i], static_cast<vtkIdType>(this->FirstTriangles.back()));
    for (std::size_t patch = 0; patch < ofPatch.size(); ++patch)
    {
      writer.Fill(this->FirstTriangles[patch], this->FirstTriangles[patch + 1], ofPatch[patch]);
    }
    surface->AddArray(writer.GetArray());
  }
}
}
