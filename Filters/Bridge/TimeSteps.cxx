// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/TimeSteps.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Appends the values of a key, if it is there.
void Append(vtkInformation* info, vtkInformationDoubleVectorKey* key, std::vector<double>& values)
{
  if (info != nullptr && info->Has(key))
  {
    const double* first = info->Get(key);
    values.insert(values.end(), first, first + info->Length(key));
  }
}
}

void DeclareTimeSteps(vtkInformationVector** inputs, int inputPorts, vtkInformationVector* outputs)
{
  std::vector<double> steps, ranges;
  for (int port = 0; port < inputPorts; ++port)
  {
    vtkInformation* info = inputs[port]->GetInformationObject(0);
    Append(info, vtkStreamingDemandDrivenPipeline::TIME_STEPS(), steps);
    Append(info, vtkStreamingDemandDrivenPipeline::TIME_RANGE(), ranges);
  }
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  ranges.insert(ranges.end(), steps.begin(), steps.end());
  const auto ends = std::minmax_element(ranges.begin(), ranges.end());
  for (int port = 0; port < outputs->GetNumberOfInformationObjects() && !ranges.empty(); ++port)
  {
    vtkInformation* info = outputs->GetInformationObject(port);
    const double range[] = { *ends.first, *ends.second };
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    if (!steps.empty())
    {
      info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), steps.data(),
        static_cast<int>(steps.size()));
    }
  }
}

void MarkTime(const std::vector<vtkDataObject*>& inputs, vtkInformationVector* outputs)
{
  const auto timed = std::find_if(inputs.begin(), inputs.end(),
    [](vtkDataObject* input)
    { return input != nullptr && input->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()); });
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* info = vtkDataObject::GetData(outputs, port)->GetInformation();
    if (timed != inputs.end())
    {
      info->Set(vtkDataObject::DATA_TIME_STEP(),
        (*timed)->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()));
    }
  }
}
}
