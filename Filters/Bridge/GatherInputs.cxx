// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/GatherInputs.h"

#include "Bridge/ReadPieces.h"

#include "vtkAppendPolyData.h"
#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <stdexcept>

namespace orthoslices
{
namespace
{
/// One block of a port's input, or the field data of a composite input as one without cells.
struct BlockHeader
{
  std::int64_t Port;
  std::int64_t Block; ///< flat index: 0 if the input is not composite
  std::int64_t IsComposite;
  std::int64_t Size; ///< bytes of the data that follow
};

void AppendBlock(vtkDataObject* data, BlockHeader header, Ranks::Bytes& bytes)
{
  vtkNew<vtkCharArray> buffer;
  if (vtkCommunicator::MarshalDataObject(data, buffer) == 0)
  {
    throw std::runtime_error("An input could not be packed for other processes.");
  }
  header.Size = buffer->GetNumberOfValues();
  const char* first = reinterpret_cast<const char*>(&header);
  bytes.insert(bytes.end(), first, first + sizeof(header));
  bytes.insert(bytes.end(), buffer->GetPointer(0), buffer->GetPointer(0) + header.Size);
}

/// All blocks of all ports, with what they carry.
Ranks::Bytes Pack(const std::vector<vtkDataObject*>& inputs)
{
  Ranks::Bytes bytes;
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    const std::int64_t number = static_cast<std::int64_t>(port);
    const bool isComposite = vtkCompositeDataSet::SafeDownCast(inputs[port]) != nullptr;
    if (isComposite)
    {
      vtkNew<vtkPolyData> carrier;
      carrier->SetFieldData(inputs[port]->GetFieldData());
      AppendBlock(carrier, { number, 0, 1, 0 }, bytes);
    }
    VisitPolyData(inputs[port],
      [&](vtkPolyData* data, Index block) {
        AppendBlock(data, { number, block, isComposite ? 1 : 0, 0 }, bytes);
      });
  }
  return bytes;
}

/// A block of all processes that have it.
struct Block
{
  std::vector<vtkSmartPointer<vtkPolyData>> Parts;
  std::set<Ranks::Bytes> Packed; ///< to tell copies
};

/// The blocks of one port.
struct Port
{
  std::map<std::int64_t, Block> Blocks; ///< by their flat indices
  bool IsComposite = false;
};

void Unpack(const Ranks::Bytes& bytes, std::vector<Port>& ports)
{
  for (std::size_t at = 0; at + sizeof(BlockHeader) <= bytes.size();)
  {
    BlockHeader header;
    std::memcpy(&header, bytes.data() + at, sizeof(header));
    at += sizeof(header);
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    at += static_cast<std::size_t>(header.Size);
    Port& port = ports[static_cast<std::size_t>(header.Port)];
    port.IsComposite |= header.IsComposite != 0;
    Block& block = port.Blocks[header.Block];
    const auto packed = block.Packed.emplace(first, first + header.Size);
    if (!packed.second)
    {
      continue;
    }
    vtkNew<vtkCharArray> buffer;
    buffer->SetArray(const_cast<char*>(packed.first->data()), header.Size, 1);
    auto data = vtkCommunicator::UnMarshalDataObject(buffer);
    auto* part = vtkPolyData::SafeDownCast(data);
    if (part == nullptr)
    {
      throw std::runtime_error("An input of another process could not be read.");
    }
    block.Parts.emplace_back(part);
  }
}

/// One data set with the cells of all parts, in their order.
vtkSmartPointer<vtkPolyData> Join(const Block& block)
{
  std::vector<vtkPolyData*> filled;
  for (vtkPolyData* part : block.Parts)
  {
    if (part->GetNumberOfCells() > 0)
    {
      filled.push_back(part);
    }
  }
  auto joined = vtkSmartPointer<vtkPolyData>::New();
  if (filled.size() == 1)
  {
    joined->ShallowCopy(filled.front());
  }
  else if (!filled.empty())
  {
    vtkNew<vtkAppendPolyData> append;
    for (vtkPolyData* part : filled)
    {
      append->AddInputData(part);
    }
    append->Update();
    joined->ShallowCopy(append->GetOutput());
  }
  else
  {
    joined->ShallowCopy(block.Parts.front());
  }
  vtkNew<vtkFieldData> fields;
  for (vtkPolyData* part : block.Parts)
  {
    vtkFieldData* own = part->GetFieldData();
    for (int i = 0; i < own->GetNumberOfArrays(); ++i)
    {
      const char* name = own->GetArrayName(i);
      if (name == nullptr || !fields->HasArray(name))
      {
        fields->AddArray(own->GetAbstractArray(i));
      }
    }
  }
  joined->SetFieldData(fields);
  return joined;
}

/// The input of a port: composite if those of the processes are.
vtkSmartPointer<vtkDataObject> Assemble(const Port& port)
{
  if (port.Blocks.empty())
  {
    return nullptr;
  }
  if (!port.IsComposite)
  {
    return Join(port.Blocks.begin()->second);
  }
  // Blocks of one level have flat indices from 1 on, whatever levels they were on.
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const auto& block : port.Blocks)
  {
    if (block.first == 0)
    {
      blocks->SetFieldData(Join(block.second)->GetFieldData());
    }
    else
    {
      blocks->SetBlock(static_cast<unsigned int>(block.first - 1), Join(block.second));
    }
  }
  return blocks;
}
}

std::vector<vtkSmartPointer<vtkDataObject>> GatherInputs(
  const std::vector<vtkDataObject*>& inputs, const Ranks& ranks)
{
  std::vector<Port> ports(inputs.size());
  for (const Ranks::Bytes& bytes : ranks.Gather(Pack(inputs)))
  {
    Unpack(bytes, ports);
  }
  std::vector<vtkSmartPointer<vtkDataObject>> gathered;
  std::transform(ports.begin(), ports.end(), std::back_inserter(gathered), Assemble);
  return gathered;
}
}
