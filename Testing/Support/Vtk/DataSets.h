// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the shapes in the folder Data, with their known topology
 */

#ifndef OrthoSlicesDataSets_h
#define OrthoSlicesDataSets_h

#include "Support/TextContours.h"

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace orthoslices
{
namespace support
{

struct DataSet
{
  std::string Name;
  int Components;
  int Genus;
  /// Contours cut from one surface; else drawn plane by plane, so that the families disagree.
  bool Consistent;
};

/// All of them, in alphabetical order.
std::vector<DataSet> AllDataSets();

/// Contours on `count` (16 or 32) planes across `axis`. Throws std::runtime_error.
vtkSmartPointer<vtkPolyData> ReadContours(const DataSet& data, int count, int axis);

/// The same as pieces, with cells numbered as in the files.
PieceSets ReadPieceSets(const DataSet& data, int count);

/// The known surface.
vtkSmartPointer<vtkPolyData> ReadTruth(const DataSet& data);

} // namespace support
} // namespace orthoslices

#endif
