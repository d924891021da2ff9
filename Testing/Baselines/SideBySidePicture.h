// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   several surfaces beside each other from the same camera, as a PNG file
 *
 * Needs VTK's rendering modules: without ORTHOGONAL_SLICES_HAVE_RENDERING, writing fails with a
 * message. VTK's window wants an X display; xvfb-run gives one.
 */

#ifndef OrthoSlicesSideBySidePicture_h
#define OrthoSlicesSideBySidePicture_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace orthoslices
{
namespace baselines
{

class SideBySidePicture
{
public:
  /// One more panel on the right.
  void Add(const std::string& title, vtkPolyData* surface);

  /**
   * Renders all panels with the camera that shows the last surface completely.
   * @throw std::runtime_error if there are no panels, no rendering or no such folder.
   */
  void Write(const std::string& file) const;

private:
  struct Panel
  {
    std::string Title;
    vtkSmartPointer<vtkPolyData> Surface;
  };
  std::vector<Panel> Panels;
};

} // namespace baselines
} // namespace orthoslices

#endif
