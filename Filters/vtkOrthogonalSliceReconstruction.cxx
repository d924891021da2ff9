// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOrthogonalSliceReconstruction.h"

#include "Bridge/DescribeReport.h"
#include "Bridge/WriteSurface.h"

#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

vtkStandardNewMacro(vtkOrthogonalSliceReconstruction);

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkOrthogonalSliceReconstruction::vtkOrthogonalSliceReconstruction()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(6);
}

int vtkOrthogonalSliceReconstruction::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
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
  if (family < 1 || family > 3)
  {
    vtkErrorMacro("Family " << family << " must be 1 (x-slices), 2 (y-slices) or 3 (z-slices).");
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

int vtkOrthogonalSliceReconstruction::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // Contours of all pieces belong together: every request needs the whole input.
  for (int port = 0; port < 3; ++port)
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
  const int from = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  if (outputs->GetInformationObject(from)->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  for (const double weight : this->AxisWeights)
  {
    if (!(weight >= 0.0 && std::isfinite(weight)))
    {
      vtkErrorMacro("AxisWeights has " << weight << "; weights must be finite and not negative.");
      return 0;
    }
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
         std::make_pair("ContourTolerance", this->ContourTolerance) })
  {
    if (std::isnan(tolerance.second))
    {
      vtkErrorMacro(<< tolerance.first << " is not a number.");
      return 0;
    }
  }
  bool doublePrecision = this->OutputPointsPrecision == DOUBLE_PRECISION;
  if (this->GetTotalNumberOfInputConnections() == 0)
  {
    vtkErrorMacro("No input: connect contours to port 0 (x-slices), 1 (y-slices) or 2 (z-slices).");
    return 0;
  }
  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData* input = vtkPolyData::GetData(inputs[port]);
    if (this->GetNumberOfInputConnections(port) == 0)
    {
      continue;
    }
    if (input == nullptr || input->GetNumberOfLines() + input->GetNumberOfPolys() == 0)
    {
      vtkErrorMacro("Port " << port << " (" << orthoslices::AxisNames[port]
                            << "-slices) has no contours: no lines and no polygons.");
      return 0;
    }
    const vtkIdType vertices = input->GetLines()->GetNumberOfConnectivityIds() +
      input->GetPolys()->GetNumberOfConnectivityIds();
    if (vertices > std::numeric_limits<orthoslices::Index>::max() / 8)
    {
      vtkErrorMacro("Port " << port << " has " << vertices << " contour vertices, more than "
                            << std::numeric_limits<orthoslices::Index>::max() / 8 << ".");
      return 0;
    }
    doublePrecision |= this->OutputPointsPrecision == DEFAULT_PRECISION &&
      input->GetPoints()->GetDataType() == VTK_DOUBLE;
  }
  std::array<orthoslices::Pieces, 3> pieces;
  for (int port = 0; port < 3; ++port)
  {
    pieces[port].Axis = port;
    if (this->GetNumberOfInputConnections(port) > 0)
    {
      pieces[port] =
        orthoslices::ReadPieces(vtkPolyData::GetData(inputs[port]), port, doublePrecision);
    }
  }

  orthoslices::Options options;
  options.PlaneTolerance = this->PlaneTolerance;
  options.Orient = this->Orientation == ORIENT_AS_DRAWN ? orthoslices::Orientation::AsDrawn
                                                        : orthoslices::Orientation::ByNesting;
  options.SinglePrecision = !doublePrecision;
  if (std::any_of(this->AxisWeights, this->AxisWeights + 3, [](double w) { return w > 0.0; }))
  {
    std::copy_n(this->AxisWeights, 3, options.Weights.begin());
  }
  options.RefuseInvalid = this->InvalidContours == REFUSE;
  options.Crossing = this->CrossingContours == REPAIR_CROSSING
    ? orthoslices::CrossingContours::Repair
    : this->CrossingContours == REFUSE_CROSSING ? orthoslices::CrossingContours::Refuse
                                                : orthoslices::CrossingContours::LeaveOut;
  options.Central = this->CentralPoint == CENTROID ? orthoslices::CentralPointMethod::Centroid
                                                   : orthoslices::CentralPointMethod::LeastSquares;
  options.Patching.Method = static_cast<orthoslices::PatchMethod>(this->PatchType);
  options.Patching.EdgeLength = this->EdgeLength;
  options.Patching.ChordTolerance = this->ChordTolerance;
  options.Patching.CornerAngle = vtkMath::RadiansFromDegrees(this->CornerAngle);
  options.Smoothing = this->Smoothing;
  options.ContourTolerance = this->ContourTolerance;
  options.Several = this->SeveralCycles == DISCS ? orthoslices::SeveralCycles::Discs
                                                 : orthoslices::SeveralCycles::ByEvidence;
  options.Criterion = static_cast<orthoslices::CorrespondenceCriterion>(this->Correspondence);
  options.Known.Components = this->ExpectedComponents;
  options.Known.Genus = this->ExpectedGenus;
  options.MinComponent = this->MinimumComponentSize;
  options.MinIsolatedContour = this->MinimumIsolatedContourSize;
  orthoslices::Execution execution;
  execution.For = [](std::size_t count, const orthoslices::Execution::Range& run)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(count),
      [&run](vtkIdType begin, vtkIdType end) { run(begin, end); });
  };
  execution.Continue = [this](double progress)
  {
    this->UpdateProgress(progress);
    return !this->GetAbortExecute();
  };
  orthoslices::Reconstruction result =
    orthoslices::Reconstruct(std::move(pieces), options, execution);

  if (result.Stopped)
  {
    return 1;
  }
  if (result.Refused)
  {
    std::vector<orthoslices::Problem> problems = result.Invalid;
    problems.insert(problems.end(), result.CrossingProblems.begin(), result.CrossingProblems.end());
    vtkErrorMacro("The input has "
      << problems.size() << " unusable contours:" << orthoslices::DescribeProblems(problems));
    return 0;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (result.Grid.Count(axis) >= VTK_UNSIGNED_SHORT_MAX)
    {
      vtkErrorMacro("Port " << axis << " has contours on " << result.Grid.Count(axis)
                            << " planes, more than " << VTK_UNSIGNED_SHORT_MAX - 1
                            << "; is PlaneTolerance too small?");
      return 0;
    }
  }
  const double reportTolerance = this->ReportTolerance * result.Diagonal;
  orthoslices::RemoveSmallRepairs(reportTolerance, result.Repairs);
  orthoslices::ReportSettings settings;
  settings.Tolerance = reportTolerance;
  settings.RepairsCrossing = this->CrossingContours == REPAIR_CROSSING;
  if (this->SeveralCycles == BY_EVIDENCE)
  {
    settings.Expected = options.Known;
  }
  const std::string doubts = orthoslices::DescribeReport(result, settings);
  if (!doubts.empty())
  {
    vtkWarningMacro(<< doubts);
  }
  orthoslices::WriteContourTable(result, vtkTable::GetData(outputs, 3));
  orthoslices::WriteSliceTable(result, vtkTable::GetData(outputs, 4));
  orthoslices::WriteUndecidedTable(result, vtkTable::GetData(outputs, 5));
  orthoslices::WriteHistogram(result, vtkTable::GetData(outputs, 2));
  orthoslices::WriteGraph(result, doublePrecision, vtkPolyData::GetData(outputs, 1));
  this->UpdateProgress(0.9);
  const orthoslices::SurfaceArrayOptions arrays{ this->ComputeNormals, this->ComputeCurvatures };
  orthoslices::WriteSurface(std::move(result), execution, doublePrecision, arrays, reportTolerance,
    vtkPolyData::GetData(outputs, 0));
  this->UpdateProgress(1.0);
  return 1;
}

void vtkOrthogonalSliceReconstruction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PlaneTolerance: " << this->PlaneTolerance << "\n";
  os << indent
     << "Orientation: " << (this->Orientation == ORIENT_AS_DRAWN ? "AsDrawn" : "ByNesting") << "\n";
  os << indent << "InvalidContours: " << (this->InvalidContours == REFUSE ? "Refuse" : "LeaveOut")
     << "\n";
  os << indent << "CrossingContours: "
     << (this->CrossingContours == REPAIR_CROSSING      ? "Repair"
            : this->CrossingContours == REFUSE_CROSSING ? "Refuse"
                                                        : "LeaveOut")
     << "\n";
  os << indent << "SeveralCycles: " << (this->SeveralCycles == DISCS ? "Discs" : "ByEvidence")
     << "\n";
  const char* correspondences[] = { "ByEvidence", "Overlap", "EllipticalCylinders", "SpanningTree",
    "ReebGraph" };
  os << indent << "Correspondence: " << correspondences[this->Correspondence] << "\n";
  os << indent << "ExpectedComponents: " << this->ExpectedComponents << "\n";
  os << indent << "ExpectedGenus: " << this->ExpectedGenus << "\n";
  os << indent << "MinimumComponentSize: " << this->MinimumComponentSize << "\n";
  os << indent << "MinimumIsolatedContourSize: " << this->MinimumIsolatedContourSize << "\n";
  const char* patchTypes[] = { "Smooth", "Fan", "Coons" };
  os << indent << "PatchType: " << patchTypes[this->PatchType] << "\n";
  os << indent << "EdgeLength: " << this->EdgeLength << "\n";
  os << indent << "ChordTolerance: " << this->ChordTolerance << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "ContourTolerance: " << this->ContourTolerance << "\n";
  os << indent << "CentralPoint: " << (this->CentralPoint == CENTROID ? "Centroid" : "LeastSquares")
     << "\n";
  os << indent << "AxisWeights: " << this->AxisWeights[0] << " " << this->AxisWeights[1] << " "
     << this->AxisWeights[2] << "\n";
  os << indent << "ReportTolerance: " << this->ReportTolerance << "\n";
  os << indent << "ComputeNormals: " << (this->ComputeNormals ? "On" : "Off") << "\n";
  os << indent << "ComputeCurvatures: " << (this->ComputeCurvatures ? "On" : "Off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
