// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOrthogonalSliceReconstruction.h"

#include "Bridge/AppendLabels.h"
#include "Bridge/CarryArrays.h"
#include "Bridge/CarryFieldData.h"
#include "Bridge/CompareOthers.h"
#include "Bridge/CutAtBorder.h"
#include "Bridge/DescribeProblems.h"
#include "Bridge/DescribeReport.h"
#include "Bridge/ExecuteWithVtk.h"
#include "Bridge/ReadLabels.h"
#include "Bridge/ReadPieces.h"
#include "Bridge/TimeSteps.h"
#include "Bridge/WriteComponents.h"
#include "Bridge/WriteGraph.h"
#include "Bridge/WriteSurface.h"
#include "Bridge/WriteTables.h"
#include "Core/Frames/SplitByLabel.h"
#include "Core/Patches/SharedPatches.h"
#include "Core/ReconstructSorted.h"

#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkOrthogonalSliceReconstruction);

using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{
using Filter = vtkOrthogonalSliceReconstruction;

/// A value of a property, what it is for the core, and its name.
template <typename Option>
struct Choice
{
  int Property;
  Option Value;
  const char* Name;
};

constexpr Choice<orthoslices::Orientation> Orientations[] = {
  { Filter::ORIENT_BY_NESTING, orthoslices::Orientation::ByNesting, "ByNesting" },
  { Filter::ORIENT_AS_DRAWN, orthoslices::Orientation::AsDrawn, "AsDrawn" }
};
/// Whether the input is refused.
constexpr Choice<orthoslices::InvalidContours> InvalidContoursModes[] = {
  { Filter::REFUSE, orthoslices::InvalidContours::Refuse, "Refuse" },
  { Filter::LEAVE_OUT, orthoslices::InvalidContours::LeaveOut, "LeaveOut" },
  { Filter::MEND, orthoslices::InvalidContours::Mend, "Mend" }
};
constexpr Choice<orthoslices::BorderContours> BorderContoursModes[] = {
  { Filter::CLOSE_ALONG_BORDER, orthoslices::BorderContours::CloseAlong, "CloseAlongBorder" },
  { Filter::LEAVE_OPEN_AT_BORDER, orthoslices::BorderContours::LeaveOpen, "LeaveOpen" },
  { Filter::REFUSE_AT_BORDER, orthoslices::BorderContours::Refuse, "Refuse" }
};
constexpr Choice<orthoslices::CrossingContours> CrossingContoursModes[] = {
  { Filter::REPAIR_CROSSING, orthoslices::CrossingContours::Repair, "Repair" },
  { Filter::REFUSE_CROSSING, orthoslices::CrossingContours::Refuse, "Refuse" },
  { Filter::LEAVE_OUT_CROSSING, orthoslices::CrossingContours::LeaveOut, "LeaveOut" }
};
constexpr Choice<orthoslices::LoopRule> LoopRules[] = { { Filter::UNION,
                                                          orthoslices::LoopRule::Union, "Union" },
  { Filter::EVEN_ODD, orthoslices::LoopRule::EvenOdd, "EvenOdd" },
  { Filter::NON_ZERO, orthoslices::LoopRule::NonZero, "NonZero" } };
constexpr Choice<orthoslices::FrameChoice> Frames[] = {
  { Filter::AUTOMATIC_FRAME, orthoslices::FrameChoice::Automatic, "Automatic" },
  { Filter::WORLD_FRAME, orthoslices::FrameChoice::World, "World" },
  { Filter::GIVEN_FRAME, orthoslices::FrameChoice::Given, "Given" }
};
constexpr Choice<orthoslices::VirtualSlices> VirtualSlicesModes[] = {
  { Filter::AUTOMATIC_VIRTUAL_SLICES, orthoslices::VirtualSlices::Automatic, "Automatic" },
  { Filter::NO_VIRTUAL_SLICES, orthoslices::VirtualSlices::Off, "Off" },
  { Filter::VIRTUAL_SLICES_BY_SPACING, orthoslices::VirtualSlices::BySpacing, "BySpacing" }
};
constexpr Choice<orthoslices::EndCaps> EndCapsModes[] = { { Filter::DOME_ENDS,
                                                            orthoslices::EndCaps::Dome, "Dome" },
  { Filter::FLAT_ENDS, orthoslices::EndCaps::Flat, "Flat" },
  { Filter::HALF_SLICE_ENDS, orthoslices::EndCaps::HalfSlice, "HalfSlice" } };
constexpr Choice<orthoslices::SeveralCycles> SeveralCyclesModes[] = {
  { Filter::BY_EVIDENCE, orthoslices::SeveralCycles::ByEvidence, "ByEvidence" },
  { Filter::DISCS, orthoslices::SeveralCycles::Discs, "Discs" }
};
constexpr Choice<orthoslices::CorrespondenceCriterion> Correspondences[] = {
  { Filter::CORRESPOND_BY_EVIDENCE, orthoslices::CorrespondenceCriterion::ByEvidence,
    "ByEvidence" },
  { Filter::CORRESPOND_BY_OVERLAP, orthoslices::CorrespondenceCriterion::Overlap, "Overlap" },
  { Filter::CORRESPOND_BY_ELLIPTICAL_CYLINDERS,
    orthoslices::CorrespondenceCriterion::EllipticalCylinders, "EllipticalCylinders" },
  { Filter::CORRESPOND_BY_SPANNING_TREE, orthoslices::CorrespondenceCriterion::SpanningTree,
    "SpanningTree" },
  { Filter::CORRESPOND_BY_REEB_GRAPH, orthoslices::CorrespondenceCriterion::ReebGraph, "ReebGraph" }
};
constexpr Choice<orthoslices::PatchMethod> PatchTypes[] = {
  { Filter::SMOOTH, orthoslices::PatchMethod::Smooth, "Smooth" },
  { Filter::FAN, orthoslices::PatchMethod::Fan, "Fan" },
  { Filter::COONS, orthoslices::PatchMethod::Coons, "Coons" }
};
constexpr Choice<orthoslices::CentralPointMethod> CentralPoints[] = {
  { Filter::LEAST_SQUARES, orthoslices::CentralPointMethod::LeastSquares, "LeastSquares" },
  { Filter::CENTROID, orthoslices::CentralPointMethod::Centroid, "Centroid" }
};

/// Whether the values of a property are the indices of its choices.
template <typename Option, int Count>
constexpr bool IsIndexed(const Choice<Option> (&choices)[Count])
{
  for (int i = 0; i < Count; ++i)
  {
    if (choices[i].Property != i)
    {
      return false;
    }
  }
  return true;
}
static_assert(IsIndexed(Orientations) && IsIndexed(InvalidContoursModes) &&
    IsIndexed(BorderContoursModes) && IsIndexed(CrossingContoursModes) && IsIndexed(LoopRules) &&
    IsIndexed(Frames) && IsIndexed(VirtualSlicesModes) && IsIndexed(SeveralCyclesModes) &&
    IsIndexed(EndCapsModes) && IsIndexed(Correspondences) && IsIndexed(PatchTypes) &&
    IsIndexed(CentralPoints),
  "The setters clamp properties to their first and last value");

/// One for each family, and one for contours of any families.
constexpr int InputPorts = 4;

/// More contour vertices than that do not fit into the core's numbers.
constexpr vtkIdType MaxVertices = std::numeric_limits<orthoslices::Index>::max() / 8;

/// From here on, progress is that of writing the surface.
constexpr double ProgressBeforeSurface = 0.9;
}

vtkOrthogonalSliceReconstruction::vtkOrthogonalSliceReconstruction()
{
  this->SetNumberOfInputPorts(InputPorts);
  this->SetNumberOfOutputPorts(8);
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

int vtkOrthogonalSliceReconstruction::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // Contours of all pieces belong together: every request needs the whole input.
  for (int port = 0; port < InputPorts; ++port)
  {
    vtkInformation* input = inputs[port]->GetInformationObject(0);
    if (input != nullptr)
    {
      input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
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
  const int from = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  if (outputs->GetInformationObject(from)->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1; // the first process makes the whole surface
  }
  if (!this->CheckProperties() || !this->CheckInputs(inputs))
  {
    return 0;
  }
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
    done = this->ReconstructAll(std::move(sorted), options, outputs);
  }
  if (done)
  {
    orthoslices::CarryFieldData(
      this->ListInputs(), vtkPolyData::GetData(outputs, 0), vtkPolyData::GetData(outputs, 1));
  }
  return done ? 1 : 0;
}

/// One structure: the outputs, or the reason why there are none, and what else to tell the user.
vtkOrthogonalSliceReconstruction::Outcome vtkOrthogonalSliceReconstruction::Reconstruct(
  orthoslices::SortedSlices&& sorted, const orthoslices::Options& options,
  const std::function<vtkInformationVector*()>& outputs, std::string& text)
{
  const orthoslices::Polylines others = std::move(sorted.Others);
  orthoslices::Reconstruction result =
    orthoslices::ReconstructSorted(std::move(sorted), options, orthoslices::ExecuteWithVtk(this));
  if (result.Stopped)
  {
    return Outcome::Stopped;
  }
  text = this->DescribeFailure(result);
  if (!text.empty())
  {
    return Outcome::Failed;
  }
  text = this->Report(result);
  vtkInformationVector* target = outputs();
  this->WriteOutputs(std::move(result), !options.SinglePrecision, target);
  text += this->CompareOthers(others, target);
  return Outcome::Done;
}

/// One surface of all contours. False, with empty outputs, if they are refused.
bool vtkOrthogonalSliceReconstruction::ReconstructAll(orthoslices::SortedSlices&& sorted,
  const orthoslices::Options& options, vtkInformationVector* outputs)
{
  std::string text;
  const Outcome outcome = this->Reconstruct(
    std::move(sorted), options, [outputs]() { return outputs; }, text);
  if (outcome == Outcome::Failed)
  {
    vtkErrorMacro(<< text);
  }
  else if (!text.empty())
  {
    vtkWarningMacro(<< text);
  }
  return outcome != Outcome::Failed;
}

namespace
{
/// Progress within a share of the whole, for as long as this lives.
class ShareOfProgress
{
public:
  ShareOfProgress(vtkAlgorithm* filter, double first, double share)
    : Filter(filter)
  {
    filter->SetProgressShiftScale(first, share);
  }
  ~ShareOfProgress() { this->Filter->SetProgressShiftScale(0.0, 1.0); }
  ShareOfProgress(const ShareOfProgress&) = delete;
  void operator=(const ShareOfProgress&) = delete;

private:
  vtkAlgorithm* Filter;
};
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
    vtkWarningMacro(<< labels.Unlabelled << " contours have no label in the cell array \""
                    << this->LabelArray << "\" and take no part in any surface.");
  }
  return labels;
}

/// One surface for each label, one after another; labels that are refused do not cost the others.
/// False, with empty outputs, if all are refused.
bool vtkOrthogonalSliceReconstruction::ReconstructLabels(orthoslices::SortedSlices&& sorted,
  const orthoslices::ContourLabels& labels, const orthoslices::Options& options,
  vtkInformationVector* outputs)
{
  std::vector<orthoslices::SortedSlices> parts =
    orthoslices::SplitByLabel(sorted, labels.OfLine, labels.Count());
  const double all = std::max<double>(1.0, orthoslices::CountVertices(sorted));
  sorted = orthoslices::SortedSlices();
  orthoslices::LabelOutputs appended(labels, outputs);
  orthoslices::SharedPatches shared;
  orthoslices::Options settings = options;
  settings.Patching.Shared = &shared;
  std::ostringstream refused, report;
  double before = 0.0;
  bool any = false;
  for (orthoslices::Index label = 0; label < labels.Count(); ++label)
  {
    const double share = orthoslices::CountVertices(parts[label]) / all;
    const ShareOfProgress progress(this, before, share);
    before += share;
    std::string text;
    const Outcome outcome = this->Reconstruct(
      std::move(parts[label]), settings, [&]() { return appended.Next(label); }, text);
    if (outcome == Outcome::Stopped)
    {
      return true;
    }
    any |= outcome == Outcome::Done;
    const std::string name = "\nLabel " + labels.NameOf(label);
    if (outcome == Outcome::Failed)
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
    vtkWarningMacro(<< refused.str() << report.str());
  }
  return true;
}

/// The inputs of all ports; null where there is none.
std::vector<vtkDataObject*> vtkOrthogonalSliceReconstruction::ListInputs()
{
  std::vector<vtkDataObject*> inputs;
  for (int port = 0; port < InputPorts; ++port)
  {
    const bool isConnected = this->GetNumberOfInputConnections(port) > 0;
    inputs.push_back(isConnected ? this->GetInputDataObject(port, 0) : nullptr);
  }
  return inputs;
}

namespace
{
/// Nine values as three vectors.
std::array<orthoslices::Point3, 3> GivenNormals(const double* values)
{
  std::array<orthoslices::Point3, 3> normals;
  for (int i = 0; i < 9; ++i)
  {
    normals[i / 3][i % 3] = values[i];
  }
  return normals;
}
}

/// Weights and tolerances that are numbers, and axes that are some; setters clamp the others.
bool vtkOrthogonalSliceReconstruction::CheckProperties()
{
  for (const double weight : this->AxisWeights)
  {
    if (!(weight >= 0.0 && std::isfinite(weight)))
    {
      vtkErrorMacro("AxisWeights has " << weight << "; weights must be finite and not negative.");
      return false;
    }
  }
  orthoslices::AxisFrame given;
  if (this->Frame == GIVEN_FRAME &&
    !orthoslices::MakeGivenFrame(GivenNormals(this->FrameNormals), given))
  {
    vtkErrorMacro(
      "FrameNormals must be the normals of three families of planes: three vectors that are "
      "not nearly in one plane.");
    return false;
  }
  // NaN is neither below nor above the range to which tolerances are clamped.
  for (const auto& tolerance : { std::make_pair("PlaneTolerance", this->PlaneTolerance),
         std::make_pair("ReportTolerance", this->ReportTolerance),
         std::make_pair("MinimumComponentSize", this->MinimumComponentSize),
         std::make_pair("MinimumIsolatedContourSize", this->MinimumIsolatedContourSize),
         std::make_pair("EdgeLength", this->EdgeLength),
         std::make_pair("ChordTolerance", this->ChordTolerance),
         std::make_pair("CornerAngle", this->CornerAngle),
         std::make_pair("Smoothing", this->Smoothing),
         std::make_pair("VirtualSliceSpacing", this->VirtualSliceSpacing),
         std::make_pair("ContourTolerance", this->ContourTolerance) })
  {
    if (std::isnan(tolerance.second))
    {
      vtkErrorMacro(<< tolerance.first << " is not a number.");
      return false;
    }
  }
  return true;
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
  orthoslices::FrameOptions options;
  options.Choice = Frames[this->Frame].Value;
  options.Given = GivenNormals(this->FrameNormals);
  options.PlaneTolerance = this->PlaneTolerance;
  return orthoslices::SortByPlanes(lines, options);
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

/// The properties in the terms of the core.
void vtkOrthogonalSliceReconstruction::GetOptions(orthoslices::Options& options) const
{
  options.PlaneTolerance = this->PlaneTolerance;
  options.Orient = Orientations[this->Orientation].Value;
  options.InsertMissing = this->InsertMissingContours;
  options.Virtual = VirtualSlicesModes[this->VirtualSlices].Value;
  options.VirtualSpacing = this->VirtualSliceSpacing;
  options.Ends = EndCapsModes[this->EndCaps].Value;
  options.Invalid = InvalidContoursModes[this->InvalidContours].Value;
  options.AtBorder = BorderContoursModes[this->BorderContours].Value;
  options.Crossing = CrossingContoursModes[this->CrossingContours].Value;
  options.Loops = LoopRules[this->LoopRule].Value;
  options.RedrawnShare = this->RedrawnTolerance;
  if (std::any_of(this->AxisWeights, this->AxisWeights + 3, [](double w) { return w > 0.0; }))
  {
    std::copy_n(this->AxisWeights, 3, options.Weights.begin());
  }
  options.Smoothing = this->Smoothing;
  options.ContourTolerance = this->ContourTolerance;
  options.Several = SeveralCyclesModes[this->SeveralCycles].Value;
  options.Criterion = Correspondences[this->Correspondence].Value;
  options.Known.Components = this->ExpectedComponents;
  options.Known.Genus = this->ExpectedGenus;
  options.MinComponent = this->MinimumComponentSize;
  options.MinIsolatedContour = this->MinimumIsolatedContourSize;
  options.Central = CentralPoints[this->CentralPoint].Value;
  options.Patching.Method = PatchTypes[this->PatchType].Value;
  options.Patching.EdgeLength = this->EdgeLength;
  options.Patching.ChordTolerance = this->ChordTolerance;
  options.Patching.CornerAngle = vtkMath::RadiansFromDegrees(this->CornerAngle);
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
  orthoslices::WriteContourTable(result, vtkTable::GetData(outputs, 3));
  orthoslices::WriteSliceTable(result, vtkTable::GetData(outputs, 4));
  orthoslices::WriteUndecidedTable(result, vtkTable::GetData(outputs, 5));
  orthoslices::WriteProblemTable(result, vtkTable::GetData(outputs, 6));
  orthoslices::WriteHistogram(result, vtkTable::GetData(outputs, 2));
  vtkPolyData* graph = vtkPolyData::GetData(outputs, 1);
  orthoslices::WriteGraph(result, doublePrecision, graph);
  // With labels, the array "Label" is that of the labels.
  const bool ownsLabel = this->UsesLabels() && std::string(this->LabelArray) != "Label";
  orthoslices::ArrayCarrier carrier(
    this->PassCellArrays ? this->ListInputs() : std::vector<vtkDataObject*>(), result,
    ownsLabel ? "Label" : "");
  carrier.AddToGraph(result, graph->GetCellData());
  carrier.ChooseContours(result, orthoslices::ExecuteWithVtk(this));
  this->UpdateProgress(ProgressBeforeSurface);
  const orthoslices::SurfaceArrayOptions arrays{ this->ComputeNormals, this->ComputeCurvatures };
  const double reportTolerance = this->ReportTolerance * result.Diagonal;
  const orthoslices::Box3 openBorder = result.OpenBorder;
  vtkPolyData* surface = vtkPolyData::GetData(outputs, 0);
  orthoslices::WriteSurface(std::move(result), orthoslices::ExecuteWithVtk(this), doublePrecision,
    arrays, reportTolerance, surface);
  carrier.AddToSurface(surface->GetCellData());
  orthoslices::CutAtBorder(openBorder, surface);
  orthoslices::WriteComponentTable(surface, vtkTable::GetData(outputs, 7));
  this->UpdateProgress(1.0);
}

/// Contours on planes of no family: how far the surface is from them, for the table and as text.
std::string vtkOrthogonalSliceReconstruction::CompareOthers(
  const orthoslices::Polylines& others, vtkInformationVector* outputs) const
{
  const std::vector<orthoslices::Agreement> distances =
    orthoslices::MeasureDistances(others, vtkPolyData::GetData(outputs, 0));
  orthoslices::WriteOthers(others, distances, vtkTable::GetData(outputs, 3));
  return orthoslices::DescribeOthers(others, distances);
}

void vtkOrthogonalSliceReconstruction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LabelArray: " << this->LabelArray << "\n";
  os << indent << "PlaneTolerance: " << this->PlaneTolerance << "\n";
  os << indent << "Orientation: " << Orientations[this->Orientation].Name << "\n";
  os << indent << "InvalidContours: " << InvalidContoursModes[this->InvalidContours].Name << "\n";
  os << indent << "BorderContours: " << BorderContoursModes[this->BorderContours].Name << "\n";
  os << indent << "CrossingContours: " << CrossingContoursModes[this->CrossingContours].Name
     << "\n";
  os << indent << "LoopRule: " << LoopRules[this->LoopRule].Name << "\n";
  os << indent << "RedrawnTolerance: " << this->RedrawnTolerance << "\n";
  os << indent << "Frame: " << Frames[this->Frame].Name << "\n";
  os << indent << "FrameNormals:";
  for (const double value : this->FrameNormals)
  {
    os << " " << value;
  }
  os << "\n";
  os << indent << "InsertMissingContours: " << (this->InsertMissingContours ? "On" : "Off") << "\n";
  os << indent << "VirtualSlices: " << VirtualSlicesModes[this->VirtualSlices].Name << "\n";
  os << indent << "VirtualSliceSpacing: " << this->VirtualSliceSpacing << "\n";
  os << indent << "EndCaps: " << EndCapsModes[this->EndCaps].Name << "\n";
  os << indent << "SeveralCycles: " << SeveralCyclesModes[this->SeveralCycles].Name << "\n";
  os << indent << "Correspondence: " << Correspondences[this->Correspondence].Name << "\n";
  os << indent << "ExpectedComponents: " << this->ExpectedComponents << "\n";
  os << indent << "ExpectedGenus: " << this->ExpectedGenus << "\n";
  os << indent << "MinimumComponentSize: " << this->MinimumComponentSize << "\n";
  os << indent << "MinimumIsolatedContourSize: " << this->MinimumIsolatedContourSize << "\n";
  os << indent << "PatchType: " << PatchTypes[this->PatchType].Name << "\n";
  os << indent << "EdgeLength: " << this->EdgeLength << "\n";
  os << indent << "ChordTolerance: " << this->ChordTolerance << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "ContourTolerance: " << this->ContourTolerance << "\n";
  os << indent << "CentralPoint: " << CentralPoints[this->CentralPoint].Name << "\n";
  os << indent << "AxisWeights: " << this->AxisWeights[0] << " " << this->AxisWeights[1] << " "
     << this->AxisWeights[2] << "\n";
  os << indent << "ReportTolerance: " << this->ReportTolerance << "\n";
  os << indent << "ComputeNormals: " << (this->ComputeNormals ? "On" : "Off") << "\n";
  os << indent << "ComputeCurvatures: " << (this->ComputeCurvatures ? "On" : "Off") << "\n";
  os << indent << "PassCellArrays: " << (this->PassCellArrays ? "On" : "Off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
