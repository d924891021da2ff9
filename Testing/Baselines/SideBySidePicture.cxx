// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SideBySidePicture.h"

#include <stdexcept>

#ifdef ORTHOGONAL_SLICES_HAVE_RENDERING

#include "vtkActor.h"
#include "vtkAutoInit.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

VTK_MODULE_INIT(vtkRenderingOpenGL2)
VTK_MODULE_INIT(vtkRenderingFreeType)

#endif

namespace orthoslices
{
namespace baselines
{

//------------------------------------------------------------------------------
void SideBySidePicture::Add(const std::string& title, vtkPolyData* surface)
{
  this->Panels.push_back({ title, surface });
}

#ifdef ORTHOGONAL_SLICES_HAVE_RENDERING

namespace
{

constexpr int PanelWidth = 280;
constexpr int PanelHeight = 330;

//------------------------------------------------------------------------------
// The normals of the surface, or else the means of those of the triangles.
vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* surface)
{
  if (surface->GetPointData()->GetNormals())
  {
    return surface;
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

//------------------------------------------------------------------------------
// Smooth lighting; the inside, which shows at holes, is red.
vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(WithNormals(surface));
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.80, 0.76, 0.68);
  actor->GetProperty()->SetSpecular(0.2);
  actor->GetProperty()->SetSpecularPower(25.0);
  vtkNew<vtkProperty> inside;
  inside->SetColor(0.75, 0.25, 0.20);
  actor->SetBackfaceProperty(inside);
  return actor;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTextActor> MakeTitle(const std::string& text)
{
  auto title = vtkSmartPointer<vtkTextActor>::New();
  title->SetInput(text.c_str());
  title->SetPosition(PanelWidth / 2, 10);
  title->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
  title->GetTextProperty()->SetFontSize(16);
  title->GetTextProperty()->SetJustificationToCentered();
  return title;
}

//------------------------------------------------------------------------------
// From the front, the right and above, with the z-axis up.
vtkSmartPointer<vtkCamera> MakeCamera(vtkPolyData* surface)
{
  double bounds[6];
  surface->GetBounds(bounds);
  vtkNew<vtkRenderer> renderer;
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(0.55, -1.0, 0.4);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->SetActiveCamera(camera);
  renderer->ResetCamera(bounds);
  camera->Zoom(1.2);
  return camera;
}

} // anonymous namespace

//------------------------------------------------------------------------------
void SideBySidePicture::Write(const std::string& file) const
{
  if (this->Panels.empty())
  {
    throw std::runtime_error("there is nothing to show in " + file);
  }
  const vtkSmartPointer<vtkCamera> camera = MakeCamera(this->Panels.back().Surface);
  const double width = 1.0 / static_cast<double>(this->Panels.size());
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(PanelWidth * static_cast<int>(this->Panels.size()), PanelHeight);
  for (std::size_t i = 0; i < this->Panels.size(); ++i)
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(i * width, 0.0, (i + 1) * width, 1.0);
    renderer->SetBackground(1.0, 1.0, 1.0);
    renderer->AddActor(MakeActor(this->Panels[i].Surface));
    renderer->AddViewProp(MakeTitle(this->Panels[i].Title));
    renderer->SetActiveCamera(camera);
    window->AddRenderer(renderer);
    renderer->ResetCameraClippingRange();
  }
  window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->SetCompressionLevel(9);
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw std::runtime_error("cannot write " + file);
  }
}

#else

//------------------------------------------------------------------------------
void SideBySidePicture::Write(const std::string& file) const
{
  throw std::runtime_error("cannot write " + file + ": this program was built without rendering");
}

#endif

} // namespace baselines
} // namespace orthoslices
