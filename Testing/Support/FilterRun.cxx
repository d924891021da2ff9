// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/FilterRun.h"

#include "Support/Random.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"

#include <algorithm>

namespace orthoslices
{
namespace support
{
namespace
{
class PolyDataWriter
{
public:
  PolyDataWriter(const Pieces& pieces, int type)
    : Source(pieces)
  {
    this->Points->SetDataType(type);
  }

  void AddPiece(Index piece, Form form);
  vtkSmartPointer<vtkPolyData> Finish();

private:
  using Ids = std::vector<vtkIdType>;

  vtkIdType AddPoint(Index vertex)
  {
    double x[3];
    x[this->Source.Axis] = this->Source.W[vertex];
    x[FirstAxis(this->Source.Axis)] = this->Source.U[vertex];
    x[SecondAxis(this->Source.Axis)] = this->Source.V[vertex];
    return this->Points->InsertNextPoint(x);
  }
  Ids AddPoints(Index piece);
  void AddLine(const Ids& ids) { this->Lines.push_back(ids); }
  void AddLooseSegments(Index piece);

  const Pieces& Source;
  Random Numbers{ 12345 };
  vtkNew<vtkPoints> Points;
  std::vector<Ids> Lines, Cycles;
  bool Shuffles = false;
};

PolyDataWriter::Ids PolyDataWriter::AddPoints(Index piece)
{
  Ids ids;
  for (Index i = this->Source.Offsets[piece]; i < this->Source.Offsets[piece + 1]; ++i)
  {
    ids.push_back(this->AddPoint(i));
  }
  return ids;
}

void PolyDataWriter::AddLooseSegments(Index piece)
{
  const Index begin = this->Source.Offsets[piece], end = this->Source.Offsets[piece + 1];
  for (Index i = begin; i < end; ++i)
  {
    const vtkIdType a = this->AddPoint(i);
    const vtkIdType b = this->AddPoint(i + 1 < end ? i + 1 : begin);
    this->AddLine(this->Numbers.Chance(0.5) ? Ids{ a, b } : Ids{ b, a });
  }
  this->Shuffles = true;
}

void PolyDataWriter::AddPiece(Index piece, Form form)
{
  if (form == Form::Mixture)
  {
    form = static_cast<Form>(this->Numbers.Below(static_cast<std::size_t>(Form::Mixture)));
  }
  if (!this->Source.Closed[piece])
  {
    form = Form::OpenLine;
  }
  if (form == Form::LooseSegments)
  {
    this->AddLooseSegments(piece);
    return;
  }
  Ids ids = this->AddPoints(piece);
  switch (form)
  {
    case Form::Polygon:
      this->Cycles.push_back(ids);
      return;
    case Form::ClosedLine:
      ids.push_back(ids.front());
      break;
    case Form::RepeatedPoint:
      ids.push_back(this->AddPoint(this->Source.Offsets[piece]));
      break;
    case Form::Segments:
      for (std::size_t i = 0; i < ids.size(); ++i)
      {
        this->AddLine({ ids[i], ids[(i + 1) % ids.size()] });
      }
      return;
    default:
      break;
  }
  this->AddLine(ids);
}

vtkSmartPointer<vtkPolyData> PolyDataWriter::Finish()
{
  if (this->Shuffles)
  {
    this->Numbers.Shuffle(this->Lines);
  }
  vtkNew<vtkCellArray> lines, cycles;
  for (const Ids& ids : this->Lines)
  {
    lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  for (const Ids& ids : this->Cycles)
  {
    cycles->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(this->Points);
  data->SetLines(lines);
  data->SetPolys(cycles);
  return data;
}

void AppendMessage(vtkObject*, unsigned long, void* messages, void* text)
{
  static_cast<std::vector<std::string>*>(messages)->push_back(static_cast<const char*>(text));
}

void Listen(vtkObject* object, unsigned long event, std::vector<std::string>& messages)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(AppendMessage);
  command->SetClientData(&messages);
  object->AddObserver(event, command);
}
}

vtkSmartPointer<vtkPolyData> MakePolyData(const Pieces& pieces, Form form, int type)
{
  PolyDataWriter writer(pieces, type);
  for (Index i = 0; i < pieces.Count(); ++i)
  {
    writer.AddPiece(i, form);
  }
  return writer.Finish();
}

FilterRun::FilterRun()
{
  for (vtkObject* object : { static_cast<vtkObject*>(this->Filter),
         static_cast<vtkObject*>(this->Filter->GetExecutive()) })
  {
    Listen(object, vtkCommand::ErrorEvent, this->Errors);
    Listen(object, vtkCommand::WarningEvent, this->Warnings);
  }
}

FilterRun::FilterRun(const PieceSets& sets, Form form, int type)
  : FilterRun()
{
  this->SetInputs(sets, form, type);
}

void FilterRun::SetInputs(const PieceSets& sets, Form form, int type)
{
  for (int port = 0; port < 3; ++port)
  {
    this->Filter->SetInputData(port, MakePolyData(sets[port], form, type));
  }
}

vtkPolyData* FilterRun::Update()
{
  this->Errors.clear();
  this->Warnings.clear();
  this->Filter->Update();
  return this->Filter->GetOutput();
}

vtkIdType FieldValue(vtkPolyData* surface, const char* name)
{
  auto* array = vtkIdTypeArray::SafeDownCast(surface->GetFieldData()->GetArray(name));
  return array && array->GetNumberOfValues() == 1 ? array->GetValue(0) : -1;
}

} // namespace support
} // namespace orthoslices
