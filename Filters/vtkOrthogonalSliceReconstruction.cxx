// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOrthogonalSliceReconstruction.h"

#include "Bridge/AppendLabels.h"
#include "Bridge/CarryArrays.h"
#include "Bridge/CarryFieldData.h"
#include "Bridge/CompareOthers.h"
#include "Bridge/CutAtBorder.h"
#include "Bridge/DescribeLabels.h"
#include "Bridge/DescribeProblems.h"
#include "Bridge/DescribeReport.h"
#include "Bridge/ExecuteWithVtk.h"
#include "Bridge/GatherInputs.h"
#include "Bridge/ProcessGroup.h"
#include "Bridge/ReadLabels.h"
#include "Bridge/ReadPieces.h"
#include "Bridge/TakePiece.h"
#include "Bridge/TimeSteps.h"
#include "Bridge/WriteComponents.h"
#include "Bridge/WriteGraph.h"
#include "Bridge/WriteSurface.h"
#include "Bridge/WriteTables.h"
#include "Core/Frames/SplitByLabel.h"
#include "Core/ReconstructLabels.h"

#include "vtkCellData.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <limits>
#include <new>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkOrthogonalSliceReconstruction);
vtkCxxSetObjectMacro(vtkOrthogonalSliceReconstruction, Controller, vtkMultiProcessController);

using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{
/// One for each family, and one for contours of any families.
constexpr int InputPorts = 4;

/// More contour vertices than that do not fit into the core's numbers.
constexpr vtkIdType MaxVertices = std::numeric_limits<orthoslices::Index>::max() / 8;

/// Progress when the contours are read, and when the surface is made and has to be written.
constexpr double ProgressOfReading = 0.03;
constexpr double ProgressBeforeSurface = 0.85;
}

vtkOrthogonalSliceReconstruction::vtkOrthogonalSliceReconstruction()
{
  this->SetNumberOfInputPorts(InputPorts);
  this->SetNumberOfOutputPorts(8);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkOrthogonalSliceReconstruction::~vtkOrthogonalSliceReconstruction()
{
  this->SetController(nullptr);
}

int vtkOrthogonalSliceReconstruction::FillInputPortInformation(int, vtkInformation* info)
{
  // Composite types are named, so that the executive does not run the filter block by block.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  for (const char* type :
    { "vtkMultiBlockDataSet", "vtkPartitionedDataSet", "vtkPartitionedDataSetCollection" })
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type);
  }
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkOrthogonalSliceReconstruction::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port >= 2 ? "vtkTable" : "vtkPolyData");
  return 1;
}

void vtkOrthogonalSliceReconstruction::SetFamilyConnection(int family, vtkAlgorithmOutput* output)
{
  if (family < 1 || family > InputPorts)
  {
    vtkErrorMacro(
      "Family " << family << " must be 1 (x-slices), 2 (y-slices), 3 (z-slices) or 4 (any).");
    return;
  }
  this->SetInputConnection(family - 1, output);
}

void vtkOrthogonalSliceReconstruction::SetContoursConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(InputPorts - 1, output);
}

vtkPolyData* vtkOrthogonalSliceReconstruction::GetGraphOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

vtkTable* vtkOrthogonalSliceReconstruction::GetHistogramOutput()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

vtkTable* vtkOrthogonalSliceReconstruction::GetContourTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(3));
}

vtkTable* vtkOrthogonalSliceReconstruction::GetSliceTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(4));
}

vtkTable* vtkOrthogonalSliceReconstruction::GetUndecidedTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(5));
}

vtkTable* vtkOrthogonalSliceReconstruction::GetProblemTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(6));
}

vtkTable* vtkOrthogonalSliceReconstruction::GetComponentTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(7));
}

int vtkOrthogonalSliceReconstruction::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  orthoslices::DeclareTimeSteps(inputs, InputPorts, outputs);
  return 1;
}

namespace
{
/// What is asked of an output for which the pipeline passes on a request.
vtkInformation* RequestOf(vtkInformation* request, vtkInformationVector* outputs)
{
  const int from = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  return outputs->GetInformationObject(from);
}
}

int vtkOrthogonalSliceReconstruction::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // Contours of all pieces belong together: one process needs the whole input, several exchange
  // what each of them has.
  const orthoslices::ProcessGroup group(this->Controller, RequestOf(request, outputs));
  for (int port = 0; port < InputPorts; ++port)
  {
    vtkInformation* input = inputs[port]->GetInformationObject(0);
    if (input != nullptr)
    {
      input->Set(Pipeline::UPDATE_PIECE_NUMBER(), group.GetRanks().Rank);
      input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), group.GetRanks().Count);
      input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
  return 1;
}

int vtkOrthogonalSliceReconstruction::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  orthoslices::ClearFieldData(outputs);
  orthoslices::MarkTime(this->ListInputs(), outputs);
  vtkInformation* asked = RequestOf(request, outputs);
  orthoslices::ProcessGroup group(this->Controller, asked);
  if (!group.IsParallel() && asked->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1; // without other processes, the first piece is the whole surface
  }
  this->Processes = group.IsParallel() ? &group : nullptr;
  const bool done = this->MakeWithOthers(group, inputs, outputs);
  this->Processes = nullptr;
  this->GatheredInputs.clear();
  return done ? 1 : 0;
}

/// What this process has to make of the outputs. However it ends, the others of a parallel run hear
/// of it. False, with an error and empty outputs, if they cannot be made; empty outputs without an
/// error if it was aborted.
bool vtkOrthogonalSliceReconstruction::MakeWithOthers(
  orthoslices::ProcessGroup& group, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  bool done = false;
  try
  {
    done =
      group.IsParallel() ? this->MakePieces(inputs, outputs) : this->MakeOutputs(inputs, outputs);
    if (this->GetAbortExecute())
    {
      throw orthoslices::Stopped(); // too late for a loop to hear of it
    }
    if (done)
    {
      group.Finish();
      return true;
    }
    group.Fail("reported an error.");
  }
  catch (const orthoslices::Stopped&)
  {
    group.Fail("aborted.");
    done = true;
  }
  catch (const std::bad_alloc&)
  {
    group.Fail("has not enough memory.");
    vtkErrorMacro("There is not enough memory for the surface of these contours.");
    done = false;
  }
  catch (const std::exception& failure)
  {
    group.Fail(failure.what());
    vtkErrorMacro(<< failure.what());
    done = false;
  }
  orthoslices::ClearOutputs(outputs);
  return done;
}

/// The piece of this process, and on the first one all other outputs.
bool vtkOrthogonalSliceReconstruction::MakePieces(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const orthoslices::Ranks& ranks = this->Processes->GetRanks();
  if (!this->CheckProperties())
  {
    return false;
  }
  std::vector<vtkDataObject*> own;
  for (int port = 0; port < InputPorts; ++port)
  {
    own.push_back(vtkDataObject::GetData(inputs[port]));
  }
  this->GatheredInputs = orthoslices::GatherInputs(own, ranks);
  vtkNew<vtkInformationVector> ofPorts[InputPorts];
  vtkInformationVector* gathered[InputPorts];
  for (int port = 0; port < InputPorts; ++port)
  {
    gathered[port] = ofPorts[port];
    if (this->GatheredInputs[port] != nullptr)
    {
      vtkNew<vtkInformation> info;
      info->Set(vtkDataObject::DATA_OBJECT(), this->GatheredInputs[port]);
      gathered[port]->Append(info);
    }
  }
  if (!this->MakeOutputs(gathered, outputs))
  {
    return false;
  }
  vtkPolyData* surface = vtkPolyData::GetData(outputs, 0);
  if (surface->GetPointData()->GetGlobalIds() == nullptr)
  {
    orthoslices::TakePiece(ranks, surface); // it could not be made in pieces
  }
  for (int port = 1; port < this->GetNumberOfOutputPorts() && ranks.Rank > 0; ++port)
  {
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
  return true;
}

/// All outputs, of all contours of the inputs. False, with an error, if that cannot be.
bool vtkOrthogonalSliceReconstruction::MakeOutputs(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!this->CheckProperties() || !this->CheckInputs(inputs))
  {
    return false;
  }
  this->SetProgressText("Reading contours");
  orthoslices::Options options;
  this->GetOptions(options);
  orthoslices::SortedSlices sorted = this->SortInputs(inputs);
  const bool doublePrecision = this->NeedsDoublePrecision(inputs, sorted);
  options.SinglePrecision = !doublePrecision;
  bool done = false;
  if (this->UsesLabels())
  {
    const orthoslices::ContourLabels labels = this->ReadLabels(inputs, sorted);
    done =
      labels.Count() > 0 && this->ReconstructLabels(std::move(sorted), labels, options, outputs);
  }
  else
  {
    if (this->Processes != nullptr && this->CanBeDivided(sorted))
    {
      options.Processes = &this->Processes->GetRanks();
    }
    done = this->ReconstructAll(std::move(sorted), options, outputs);
  }
  if (done)
  {
    orthoslices::CarryFieldData(
      this->ListInputs(), vtkPolyData::GetData(outputs, 0), vtkPolyData::GetData(outputs, 1));
  }
  return done;
}

/// Whether processes can make parts of the surface. Curvatures, cuts at the border of the image and
/// distances from contours on other planes are those of a whole surface.
bool vtkOrthogonalSliceReconstruction::CanBeDivided(const orthoslices::SortedSlices& sorted) const
{
  return !this->ComputeCurvatures && this->BorderContours != LEAVE_OPEN_AT_BORDER &&
    sorted.Others.Count() == 0;
}

/// Warns the user, once in a parallel run: all processes have the same to say.
void vtkOrthogonalSliceReconstruction::Warn(const std::string& text)
{
  if (this->Processes == nullptr || this->Processes->IsFirst())
  {
    vtkWarningMacro(<< text);
  }
}

/// The outputs of one structure, or the reason why there are none, and what else to tell the user.
/// False if there are none.
bool vtkOrthogonalSliceReconstruction::WriteResult(orthoslices::Reconstruction&& result,
  const orthoslices::Polylines& others, const orthoslices::Options& options,
  const std::function<vtkInformationVector*()>& outputs, std::string& text)
{
  text = this->DescribeFailure(result);
  if (!text.empty())
  {
    return false;
  }
  text = this->Report(result);
  const std::vector<std::uint8_t> guiding = result.Guiding;
  vtkInformationVector* target = outputs();
  this->WriteOutputs(std::move(result), !options.SinglePrecision, target);
  text += this->CompareOthers(others, guiding, target);
  return true;
}

/// One surface of all contours. False, with empty outputs, if they are refused.
bool vtkOrthogonalSliceReconstruction::ReconstructAll(orthoslices::SortedSlices&& sorted,
  const orthoslices::Options& options, vtkInformationVector* outputs)
{
  const orthoslices::Polylines others = sorted.Others;
  orthoslices::Reconstruction result;
  {
    const orthoslices::ShareOfProgress progress(
      this, ProgressOfReading, ProgressBeforeSurface - ProgressOfReading);
    result =
      orthoslices::ReconstructSorted(std::move(sorted), options, orthoslices::ExecuteWithVtk(this));
  }
  if (result.Stopped)
  {
    throw orthoslices::Stopped();
  }
  std::string text;
  const orthoslices::ShareOfProgress progress(
    this, ProgressBeforeSurface, 1.0 - ProgressBeforeSurface);
  const bool done = this->WriteResult(
    std::move(result), others, options, [outputs]() { return outputs; }, text);
  if (!done)
  {
    vtkErrorMacro(<< text);
  }
  else if (!text.empty())
  {
    this->Warn(text);
  }
  return done;
}

/// The labels of all contours; an error and no labels if there are none.
orthoslices::ContourLabels vtkOrthogonalSliceReconstruction::ReadLabels(
  vtkInformationVector** inputs, const orthoslices::SortedSlices& sorted)
{
  std::vector<vtkDataObject*> data;
  for (int port = 0; port < InputPorts; ++port)
  {
    data.push_back(vtkDataObject::GetData(inputs[port]));
  }
  const orthoslices::ContourLabels labels =
    orthoslices::ReadLabels(data, this->LabelArray, sorted.From);
  if (labels.Count() == 0)
  {
    vtkErrorMacro("No contour has a label in a cell array \"" << this->LabelArray << "\".");
  }
  else if (labels.Unlabelled > 0)
  {
    this->Warn(std::to_string(labels.Unlabelled) + " contours have no label in the cell array \"" +
      this->LabelArray + "\" and take no part in any surface.");
  }
  return labels;
}

/// One surface for each label; labels that are refused do not cost the others. False, with empty
/// outputs, if all are refused.
bool vtkOrthogonalSliceReconstruction::ReconstructLabels(orthoslices::SortedSlices&& sorted,
  const orthoslices::ContourLabels& labels, const orthoslices::Options& options,
  vtkInformationVector* outputs)
{
  std::vector<orthoslices::SortedSlices> parts =
    orthoslices::SplitByLabel(sorted, labels.OfLine, labels.Count());
  sorted = orthoslices::SortedSlices();
  std::vector<orthoslices::Polylines> others;
  for (orthoslices::SortedSlices& part : parts)
  {
    others.push_back(std::move(part.Others));
  }
  orthoslices::LabelSurfaces surfaces;
  {
    const orthoslices::ShareOfProgress progress(
      this, ProgressOfReading, ProgressBeforeSurface - ProgressOfReading);
    surfaces =
      orthoslices::ReconstructLabels(std::move(parts), options, orthoslices::ExecuteWithVtk(this));
  }
  if (surfaces.Stopped)
  {
    throw orthoslices::Stopped();
  }
  return this->WriteLabels(std::move(surfaces), others, labels, options, outputs);
}

/// The outputs of all labels that have a surface, appended.
bool vtkOrthogonalSliceReconstruction::WriteLabels(orthoslices::LabelSurfaces&& surfaces,
  const std::vector<orthoslices::Polylines>& others, const orthoslices::ContourLabels& labels,
  const orthoslices::Options& options, vtkInformationVector* outputs)
{
  orthoslices::LabelOutputs appended(labels, outputs);
  std::ostringstream refused, report;
  report << orthoslices::DescribeOverlaps(surfaces.Overlaps, labels)
         << orthoslices::DescribeLosses(surfaces.Losses, labels);
  bool any = false;
  const double share = (1.0 - ProgressBeforeSurface) / labels.Count();
  for (orthoslices::Index label = 0; label < labels.Count(); ++label)
  {
    const orthoslices::ShareOfProgress progress(this, ProgressBeforeSurface + share * label, share);
    std::string text;
    const bool done = this->WriteResult(
      std::move(surfaces.OfLabel[label]), others[label], options,
      [&]() { return appended.Next(label); }, text);
    surfaces.OfLabel[label] = orthoslices::Reconstruction();
    any |= done;
    const std::string name = "\nLabel " + labels.NameOf(label);
    if (!done)
    {
      refused << name << " has no surface: " << text;
    }
    else if (!text.empty())
    {
      report << name << ":" << text;
    }
  }
  if (!any)
  {
    vtkErrorMacro(<< refused.str());
    return false;
  }
  appended.Finish();
  if (!(refused.str() + report.str()).empty())
  {
    this->Warn(refused.str() + report.str());
  }
  return true;
}

/// The inputs of all ports, those of all processes while these make a surface together; null where
/// there is none.
std::vector<vtkDataObject*> vtkOrthogonalSliceReconstruction::ListInputs()
{
  std::vector<vtkDataObject*> inputs;
  if (!this->GatheredInputs.empty())
  {
    inputs.assign(this->GatheredInputs.begin(), this->GatheredInputs.end());
    return inputs;
  }
  for (int port = 0; port < InputPorts; ++port)
  {
    const bool isConnected = this->GetNumberOfInputConnections(port) > 0;
    inputs.push_back(isConnected ? this->GetInputDataObject(port, 0) : nullptr);
  }
  return inputs;
}

vtkStringArray* vtkOrthogonalSliceReconstruction::GetCellArrayNames()
{
  std::set<std::string> names;
  for (vtkDataObject* input : this->ListInputs())
  {
    orthoslices::VisitPolyData(input,
      [&](vtkPolyData* data, orthoslices::Index)
      {
        for (int i = 0; i < data->GetCellData()->GetNumberOfArrays(); ++i)
        {
          const char* name = data->GetCellData()->GetArrayName(i);
          names.insert(name != nullptr ? name : "");
        }
      });
  }
  names.erase("");
  this->CellArrayNames->Reset();
  for (const std::string& name : names)
  {
    this->CellArrayNames->InsertNextValue(name);
  }
  return this->CellArrayNames;
}

/// There are contours on some port, and not too many. Empty ports are as good as unconnected ones.
bool vtkOrthogonalSliceReconstruction::CheckInputs(vtkInformationVector** inputs)
{
  if (this->GetTotalNumberOfInputConnections() == 0)
  {
    vtkErrorMacro(
      "No input: connect contours to port 0 (x-slices), 1 (y-slices), 2 (z-slices) or 3 "
      "(slices of any families).");
    return false;
  }
  vtkIdType cells = 0, vertices = 0;
  for (int port = 0; port < InputPorts; ++port)
  {
    orthoslices::VisitPolyData(vtkDataObject::GetData(inputs[port]),
      [&](vtkPolyData* data, orthoslices::Index)
      {
        cells += data->GetNumberOfLines() + data->GetNumberOfPolys();
        vertices += data->GetLines()->GetNumberOfConnectivityIds() +
          data->GetPolys()->GetNumberOfConnectivityIds();
      });
  }
  if (cells == 0)
  {
    vtkErrorMacro("The input has no contours: no lines and no polygons on any port.");
    return false;
  }
  if (vertices > MaxVertices)
  {
    vtkErrorMacro(
      "The input has " << vertices << " contour vertices, more than " << MaxVertices << ".");
    return false;
  }
  return true;
}

/// The contours of all ports by the planes that they lie on.
orthoslices::SortedSlices vtkOrthogonalSliceReconstruction::SortInputs(
  vtkInformationVector** inputs) const
{
  orthoslices::Polylines lines;
  const bool round = this->OutputPointsPrecision == SINGLE_PRECISION;
  for (int port = 0; port < InputPorts; ++port)
  {
    orthoslices::ReadPieces(vtkDataObject::GetData(inputs[port]), port, !round, lines);
  }
  return orthoslices::SortByPlanes(lines, this->GetFrameOptions());
}

bool vtkOrthogonalSliceReconstruction::NeedsDoublePrecision(
  vtkInformationVector** inputs, const orthoslices::SortedSlices& sorted)
{
  if (this->OutputPointsPrecision != DEFAULT_PRECISION)
  {
    return this->OutputPointsPrecision == DOUBLE_PRECISION;
  }
  // Turned back, coordinates are no values of float any more.
  bool anyDouble = !sorted.Frame.IsWorld();
  for (int port = 0; port < InputPorts; ++port)
  {
    orthoslices::VisitPolyData(vtkDataObject::GetData(inputs[port]),
      [&](vtkPolyData* data, orthoslices::Index) {
        anyDouble |= data->GetPoints() != nullptr && data->GetPoints()->GetDataType() == VTK_DOUBLE;
      });
  }
  return anyDouble;
}

/// Why there is no surface that the outputs can hold; empty if there is one.
std::string vtkOrthogonalSliceReconstruction::DescribeFailure(
  const orthoslices::Reconstruction& result) const
{
  std::ostringstream text;
  if (result.Refused)
  {
    std::vector<orthoslices::Problem> problems = result.Invalid;
    problems.insert(problems.end(), result.CrossingProblems.begin(), result.CrossingProblems.end());
    text << "The input has " << problems.size()
         << " unusable contours:" << orthoslices::DescribeProblems(problems);
    return text.str();
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    // Cells are counted from 0 below the first plane, in the array GridCell.
    if (result.Grid.Count(axis) >= VTK_UNSIGNED_SHORT_MAX)
    {
      text << "There are " << result.Grid.Count(axis) << " " << orthoslices::AxisNames[axis]
           << "-slices, more than " << VTK_UNSIGNED_SHORT_MAX - 1
           << "; is PlaneTolerance too small?";
      return text.str();
    }
  }
  return std::string();
}

/// Takes out what is not worth a report, and says what is left that the user should know.
std::string vtkOrthogonalSliceReconstruction::Report(orthoslices::Reconstruction& result) const
{
  orthoslices::ReportSettings settings;
  settings.Tolerance = this->ReportTolerance * result.Diagonal;
  settings.RepairsCrossing = this->CrossingContours == REPAIR_CROSSING;
  if (this->SeveralCycles == BY_EVIDENCE)
  {
    settings.Expected.Components = this->ExpectedComponents;
    settings.Expected.Genus = this->ExpectedGenus;
  }
  orthoslices::RemoveSmallRepairs(settings.Tolerance, result.Repairs);
  return orthoslices::DescribeReport(result, settings);
}

void vtkOrthogonalSliceReconstruction::WriteOutputs(
  orthoslices::Reconstruction&& result, bool doublePrecision, vtkInformationVector* outputs)
{
  this->SetProgressText("Writing the surface");
  orthoslices::WriteContourTable(result, vtkTable::GetData(outputs, 3));
  orthoslices::WriteSliceTable(result, vtkTable::GetData(outputs, 4));
  orthoslices::WriteUndecidedTable(result, vtkTable::GetData(outputs, 5));
  orthoslices::WriteProblemTable(result, vtkTable::GetData(outputs, 6));
  orthoslices::WriteHistogram(result, vtkTable::GetData(outputs, 2));
  vtkPolyData* graph = vtkPolyData::GetData(outputs, 1);
  orthoslices::WriteGraph(
    result, orthoslices::ExecuteShare(this, 0.0, 0.2), doublePrecision, graph);
  // With labels, the array "Label" is that of the labels.
  const bool ownsLabel = this->UsesLabels() && std::string(this->LabelArray) != "Label";
  orthoslices::ArrayCarrier carrier(
    this->PassCellArrays ? this->ListInputs() : std::vector<vtkDataObject*>(), result,
    ownsLabel ? "Label" : "");
  carrier.AddToGraph(result, graph->GetCellData());
  carrier.ChooseContours(result, orthoslices::ExecuteShare(this, 0.2, 0.3));
  // Of a whole surface, all is known here.
  const orthoslices::Ranks ranks = result.Part ? this->Processes->GetRanks() : orthoslices::Ranks();
  const orthoslices::SurfaceArrayOptions arrays{ this->ComputeNormals, this->ComputeCurvatures,
    &ranks };
  const double reportTolerance = this->ReportTolerance * result.Diagonal;
  const orthoslices::Box3 openBorder = result.OpenBorder;
  const orthoslices::AxisFrame frame = result.Frame;
  vtkPolyData* surface = vtkPolyData::GetData(outputs, 0);
  orthoslices::WriteSurface(std::move(result), orthoslices::ExecuteShare(this, 0.3, 0.9),
    doublePrecision, arrays, reportTolerance, surface);
  carrier.AddToSurface(surface->GetCellData());
  orthoslices::CutAtBorder(openBorder, frame, surface);
  const bool mayBeOpen = this->BorderContours == LEAVE_OPEN_AT_BORDER;
  orthoslices::WriteComponentTable(surface, mayBeOpen, ranks, vtkTable::GetData(outputs, 7));
  this->UpdateProgress(1.0);
}

/// Contours on planes of no family: how far the surface is from them, for the table and as text.
std::string vtkOrthogonalSliceReconstruction::CompareOthers(const orthoslices::Polylines& others,
  const std::vector<std::uint8_t>& guiding, vtkInformationVector* outputs) const
{
  const std::vector<orthoslices::Agreement> distances =
    orthoslices::MeasureDistances(others, vtkPolyData::GetData(outputs, 0));
  orthoslices::WriteOthers(others, distances, vtkTable::GetData(outputs, 3));
  return orthoslices::DescribeOthers(others, distances, guiding);
}
