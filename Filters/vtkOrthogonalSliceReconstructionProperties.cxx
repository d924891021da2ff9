// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
// The properties of vtkOrthogonalSliceReconstruction: checked, in the terms of the core, and
// printed.
#include "vtkOrthogonalSliceReconstruction.h"

#include "Core/Frames/SortByPlanes.h"
#include "Core/Options.h"

#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
  for (const auto& tolerance :
    { std::make_pair("PlaneTolerance", this->PlaneTolerance),
      std::make_pair("ReportTolerance", this->ReportTolerance),
      std::make_pair("MinimumComponentSize", this->MinimumComponentSize),
      std::make_pair("MinimumIsolatedContourSize", this->MinimumIsolatedContourSize),
      std::make_pair("EdgeLength", this->EdgeLength),
      std::make_pair("ChordTolerance", this->ChordTolerance),
      std::make_pair("Accuracy", this->Accuracy), std::make_pair("CornerAngle", this->CornerAngle),
      std::make_pair("Smoothing", this->Smoothing),
      std::make_pair("RedrawnTolerance", this->RedrawnTolerance),
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

/// What the properties say of the directions of the planes.
orthoslices::FrameOptions vtkOrthogonalSliceReconstruction::GetFrameOptions() const
{
  orthoslices::FrameOptions options;
  options.Choice = Frames[this->Frame].Value;
  options.Given = GivenNormals(this->FrameNormals);
  options.PlaneTolerance = this->PlaneTolerance;
  return options;
}

/// The properties in the terms of the core.
void vtkOrthogonalSliceReconstruction::GetOptions(orthoslices::Options& options) const
{
  options.PlaneTolerance = this->PlaneTolerance;
  options.Orient = Orientations[this->Orientation].Value;
  options.InsertMissing = this->InsertMissingContours;
  options.Virtual = VirtualSlicesModes[this->VirtualSlices].Value;
  options.VirtualSpacing = this->VirtualSliceSpacing;
  options.FollowField = this->FollowField;
  options.Ends = EndCapsModes[this->EndCaps].Value;
  options.Invalid = InvalidContoursModes[this->InvalidContours].Value;
  options.AtBorder = BorderContoursModes[this->BorderContours].Value;
  for (int axis = 0; axis < 3; ++axis)
  {
    options.GivenBorder.Low[axis] = this->BorderBounds[2 * axis];
    options.GivenBorder.High[axis] = this->BorderBounds[2 * axis + 1];
  }
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
  options.Patching.Accuracy = this->Accuracy;
  options.Patching.OwnAccuracy = this->AutomaticAccuracy && !(this->ChordTolerance > 0.0);
  options.Patching.KeepContours = this->KeepContourVertices;
  options.Patching.CornerAngle = vtkMath::RadiansFromDegrees(this->CornerAngle);
}

void vtkOrthogonalSliceReconstruction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LabelArray: " << this->LabelArray << "\n";
  os << indent << "PlaneTolerance: " << this->PlaneTolerance << "\n";
  os << indent << "Orientation: " << Orientations[this->Orientation].Name << "\n";
  os << indent << "InvalidContours: " << InvalidContoursModes[this->InvalidContours].Name << "\n";
  os << indent << "BorderContours: " << BorderContoursModes[this->BorderContours].Name << "\n";
  os << indent << "BorderBounds:";
  for (const double value : this->BorderBounds)
  {
    os << " " << value;
  }
  os << "\n";
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
  os << indent << "FollowField: " << (this->FollowField ? "On" : "Off") << "\n";
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
  os << indent << "Accuracy: " << this->Accuracy << "\n";
  os << indent << "AutomaticAccuracy: " << (this->AutomaticAccuracy ? "On" : "Off") << "\n";
  os << indent << "KeepContourVertices: " << (this->KeepContourVertices ? "On" : "Off") << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "ContourTolerance: " << this->ContourTolerance << "\n";
  os << indent << "CentralPoint: " << CentralPoints[this->CentralPoint].Name << "\n";
  os << indent << "AxisWeights: " << this->AxisWeights[0] << " " << this->AxisWeights[1] << " "
     << this->AxisWeights[2] << "\n";
  os << indent << "ReportTolerance: " << this->ReportTolerance << "\n";
  os << indent << "WarnOfMissingFamilies: " << (this->WarnOfMissingFamilies ? "On" : "Off") << "\n";
  os << indent << "ComputeNormals: " << (this->ComputeNormals ? "On" : "Off") << "\n";
  os << indent << "ComputeCurvatures: " << (this->ComputeCurvatures ? "On" : "Off") << "\n";
  os << indent << "PassCellArrays: " << (this->PassCellArrays ? "On" : "Off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
