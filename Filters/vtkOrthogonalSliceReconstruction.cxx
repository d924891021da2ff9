// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOrthogonalSliceReconstruction.h"

#include "Bridge/AppendLabels.h"
#include "Bridge/CarryArrays.h"
#include "Bridge/CarryFieldData.h"
#include "Bridge/CompareOthers.h"
#include "Bridge/CutAtBorder.h"
#include "Bridge/DescribeInputs.h"
#include "Bridge/DescribeLabels.h"
#include "Bridge/DescribeProblems.h"
#include "Bridge/DescribeReport.h"
#include "Bridge/ExecuteWithVtk.h"
#include "Bridge/ProcessGroup.h"
#include "Bridge/ReadLabels.h"
#include "Bridge/TimeSteps.h"
#include "Bridge/WriteComponents.h"
#include "Bridge/WriteGraph.h"
#include "Bridge/WriteSurface.h"
#include "Bridge/WriteTables.h"
#include "Core/Frames/SplitByLabel.h"
#include "Core/ReconstructLabels.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <sstream>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkOrthogonalSliceReconstruction);
vtkCxxSetObjectMacro(vtkOrthogonalSliceReconstruction, Controller, vtkMultiProcessController);

namespace
{
/// One for each family, and one for contours of any families.
constexpr int InputPorts = 4;

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

/// All outputs, of all contours of the inputs. False, with an error, if that cannot be.
bool vtkOrthogonalSliceReconstruction::MakeOutputs(vtkInformationVector* outputs)
{
  const std::vector<vtkDataObject*> inputs = this->ListInputs();
  if (!this->CheckInputs(inputs))
  {
    return false;
  }
  this->SetProgressText("Reading contours");
  orthoslices::Options options;
  this->GetOptions(options);
  orthoslices::SortedSlices sorted = this->SortInputs(inputs);
  this->InputRemarks = orthoslices::DescribeInputs(inputs);
  if (this->WarnOfMissingFamilies)
  {
    this->InputRemarks += orthoslices::DescribeMissingFamilies(inputs, sorted);
  }
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
    if (this->Processes->IsParallel() && this->CanBeDivided(sorted))
    {
      options.Processes = &this->Processes->GetRanks();
    }
    done = this->ReconstructAll(std::move(sorted), options, outputs);
  }
  if (done)
  {
    orthoslices::CarryFieldData(
      inputs, vtkPolyData::GetData(outputs, 0), vtkPolyData::GetData(outputs, 1));
  }
  return done;
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
  text += this->InputRemarks;
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
  report << this->InputRemarks << orthoslices::DescribeOverlaps(surfaces.Overlaps, labels)
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
    result, orthoslices::ExecuteLoops(this, 0.0, 0.2), doublePrecision, graph);
  // With labels, the array "Label" is that of the labels.
  const bool ownsLabel = this->UsesLabels() && std::string(this->LabelArray) != "Label";
  orthoslices::ArrayCarrier carrier(
    this->PassCellArrays ? this->ListInputs() : std::vector<vtkDataObject*>(), result,
    ownsLabel ? "Label" : "");
  carrier.AddToGraph(result, graph->GetCellData());
  carrier.ChooseContours(result, orthoslices::ExecuteLoops(this, 0.2, 0.3));
  // Of a whole surface, all is known here.
  const orthoslices::Ranks ranks = result.Part ? this->Processes->GetRanks() : orthoslices::Ranks();
  const orthoslices::SurfaceArrayOptions arrays{ this->ComputeNormals, this->ComputeCurvatures,
    ranks };
  const double reportTolerance = this->ReportTolerance * result.Diagonal;
  const orthoslices::Box3 openBorder = result.OpenBorder;
  const orthoslices::AxisFrame frame = result.Frame;
  vtkPolyData* surface = vtkPolyData::GetData(outputs, 0);
  orthoslices::WriteSurface(std::move(result), orthoslices::ExecuteLoops(this, 0.3, 0.9),
    doublePrecision, arrays, reportTolerance, surface);
  carrier.AddToSurface(surface->GetCellData());
  orthoslices::CutAtBorder(openBorder, frame, surface);
  const bool mayBeOpen = this->BorderContours == LEAVE_OPEN_AT_BORDER;
  orthoslices::WriteComponentTable(surface, mayBeOpen, ranks,
    orthoslices::ExecuteLoops(this, 0.9, 1.0), vtkTable::GetData(outputs, 7));
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
