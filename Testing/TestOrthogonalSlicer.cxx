// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOrthogonalSlicer.h"

#include "vtkAppendFilter.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkDelaunay3D.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkStripper.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{
constexpr double Pi = 3.14159265358979323846;

//----------------------------------------------------------------------------
/// Collects error messages instead of printing them.
class ErrorLog
{
public:
  explicit ErrorLog(vtkAlgorithm* filter)
    : Filter(filter)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* log, void* text)
      { static_cast<ErrorLog*>(log)->Text += static_cast<const char*>(text); });
    filter->AddObserver(vtkCommand::ErrorEvent, this->Command);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~ErrorLog()
  {
    this->Filter->RemoveObserver(this->Command);
    this->Filter->GetExecutive()->RemoveObserver(this->Command);
  }
  ErrorLog(const ErrorLog&) = delete;
  void operator=(const ErrorLog&) = delete;

  std::string Text;

private:
  vtkAlgorithm* Filter;
  vtkNew<vtkCallbackCommand> Command;
};

/// Runs a filter that should fail; its error messages.
std::string ErrorsOf(vtkOrthogonalSlicer* slicer)
{
  ErrorLog log(slicer);
  slicer->Update();
  for (int port = 0; port < 3; ++port)
  {
    EXPECT_EQ(slicer->GetOutput(port)->GetNumberOfPoints(), 0);
    EXPECT_EQ(slicer->GetOutput(port)->GetNumberOfCells(), 0);
  }
  return log.Text;
}

//----------------------------------------------------------------------------
std::vector<double> PlaneCoordinates(vtkPolyData* slices)
{
  vtkDataArray* all = slices->GetFieldData()->GetArray("PlaneCoordinates");
  std::vector<double> planes;
  for (vtkIdType i = 0; all && i < all->GetNumberOfTuples(); ++i)
  {
    planes.push_back(all->GetTuple1(i));
  }
  return planes;
}

/// Positive if the contour runs counter-clockwise seen from the positive end of the axis.
double ContourArea(vtkPolyData* slices, vtkIdType cell, int axis)
{
  vtkNew<vtkIdList> ids;
  slices->GetCellPoints(cell, ids);
  double twice = 0.0;
  for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
  {
    double p[3];
    double q[3];
    slices->GetPoint(ids->GetId(i), p);
    slices->GetPoint(ids->GetId(i + 1), q);
    twice += p[(axis + 1) % 3] * q[(axis + 2) % 3] - q[(axis + 1) % 3] * p[(axis + 2) % 3];
  }
  return 0.5 * twice;
}

double TotalArea(vtkPolyData* slices, int axis)
{
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < slices->GetNumberOfCells(); ++cell)
  {
    sum += ContourArea(slices, cell, axis);
  }
  return sum;
}

/// What the class promises of every output.
void ExpectValidSlices(vtkPolyData* slices, int axis)
{
  vtkDataArray* index = slices->GetCellData()->GetArray("PlaneIndex");
  vtkDataArray* coordinate = slices->GetCellData()->GetArray("PlaneCoordinate");
  ASSERT_TRUE(index && coordinate);
  ASSERT_EQ(index->GetDataType(), VTK_INT);
  ASSERT_EQ(coordinate->GetDataType(), VTK_DOUBLE);
  ASSERT_EQ(slices->GetNumberOfLines(), slices->GetNumberOfCells());
  const std::vector<double> planes = PlaneCoordinates(slices);
  ASSERT_TRUE(std::is_sorted(planes.begin(), planes.end()));
  std::vector<int> uses(static_cast<std::size_t>(slices->GetNumberOfPoints()), 0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < slices->GetNumberOfCells(); ++cell)
  {
    ASSERT_EQ(
      coordinate->GetTuple1(cell), planes.at(static_cast<std::size_t>(index->GetTuple1(cell))));
    slices->GetCellPoints(cell, ids);
    ASSERT_GE(ids->GetNumberOfIds(), 4);
    ASSERT_EQ(ids->GetId(0), ids->GetId(ids->GetNumberOfIds() - 1));
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      ++uses[static_cast<std::size_t>(ids->GetId(i))];
      ASSERT_EQ(slices->GetPoint(ids->GetId(i))[axis], coordinate->GetTuple1(cell));
    }
  }
  EXPECT_EQ(std::count(uses.begin(), uses.end(), 1), slices->GetNumberOfPoints());
}

std::vector<std::array<double, 3>> SortedPoints(vtkPolyData* slices)
{
  std::vector<std::array<double, 3>> points(static_cast<std::size_t>(slices->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    slices->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  std::sort(points.begin(), points.end());
  return points;
}

//----------------------------------------------------------------------------
vtkNew<vtkSphereSource> Sphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetCenter(0.1, 0.2, 0.3);
  sphere->SetThetaResolution(80);
  sphere->SetPhiResolution(60);
  return sphere;
}

using Field = std::function<double(double, double, double)>;

/// Fills the image's scalars with a function of the place in the world.
void Sample(vtkImageData* image, int type, const Field& field)
{
  image->AllocateScalars(type, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    image->GetPointData()->GetScalars()->SetTuple1(i, field(p[0], p[1], p[2]));
  }
}

double Ellipsoid(double x, double y, double z)
{
  return 1.0 - std::sqrt(x * x + 2 * y * y + 3 * (z - 0.1) * (z - 0.1));
}

/// 41 x 51 x 61 samples over a box around the ellipsoid.
void MakeEllipsoidImage(vtkImageData* image)
{
  image->SetExtent(3, 43, -5, 45, 0, 60);
  image->SetSpacing(0.06, 0.04, 0.03);
  image->SetOrigin(-1.38, -0.8, -0.83);
  Sample(image, VTK_DOUBLE, Ellipsoid);
}

/// The same world seen through permuted and flipped index axes: index axis i runs along axis
/// order[i] of the first image, in direction sign[i].
void Reindex(vtkImageData* from, vtkImageData* to, const int order[3], const int sign[3])
{
  vtkNew<vtkMatrix3x3> direction;
  direction->Zero();
  int size[3];
  double spacing[3];
  double origin[3];
  double bounds[6];
  from->GetBounds(bounds);
  for (int i = 0; i < 3; ++i)
  {
    const int axis = order[i];
    direction->SetElement(axis, i, sign[i]);
    size[i] = from->GetDimensions()[axis];
    spacing[i] = from->GetSpacing()[axis];
    origin[axis] = sign[i] > 0 ? bounds[2 * axis] : bounds[2 * axis + 1];
  }
  to->SetDimensions(size);
  to->SetSpacing(spacing);
  to->SetOrigin(origin);
  to->SetDirectionMatrix(direction);
  Sample(to, VTK_DOUBLE, Ellipsoid);
}
}

//----------------------------------------------------------------------------
// Surfaces

TEST(OrthogonalSlicer, DefaultsCutAnySourceIntoThirtyTwoPlanesPerAxis)
{
  vtkNew<vtkCubeSource> cube; // with three points at each corner
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(cube->GetOutputPort());
  slicer->Update();
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkPolyData* slices = slicer->GetOutput(axis);
    ExpectValidSlices(slices, axis);
    ASSERT_EQ(slices->GetNumberOfCells(), 32);
    EXPECT_NEAR(TotalArea(slices, axis), 32.0, 1e-5);
    EXPECT_EQ(PlaneCoordinates(slices).front(), -0.5 + 0.5 / 32);
  }
}

TEST(OrthogonalSlicer, SphereHasItsVolume)
{
  auto sphere = Sphere();
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(sphere->GetOutputPort());
  slicer->SetNumberOfSlices(40, 50, 60);
  slicer->Update();
  const int numbers[] = { 40, 50, 60 };
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkPolyData* slices = slicer->GetOutput(axis);
    ExpectValidSlices(slices, axis);
    EXPECT_EQ(slices->GetNumberOfCells(), numbers[axis]);
    EXPECT_NEAR(TotalArea(slices, axis) * 2.0 / numbers[axis], 4.0 / 3.0 * Pi, 0.02);
  }
}

TEST(OrthogonalSlicer, SpacingStartsHalfASpacingInside)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(cube->GetOutputPort());
  slicer->SetPlaneModeToSpacing();
  slicer->SetSpacing(0.5, 0.375, 3.0);
  slicer->Update();
  EXPECT_EQ(PlaneCoordinates(slicer->GetOutput(0)), (std::vector<double>{ -0.25, 0.25 }));
  EXPECT_EQ(
    PlaneCoordinates(slicer->GetOutput(1)), (std::vector<double>{ -0.3125, 0.0625, 0.4375 }));
  EXPECT_TRUE(PlaneCoordinates(slicer->GetOutput(2)).empty());
}

TEST(OrthogonalSlicer, CoordinatesAreSortedAndCountOnce)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(cube->GetOutputPort());
  slicer->SetPlaneModeToCoordinates();
  slicer->SetNumberOfXCoordinates(4);
  slicer->SetXCoordinate(0, 0.25);
  slicer->SetXCoordinate(1, -0.125);
  slicer->SetXCoordinate(2, 0.25);
  slicer->SetXCoordinate(3, 9.0);
  slicer->SetZCoordinate(0, 0.0);
  EXPECT_EQ(slicer->GetNumberOfZCoordinates(), 1);
  slicer->Update();
  EXPECT_EQ(PlaneCoordinates(slicer->GetOutput(0)), (std::vector<double>{ -0.125, 0.25, 9.0 }));
  EXPECT_EQ(slicer->GetOutput(0)->GetNumberOfCells(), 2);
  EXPECT_EQ(slicer->GetOutput(1)->GetNumberOfCells(), 0);
  EXPECT_EQ(slicer->GetOutput(2)->GetNumberOfCells(), 1);
  ExpectValidSlices(slicer->GetOutput(0), 0);
}

TEST(OrthogonalSlicer, PrecisionFollowsTheInputUnlessSet)
{
  for (const int input : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
  {
    for (const int set : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION,
           vtkAlgorithm::DEFAULT_PRECISION })
    {
      auto sphere = Sphere();
      sphere->SetOutputPointsPrecision(input);
      vtkNew<vtkOrthogonalSlicer> slicer;
      slicer->SetInputConnection(sphere->GetOutputPort());
      slicer->SetNumberOfSlices(7, 7, 7);
      slicer->SetOutputPointsPrecision(set);
      slicer->Update();
      const int expected = set == vtkAlgorithm::DEFAULT_PRECISION ? input : set;
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_EQ(slicer->GetOutput(axis)->GetPoints()->GetDataType(),
          expected == vtkAlgorithm::SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE);
        ExpectValidSlices(slicer->GetOutput(axis), axis); // the planes survive the rounding
      }
    }
  }
}

TEST(OrthogonalSlicer, StripsAndPolygonsAreTriangulated)
{
  auto sphere = Sphere();
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkOrthogonalSlicer> fromTriangles;
  fromTriangles->SetInputConnection(sphere->GetOutputPort());
  fromTriangles->Update();
  vtkNew<vtkOrthogonalSlicer> fromStrips;
  fromStrips->SetInputConnection(strips->GetOutputPort());
  fromStrips->Update();
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(
      SortedPoints(fromStrips->GetOutput(axis)), SortedPoints(fromTriangles->GetOutput(axis)));
  }
}

TEST(OrthogonalSlicer, ThreadsDoNotChangeTheOutput)
{
  auto sphere = Sphere();
  const auto run = [&sphere](int threads, vtkPolyData* outputs)
  {
    const auto slice = [&]()
    {
      vtkNew<vtkOrthogonalSlicer> slicer;
      slicer->SetInputConnection(sphere->GetOutputPort());
      slicer->Update();
      outputs->ShallowCopy(slicer->GetOutput(1));
    };
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false }, slice);
  };
  vtkNew<vtkPolyData> one;
  vtkNew<vtkPolyData> four;
  run(1, one);
  run(4, four);
  ASSERT_EQ(one->GetNumberOfPoints(), four->GetNumberOfPoints());
  ASSERT_EQ(one->GetNumberOfCells(), four->GetNumberOfCells());
  for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    one->GetPoint(i, p);
    four->GetPoint(i, q);
    ASSERT_TRUE(std::equal(p, p + 3, q));
  }
}

//----------------------------------------------------------------------------
// Images

TEST(OrthogonalSlicer, ImageOfAnEllipsoidHasItsContours)
{
  vtkNew<vtkImageData> image;
  MakeEllipsoidImage(image);
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(image);
  slicer->SetNumberOfSlices(12, 1000, 12);
  slicer->Update();
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkPolyData* slices = slicer->GetOutput(axis);
    ExpectValidSlices(slices, axis);
    ASSERT_GE(slices->GetNumberOfCells(), 8);
    EXPECT_EQ(slices->GetPoints()->GetDataType(), VTK_DOUBLE);
    for (vtkIdType i = 0; i < slices->GetNumberOfPoints(); ++i)
    {
      const double* p = slices->GetPoint(i);
      EXPECT_NEAR(Ellipsoid(p[0], p[1], p[2]), 0.0, 4e-3);
    }
    for (vtkIdType cell = 0; cell < slices->GetNumberOfCells(); ++cell)
    {
      EXPECT_GT(ContourArea(slices, cell, axis), 0.0);
    }
  }
  EXPECT_EQ(PlaneCoordinates(slicer->GetOutput(1)).size(), 51u); // every sample plane once
}

TEST(OrthogonalSlicer, SlicesOfAnImageShareTheirCrossings)
{
  vtkNew<vtkImageData> image;
  MakeEllipsoidImage(image);
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(image);
  slicer->SetNumberOfSlices(10, 10, 10);
  slicer->Update();
  for (int axis = 0; axis < 3; ++axis)
  {
    const int other = (axis + 1) % 3;
    // Vertices of the one family that lie on planes of the other have to be vertices of both.
    const auto onPlanesOf = [&](int family, int planesOf)
    {
      const auto planes = PlaneCoordinates(slicer->GetOutput(planesOf));
      std::set<std::array<double, 3>> found;
      for (const auto& p : SortedPoints(slicer->GetOutput(family)))
      {
        if (std::binary_search(planes.begin(), planes.end(), p[planesOf]))
        {
          found.insert(p);
        }
      }
      return found;
    };
    EXPECT_GT(onPlanesOf(axis, other).size(), 20u);
    EXPECT_EQ(onPlanesOf(axis, other), onPlanesOf(other, axis));
  }
}

TEST(OrthogonalSlicer, LabelsAreDrawnHalfway)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(9, 9, 9);
  const auto inner = [](double x) { return x >= 2 && x <= 5; };
  Sample(image, VTK_UNSIGNED_CHAR,
    [&](double x, double y, double z) { return inner(x) && inner(y) && inner(z) ? 7 : 9; });
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(image);
  slicer->UseLabelOn();
  slicer->SetLabelValue(7);
  slicer->Update();
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkPolyData* slices = slicer->GetOutput(axis);
    ExpectValidSlices(slices, axis);
    ASSERT_EQ(slices->GetNumberOfCells(), 4);
    EXPECT_DOUBLE_EQ(ContourArea(slices, 0, axis), 15.5); // 4 x 4 with its corners cut
  }
  slicer->SetLabelValue(9);
  slicer->Update();
  vtkPolyData* around = slicer->GetOutput(2);
  ASSERT_EQ(around->GetNumberOfCells(), 9 + 4);
  EXPECT_DOUBLE_EQ(TotalArea(around, 2), 9 * 80.5 - 4 * 15.5); // the border is half outside
  slicer->SetLabelValue(8);
  slicer->Update();
  EXPECT_EQ(slicer->GetOutput(2)->GetNumberOfCells(), 0);
}

TEST(OrthogonalSlicer, PlanesOfAnImageMoveToTheNearestSample)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 5, 5);
  image->SetSpacing(2, 2, 2);
  Sample(image, VTK_FLOAT, [](double, double, double) { return 1.0; });
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(image);
  slicer->SetPlaneModeToCoordinates();
  const double xs[] = { 0.9, 1.0, 3.1, 8.9, 9.5, -1.0, -1.5 };
  for (int i = 0; i < 7; ++i)
  {
    slicer->SetXCoordinate(i, xs[i]);
  }
  slicer->Update();
  EXPECT_EQ(PlaneCoordinates(slicer->GetOutput(0)), (std::vector<double>{ 0, 2, 4, 8 }));
  slicer->SetPlaneModeToNumber();
  slicer->SetNumberOfSlices(2, 3, 4);
  slicer->Update();
  EXPECT_EQ(PlaneCoordinates(slicer->GetOutput(0)), (std::vector<double>{ 2, 6 }));
}

TEST(OrthogonalSlicer, FlippedAndPermutedImagesGiveTheSameContours)
{
  vtkNew<vtkImageData> image;
  MakeEllipsoidImage(image);
  vtkNew<vtkOrthogonalSlicer> expected;
  expected->SetInputData(image);
  expected->SetNumberOfSlices(9, 8, 7);
  expected->Update();
  const int orders[][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 1, 0 } };
  const int signs[][3] = { { 1, 1, 1 }, { -1, 1, 1 }, { 1, -1, -1 }, { -1, -1, -1 } };
  for (const auto& order : orders)
  {
    for (const auto& sign : signs)
    {
      vtkNew<vtkImageData> other;
      Reindex(image, other, order, sign);
      vtkNew<vtkOrthogonalSlicer> slicer;
      slicer->SetInputData(other);
      slicer->SetNumberOfSlices(9, 8, 7);
      slicer->Update();
      for (int axis = 0; axis < 3; ++axis)
      {
        ExpectValidSlices(slicer->GetOutput(axis), axis);
        EXPECT_NEAR(TotalArea(slicer->GetOutput(axis), axis),
          TotalArea(expected->GetOutput(axis), axis), 1e-9);
        const auto a = SortedPoints(slicer->GetOutput(axis));
        EXPECT_EQ(a.size(), SortedPoints(expected->GetOutput(axis)).size());
        double bounds[2][6];
        slicer->GetOutput(axis)->GetBounds(bounds[0]);
        expected->GetOutput(axis)->GetBounds(bounds[1]);
        for (int i = 0; i < 6; ++i)
        {
          EXPECT_NEAR(bounds[0][i], bounds[1][i], 1e-12);
        }
      }
    }
  }
}

/// Slices of the same samples with another direction matrix are the same slices, moved: the image's
/// axes, given for x, y and z, say where to.
void ExpectMovedSlices(vtkImageData* image, const double direction[9],
  const std::array<std::array<double, 3>, 3>& axes, int precision)
{
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(image);
  slicer->SetNumberOfSlices(9, 8, 7);
  slicer->SetOutputPointsPrecision(precision);
  slicer->Update();
  std::array<vtkNew<vtkPolyData>, 3> expected;
  for (int axis = 0; axis < 3; ++axis)
  {
    expected[axis]->DeepCopy(slicer->GetOutput(axis));
  }

  // The origin stays where it is along the axes.
  double origin[3] = { 0, 0, 0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < 3; ++i)
    {
      origin[i] += image->GetOrigin()[axis] * axes[axis][i];
    }
  }
  vtkNew<vtkImageData> moved;
  moved->ShallowCopy(image);
  moved->SetOrigin(origin);
  moved->SetDirectionMatrix(direction);
  slicer->SetInputData(moved);
  slicer->Update();
  const double tolerance = precision == vtkAlgorithm::SINGLE_PRECISION ? 1e-6 : 1e-12;
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkPolyData* slices = slicer->GetOutput(axis);
    ASSERT_EQ(slices->GetNumberOfPoints(), expected[axis]->GetNumberOfPoints());
    ASSERT_EQ(slices->GetNumberOfCells(), expected[axis]->GetNumberOfCells());
    EXPECT_EQ(slices->GetPoints()->GetDataType(), expected[axis]->GetPoints()->GetDataType());
    for (vtkIdType id = 0; id < slices->GetNumberOfPoints(); ++id)
    {
      double p[3];
      double q[3];
      expected[axis]->GetPoint(id, p);
      slices->GetPoint(id, q);
      for (int i = 0; i < 3; ++i)
      {
        ASSERT_NEAR(q[i], p[0] * axes[0][i] + p[1] * axes[1][i] + p[2] * axes[2][i], tolerance);
      }
    }
    const auto planes = PlaneCoordinates(slices);
    const auto expectedPlanes = PlaneCoordinates(expected[axis]);
    ASSERT_EQ(planes.size(), expectedPlanes.size());
    for (std::size_t i = 0; i < planes.size(); ++i)
    {
      EXPECT_NEAR(planes[i], expectedPlanes[i], tolerance);
    }
  }
}

TEST(OrthogonalSlicer, SlicesOfAnObliqueImageLieInTheWorld)
{
  vtkNew<vtkImageData> image;
  MakeEllipsoidImage(image);
  for (const int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
  {
    const double turned[] = { 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1 };
    ExpectMovedSlices(
      image, turned, { { { 0.8, 0.6, 0 }, { -0.6, 0.8, 0 }, { 0, 0, 1 } } }, precision);
    // An inclined gantry: the third axis is not perpendicular to the slices.
    const double sheared[] = { 1, 0, 0, 0, 1, 0.28, 0, 0, 0.96 };
    ExpectMovedSlices(
      image, sheared, { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0.28, 0.96 } } }, precision);
  }
}

TEST(OrthogonalSlicer, AxesOfAnObliqueImageGoToThePortsTheyAreClosestTo)
{
  // The same ellipsoid in the world, sampled along two turned axes, flipped and permuted.
  vtkNew<vtkImageData> image;
  image->SetDimensions(71, 75, 77);
  image->SetSpacing(0.03, 0.03, 0.03);
  image->SetDirectionMatrix(0, 0.6, 0.8, 0, -0.8, 0.6, -1, 0, 0);
  image->SetOrigin(-1.58, 0.2, 1.15);
  Sample(image, VTK_DOUBLE, Ellipsoid);
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(image);
  slicer->SetNumberOfSlices(77, 75, 71); // all samples
  slicer->Update();
  const double normals[3][3] = { { 0.8, 0.6, 0 }, { -0.6, 0.8, 0 }, { 0, 0, 1 } };
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkPolyData* slices = slicer->GetOutput(axis);
    ASSERT_GT(slices->GetNumberOfCells(), 5);
    vtkDataArray* coordinate = slices->GetCellData()->GetArray("PlaneCoordinate");
    double volume = 0.0;
    for (vtkIdType cell = 0; cell < slices->GetNumberOfCells(); ++cell)
    {
      vtkNew<vtkIdList> ids;
      slices->GetCellPoints(cell, ids);
      for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
      {
        double p[3];
        double q[3];
        slices->GetPoint(ids->GetId(i), p);
        slices->GetPoint(ids->GetId(i + 1), q);
        double cross[3];
        vtkMath::Cross(p, q, cross);
        volume += 0.5 * vtkMath::Dot(cross, normals[axis]);
        EXPECT_NEAR(vtkMath::Dot(p, normals[axis]), coordinate->GetTuple1(cell), 1e-12);
        EXPECT_NEAR(Ellipsoid(p[0], p[1], p[2]), 0.0, 2e-3);
      }
    }
    const auto planes = PlaneCoordinates(slices);
    volume *= planes[1] - planes[0];
    EXPECT_NEAR(volume, 4.0 / 3.0 * Pi / std::sqrt(6.0), 0.005) << "seen along " << axis;
  }
}

TEST(OrthogonalSlicer, OneSampleThickImagesAreClosedToo)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 3, 1);
  Sample(image, VTK_INT, [](double, double, double) { return 1.0; });
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(image);
  slicer->Update();
  EXPECT_EQ(slicer->GetOutput(0)->GetNumberOfCells(), 4);
  EXPECT_EQ(slicer->GetOutput(2)->GetNumberOfCells(), 1);
  EXPECT_DOUBLE_EQ(TotalArea(slicer->GetOutput(2), 2), 11.5);
  ExpectValidSlices(slicer->GetOutput(0), 0);
}

TEST(OrthogonalSlicer, ChosenArrayIsSliced)
{
  vtkNew<vtkImageData> image;
  MakeEllipsoidImage(image);
  image->GetPointData()->GetScalars()->SetName("distance");
  image->GetPointData()->SetActiveScalars(nullptr);
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(image);
  EXPECT_NE(ErrorsOf(slicer).find("point scalars"), std::string::npos);
  slicer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "distance");
  slicer->SetIsoValue(0.5);
  slicer->Update();
  ASSERT_GT(slicer->GetOutput(0)->GetNumberOfPoints(), 0);
  const double* p = slicer->GetOutput(0)->GetPoint(0);
  EXPECT_NEAR(Ellipsoid(p[0], p[1], p[2]), 0.5, 1e-2);
}

//----------------------------------------------------------------------------
// Errors

TEST(OrthogonalSlicer, OpenSurfaceIsAnErrorThatNamesAnEdge)
{
  auto sphere = Sphere();
  sphere->SetEndTheta(270);
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(sphere->GetOutputPort());
  const std::string errors = ErrorsOf(slicer);
  EXPECT_NE(errors.find("open: the edge from (0.1, 0.2, "), std::string::npos) << errors;
  sphere->SetEndTheta(360);
  slicer->Update(); // recovers
  EXPECT_GT(slicer->GetOutput(0)->GetNumberOfPoints(), 0);
}

TEST(OrthogonalSlicer, InconsistentTrianglesAreAnError)
{
  auto sphere = Sphere();
  sphere->Update();
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(sphere->GetOutput());
  surface->ReverseCell(17);
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(surface);
  EXPECT_NE(ErrorsOf(slicer).find("not oriented consistently"), std::string::npos);
}

TEST(OrthogonalSlicer, EmptyInputIsAnError)
{
  vtkNew<vtkOrthogonalSlicer> slicer;
  vtkNew<vtkPolyData> nothing;
  slicer->SetInputData(nothing);
  EXPECT_NE(ErrorsOf(slicer).find("no triangles"), std::string::npos);
  vtkNew<vtkImageData> image;
  slicer->SetInputData(image);
  EXPECT_FALSE(ErrorsOf(slicer).empty());
}

TEST(OrthogonalSlicer, PlanesThatCannotBeAreErrors)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(cube->GetOutputPort());
  slicer->SetNumberOfSlices(0, 0, 0);
  EXPECT_NE(ErrorsOf(slicer).find("NumberOfSlices"), std::string::npos);
  slicer->SetPlaneModeToSpacing();
  slicer->SetSpacing(1, 0, 1);
  EXPECT_NE(ErrorsOf(slicer).find("Spacing 0 on axis 1"), std::string::npos);
  slicer->SetSpacing(1e-9, 1, 1);
  EXPECT_NE(ErrorsOf(slicer).find("at most 100000"), std::string::npos);
  slicer->SetPlaneModeToCoordinates();
  EXPECT_NE(ErrorsOf(slicer).find("none on any axis"), std::string::npos);
  slicer->SetYCoordinate(0, std::nan(""));
  EXPECT_NE(ErrorsOf(slicer).find("not finite"), std::string::npos);
}

TEST(OrthogonalSlicer, SingularDirectionMatrixIsAnError)
{
  vtkNew<vtkImageData> image;
  MakeEllipsoidImage(image);
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(image);
  image->SetDirectionMatrix(1, 1, 0, 0, 0, 0, 0, 0, 1);
  EXPECT_NE(ErrorsOf(slicer).find("direction matrix is singular"), std::string::npos);
  image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 0);
  EXPECT_NE(ErrorsOf(slicer).find("direction matrix is singular"), std::string::npos);
}

TEST(OrthogonalSlicer, CellDataIsAnErrorThatSaysSo)
{
  vtkNew<vtkImageData> image;
  MakeEllipsoidImage(image);
  vtkSmartPointer<vtkDataArray> scalars = image->GetPointData()->GetScalars();
  scalars->SetName("values");
  scalars->Resize(image->GetNumberOfCells());
  image->GetPointData()->Initialize();
  image->GetCellData()->SetScalars(scalars);
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(image);
  EXPECT_NE(ErrorsOf(slicer).find("cell data"), std::string::npos);
  slicer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "values");
  EXPECT_NE(ErrorsOf(slicer).find("not on the image's points"), std::string::npos);
}

//----------------------------------------------------------------------------
TEST(OrthogonalSlicer, SolidCellsAreSlicedAsTheirSurface)
{
  // 4 x 3 x 3 voxels without one inside: a box with a cavity.
  vtkNew<vtkImageData> box;
  box->SetDimensions(5, 4, 4);
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(box);
  append->Update();
  vtkNew<vtkUnstructuredGrid> cells;
  cells->SetPoints(append->GetOutput()->GetPoints());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < append->GetOutput()->GetNumberOfCells(); ++cell)
  {
    append->GetOutput()->GetCellPoints(cell, ids);
    if (cell != 1 + 4 * (1 + 3 * 1))
    {
      cells->InsertNextCell(VTK_VOXEL, ids);
    }
  }
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetNumberOfSlices(4, 3, 3);
  slicer->SetInputData(cells);
  slicer->Update();
  const double volumes[3] = { 4 * 9.0 - 1.0, 3 * 12.0 - 1.0, 3 * 12.0 - 1.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    ExpectValidSlices(slicer->GetOutput(axis), axis);
    EXPECT_NEAR(TotalArea(slicer->GetOutput(axis), axis), volumes[axis], 1e-4);
  }
  EXPECT_EQ(slicer->GetOutput(0)->GetNumberOfCells(), 5); // one slice has a hole

  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(5, 4, 4);
  grid->SetPoints(cells->GetPoints());
  slicer->SetInputData(grid);
  slicer->Update();
  EXPECT_NEAR(TotalArea(slicer->GetOutput(2), 2), 3 * 12.0, 1e-4);

  // Tetrahedra in a ball; cells without a volume have no surface.
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkDelaunay3D> tetrahedra;
  tetrahedra->SetInputConnection(sphere->GetOutputPort());
  slicer->SetInputConnection(tetrahedra->GetOutputPort());
  slicer->Update();
  EXPECT_EQ(slicer->GetOutput(1)->GetNumberOfCells(), 3);
  slicer->SetInputData(vtkNew<vtkUnstructuredGrid>());
  EXPECT_NE(ErrorsOf(slicer).find("no triangles"), std::string::npos);
}

//----------------------------------------------------------------------------
namespace
{
/// Adds the point data "Linear", x + 2 y - 3 z, and "Name", which has nothing between two points.
void AddLinear(vtkDataSet* data)
{
  vtkNew<vtkDoubleArray> values;
  vtkNew<vtkStringArray> names;
  values->SetName("Linear");
  names->SetName("Name");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* p = data->GetPoint(i);
    values->InsertNextValue(p[0] + 2.0 * p[1] - 3.0 * p[2]);
    names->InsertNextValue("point");
  }
  data->GetPointData()->AddArray(values);
  data->GetPointData()->AddArray(names);
}

/// Checks that all points have the values of AddLinear; their number.
int ExpectLinear(vtkOrthogonalSlicer* slicer)
{
  slicer->Update();
  int count = 0;
  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData* slices = slicer->GetOutput(port);
    EXPECT_EQ(slices->GetPointData()->GetAbstractArray("Name"), nullptr);
    vtkDataArray* values = slices->GetPointData()->GetArray("Linear");
    EXPECT_TRUE(values && values->GetNumberOfTuples() == slices->GetNumberOfPoints());
    for (vtkIdType i = 0; values && i < slices->GetNumberOfPoints(); ++i, ++count)
    {
      const double* p = slices->GetPoint(i);
      EXPECT_NEAR(values->GetTuple1(i), p[0] + 2.0 * p[1] - 3.0 * p[2], 1e-5);
    }
  }
  return count;
}
}

TEST(OrthogonalSlicer, PointDataAreInterpolated)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(20);
  sphere->Update();
  AddLinear(sphere->GetOutput());
  vtkNew<vtkImageData> box;
  box->SetDimensions(5, 4, 4);
  AddLinear(box);
  vtkNew<vtkAppendFilter> solid; // a mesh of solid cells
  solid->AddInputData(box);
  solid->Update();
  vtkDataSet* const inputs[] = { sphere->GetOutput(), solid->GetOutput() };
  for (vtkDataSet* input : inputs)
  {
    vtkNew<vtkOrthogonalSlicer> slicer;
    slicer->SetInputData(input);
    EXPECT_GT(ExpectLinear(slicer), 500);
  }
}

//----------------------------------------------------------------------------
namespace
{
/// Coordinates from -1 to 1 that are denser in the middle.
vtkSmartPointer<vtkRectilinearGrid> MakeRectilinearBall()
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  vtkNew<vtkDoubleArray> coordinates, inside;
  for (int i = -10; i <= 10; ++i)
  {
    coordinates->InsertNextValue(0.05 * i + 0.005 * i * std::abs(i));
  }
  grid->SetDimensions(21, 21, 21);
  grid->SetXCoordinates(coordinates);
  grid->SetYCoordinates(coordinates);
  grid->SetZCoordinates(coordinates);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double* p = grid->GetPoint(i);
    inside->InsertNextValue(0.64 - p[0] * p[0] - p[1] * p[1] - p[2] * p[2]);
  }
  inside->SetName("Inside");
  grid->GetPointData()->SetScalars(inside);
  AddLinear(grid);
  return grid;
}
}

TEST(OrthogonalSlicer, RectilinearGridsAreSlicedAsImages)
{
  const auto grid = MakeRectilinearBall();
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(grid);
  slicer->SetPlaneModeToCoordinates();
  for (int axis = 0; axis < 3; ++axis)
  {
    slicer->SetCoordinate(axis, 0, 0.0);
    slicer->SetCoordinate(axis, 1, 0.5); // the nearest sample is 0.48
    slicer->SetCoordinate(axis, 2, 1.2); // beyond: left out
  }
  EXPECT_GT(ExpectLinear(slicer), 100);
  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData* slices = slicer->GetOutput(port);
    ExpectValidSlices(slices, port);
    EXPECT_EQ(slices->GetPointData()->GetScalars(), nullptr);
    const std::vector<double> planes = PlaneCoordinates(slices);
    ASSERT_EQ(planes.size(), 2u);
    EXPECT_NEAR(planes[1], 0.48, 1e-12);
    EXPECT_NEAR(TotalArea(slices, port), Pi * (0.64 + 0.64 - 0.48 * 0.48), 0.05);
  }

  vtkNew<vtkDoubleArray> falling;
  for (int i = 0; i <= 20; ++i)
  {
    falling->InsertNextValue(-i);
  }
  grid->SetYCoordinates(falling);
  EXPECT_NE(ErrorsOf(slicer).find("do not ascend"), std::string::npos);
}

//----------------------------------------------------------------------------
// Conduct in a pipeline

TEST(OrthogonalSlicer, SettersModifyOnlyOnChange)
{
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetXCoordinate(2, 1.5);
  const vtkMTimeType time = slicer->GetMTime();
  slicer->SetXCoordinate(2, 1.5);
  slicer->SetNumberOfXCoordinates(3);
  slicer->SetIsoValue(0.0);
  slicer->SetNumberOfSlices(32, 32, 32);
  EXPECT_EQ(slicer->GetMTime(), time);
  EXPECT_EQ(slicer->GetXCoordinate(0), 0.0);
  slicer->SetXCoordinate(1, 4.0);
  EXPECT_GT(slicer->GetMTime(), time);
}

TEST(OrthogonalSlicer, ReExecutionGivesTheSameOutput)
{
  auto sphere = Sphere();
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(sphere->GetOutputPort());
  slicer->Update();
  const auto first = SortedPoints(slicer->GetOutput(2));
  slicer->Modified();
  slicer->Update();
  EXPECT_EQ(SortedPoints(slicer->GetOutput(2)), first);
}

TEST(OrthogonalSlicer, ProgressAscendsToOne)
{
  auto sphere = Sphere();
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(sphere->GetOutputPort());
  std::vector<double> progress;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&progress);
  watch->SetCallback([](vtkObject*, unsigned long, void* values, void* value)
    { static_cast<std::vector<double>*>(values)->push_back(*static_cast<double*>(value)); });
  slicer->AddObserver(vtkCommand::ProgressEvent, watch);
  slicer->Update();
  EXPECT_GE(progress.size(), 6u); // what other threads do, is heard of at the ends of loops
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.back(), 1.0);
}

TEST(OrthogonalSlicer, AbortLeavesEmptyOutputs)
{
  auto sphere = Sphere();
  sphere->Update();
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(sphere->GetOutput());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* filter, unsigned long, void*, void*)
    {
      auto* running = static_cast<vtkOrthogonalSlicer*>(filter);
      running->SetAbortExecute(running->GetProgress() > 0.5);
    });
  const unsigned long tag = slicer->AddObserver(vtkCommand::ProgressEvent, stop);
  slicer->Update();
  EXPECT_EQ(slicer->GetOutput(0)->GetNumberOfPoints(), 0);
  EXPECT_EQ(slicer->GetOutput(2)->GetNumberOfPoints(), 0);
  slicer->RemoveObserver(tag);
  slicer->SetAbortExecute(0);
  slicer->Modified();
  slicer->Update();
  EXPECT_GT(slicer->GetOutput(2)->GetNumberOfPoints(), 0);
}

TEST(OrthogonalSlicer, LaterPiecesAreEmpty)
{
  auto sphere = Sphere();
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(sphere->GetOutputPort());
  slicer->UpdatePiece(0, 2, 0);
  const auto whole = slicer->GetOutput(0)->GetNumberOfCells();
  EXPECT_EQ(whole, 32);
  slicer->UpdatePiece(1, 2, 0);
  EXPECT_EQ(slicer->GetOutput(0)->GetNumberOfCells(), 0);
}

TEST(OrthogonalSlicer, PrintsItsParameters)
{
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetYCoordinate(0, 12.5);
  std::ostringstream text;
  slicer->Print(text);
  for (const char* words : { "PlaneMode: Number", "NumberOfSlices: 32 32 32", "Spacing: 1 1 1",
         "YCoordinates: 12.5", "IsoValue: 0", "UseLabel: Off", "LabelValue: 1", "EveryLabel: Off",
         "BackgroundLabel: 0", "OutputPointsPrecision: 2" })
  {
    EXPECT_NE(text.str().find(words), std::string::npos) << words;
  }
}
