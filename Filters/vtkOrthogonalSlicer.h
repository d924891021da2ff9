// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOrthogonalSlicer
 * @brief   cut a closed surface or an image into three orthogonal sets of contours
 *
 * Makes input for vtkOrthogonalSliceReconstruction from any model: cuts a closed surface, or the
 * region of an image at or above an iso-value or with one label, or each label of an image by
 * itself, on three families of parallel planes, each orthogonal to one coordinate axis; of an image
 * with a direction matrix, orthogonal to one axis of the image.
 *
 * @section SlicerInputs Inputs
 * Port 0, one of
 *  - vtkPolyData: a closed surface of triangles, polygons or strips (other cells are ignored).
 *    Every edge must have exactly two triangles that pass it in opposite directions. Points with
 *    identical coordinates count as one where the surface would be open otherwise (as at the
 *    creases of vtkCubeSource). A surface that encloses a negative volume is taken for one that is
 *    oriented inwards, and reversed as a whole.
 *  - vtkUnstructuredGrid, vtkStructuredGrid: a mesh of solid cells. The faces that only one cell
 *    has are its surface, for which the same holds.
 *  - vtkImageData: scalars on points, chosen with SetInputArrayToProcess() (default: the active
 *    point scalars; of several components the first). It may have any direction matrix that is
 *    not singular: see below. A scalar that is not a number is outside. Blanking is ignored.
 *  - vtkRectilinearGrid: the same, with samples at coordinates that ascend along each axis.
 *
 * In parallel runs the first process slices the whole input and the others' outputs are empty.
 *
 * @section SlicerOutputs Outputs
 * Ports 0, 1 and 2 (vtkPolyData): the contours on planes of constant x, y and z. Each contour is a
 * closed polyline whose last point id is its first. Seen from the positive end of the axis the
 * interior lies on the left: outer boundaries run counter-clockwise, holes clockwise. The points'
 * coordinate along the axis is exactly the plane's. Contours are ordered by plane.
 *  - cell data "PlaneIndex" (int): index of the plane on this axis in ascending order, where
 *    planes without contours count;
 *  - cell data "PlaneCoordinate" (double): the plane's coordinate;
 *  - cell data "Label" (of the type of the scalars), with EveryLabel only: the label of the
 *    contour; contours are ordered by plane, then by label;
 *  - point data: what the points of the input carry, interpolated linearly as vtkCutter does it, on
 *    the padding of an image from its nearest samples; without arrays that have nothing in between
 *    (strings, ids);
 *  - field data "PlaneCoordinates" (double): coordinates of all planes of this axis, ascending.
 *
 * @section Planes Planes
 * For a surface the planes lie where PlaneMode says, between the bounds lo and hi of its
 * triangles. For an image, lo and hi are its first and last sample on the axis, and every plane
 * moves to the nearest sample (to the upper one of two), at most to the first or last; explicit
 * coordinates more than half a sample spacing beyond these are dropped. Planes that coincide
 * count once. With float output (OutputPointsPrecision) the planes are rounded to float first and
 * the cut is made there.
 *
 * @section SlicerGuarantees Guarantees
 * The rule that a point is above a plane when its coordinate is at least the plane's leaves no
 * singular positions: a surface that touches a plane or lies in it is cut as infinitesimally below
 * the plane.
 *  1. Every contour is closed and oriented, whatever the input's position.
 *  2. Contours of one slice neither cross nor touch themselves or each other as long as the
 *     surface does not and points are wider apart than the rounding of their coordinates. For
 *     this, contour vertices keep a distance from the ends of the mesh or grid edge they lie on:
 *     at most 2e-10 of the surface's largest coordinate (3e-7 for float output), and 1e-4 of an
 *     image's sample spacing.
 *  3. Contours of two orthogonal slices cross at the same point: for an image they share that
 *     vertex exactly; for a surface the difference is of the order of rounding and of the
 *     distances under 2.
 *  4. The output is the same for any number of threads.
 *
 * @section Images Contours of images
 * Contours connect points on the lines between neighbouring samples of a plane: at the linearly
 * interpolated iso-value, or halfway for a label. Diagonally adjacent interior samples of a
 * square whose other samples are outside remain separate. The interior ends at the image's border
 * as if the image were padded with outside samples: half a spacing beyond the last sample.
 *
 * @section Oblique Oblique images
 * Where the direction matrix does no more than permute and flip the axes, planes are those of
 * constant x, y and z. Else the slices are those of the image itself, and the contours lie on
 * oblique planes, where they belong in the world. Ports 0, 1 and 2 have the slices across the image
 * axes that are closest to x, y and z (all three together), each directed as its coordinate axis
 * is. Planes and "PlaneCoordinate" are given along these axes: with unit vectors a, b and c along
 * them, a point has the coordinates u, v and w for which it is u a + v b + w c. So "x" in the
 * properties below is u. What is said above about a coordinate that equals the plane's then holds
 * up to rounding; contours of two slices still share their crossings exactly. The axes need not be
 * perpendicular to each other (images of an inclined gantry); where they are left-handed in the
 * order of the ports, the axis that is farthest from its coordinate axis runs the other way.
 * vtkOrthogonalSliceReconstruction finds such planes from the contours.
 *
 * @section SlicerErrors Errors
 * With an error message and empty outputs: a surface that is open, has an edge with more than two
 * triangles or inconsistently oriented triangles (the first such edge is named with its
 * coordinates), points that are not finite, an image without point scalars or with a singular
 * direction matrix, a spacing that is not positive, plane coordinates that are not finite, no plane
 * at all.
 *
 * @sa vtkOrthogonalSliceReconstruction vtkCutter vtkFlyingEdges2D
 */

#ifndef vtkOrthogonalSlicer_h
#define vtkOrthogonalSlicer_h

#include "vtkFiltersOrthogonalSlicesModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // for the explicit coordinates

class vtkDataArray;
class vtkDataSet;

namespace orthoslices
{
struct ImageFrame;
struct SampleGrid;
}

class VTKFILTERSORTHOGONALSLICES_EXPORT vtkOrthogonalSlicer : public vtkPolyDataAlgorithm
{
public:
  ///@{
  /// As in every class of VTK.
  static vtkOrthogonalSlicer* New();
  vtkTypeMacro(vtkOrthogonalSlicer, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /// Values of SetPlaneMode().
  enum PlaneModes
  {
    BY_NUMBER = 0,
    BY_SPACING = 1,
    BY_COORDINATES = 2
  };

  ///@{
  /**
   * How the planes of each axis are given: by NumberOfSlices (default), by Spacing or by explicit
   * coordinates.
   */
  vtkSetClampMacro(PlaneMode, int, BY_NUMBER, BY_COORDINATES);
  vtkGetMacro(PlaneMode, int);
  void SetPlaneModeToNumber() { this->SetPlaneMode(BY_NUMBER); }
  void SetPlaneModeToSpacing() { this->SetPlaneMode(BY_SPACING); }
  void SetPlaneModeToCoordinates() { this->SetPlaneMode(BY_COORDINATES); }
  ///@}

  ///@{
  /**
   * BY_NUMBER: number n of planes on the x-, y- and z-axis, at lo + (i + 0.5) * (hi - lo) / n, so
   * that none touches the bounds. Default 32, 32, 32; 0 for none, at most 100000.
   */
  vtkSetVector3Macro(NumberOfSlices, int);
  vtkGetVector3Macro(NumberOfSlices, int);
  ///@}

  ///@{
  /**
   * BY_SPACING: distance s of the planes on the x-, y- and z-axis in world units, at
   * lo + (i + 0.5) * s below hi. Default 1, 1, 1; must be positive and make at most 100000 planes.
   */
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);
  ///@}

  ///@{
  /**
   * BY_COORDINATES: the planes' coordinates on one axis (0, 1, 2 for x, y, z), in any order.
   * Setting a coordinate beyond the number of coordinates raises the number. Default none.
   */
  void SetNumberOfCoordinates(int axis, int number);
  int GetNumberOfCoordinates(int axis);
  void SetCoordinate(int axis, int index, double coordinate);
  double GetCoordinate(int axis, int index);
  ///@}

  ///@{
  /**
   * BY_COORDINATES: the same for each axis by name.
   */
  void SetNumberOfXCoordinates(int number) { this->SetNumberOfCoordinates(0, number); }
  void SetNumberOfYCoordinates(int number) { this->SetNumberOfCoordinates(1, number); }
  void SetNumberOfZCoordinates(int number) { this->SetNumberOfCoordinates(2, number); }
  int GetNumberOfXCoordinates() { return this->GetNumberOfCoordinates(0); }
  int GetNumberOfYCoordinates() { return this->GetNumberOfCoordinates(1); }
  int GetNumberOfZCoordinates() { return this->GetNumberOfCoordinates(2); }
  void SetXCoordinate(int index, double coordinate) { this->SetCoordinate(0, index, coordinate); }
  void SetYCoordinate(int index, double coordinate) { this->SetCoordinate(1, index, coordinate); }
  void SetZCoordinate(int index, double coordinate) { this->SetCoordinate(2, index, coordinate); }
  double GetXCoordinate(int index) { return this->GetCoordinate(0, index); }
  double GetYCoordinate(int index) { return this->GetCoordinate(1, index); }
  double GetZCoordinate(int index) { return this->GetCoordinate(2, index); }
  ///@}

  ///@{
  /**
   * Images: samples with scalars of at least this value are inside. Default 0.
   */
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /**
   * Images: whether samples whose scalar equals LabelValue are inside, instead of those at or
   * above IsoValue. Default off.
   */
  vtkSetMacro(UseLabel, bool);
  vtkGetMacro(UseLabel, bool);
  vtkBooleanMacro(UseLabel, bool);
  ///@}

  ///@{
  /**
   * Images: the label used with UseLabel. Default 1.
   */
  vtkSetMacro(LabelValue, int);
  vtkGetMacro(LabelValue, int);
  ///@}

  ///@{
  /**
   * Images: whether the scalars are labels, each of which is cut by itself, instead of one region
   * (UseLabel and IsoValue then say nothing). The outputs have the cell data "Label" of the type of
   * the scalars, for LabelArray of vtkOrthogonalSliceReconstruction. Where samples of two labels
   * are neighbours, both have the same contour vertices between them. Default off.
   */
  vtkSetMacro(EveryLabel, bool);
  vtkGetMacro(EveryLabel, bool);
  vtkBooleanMacro(EveryLabel, bool);
  ///@}

  ///@{
  /**
   * Images: the label that has no contours with EveryLabel. Default 0, as images of labels have it.
   */
  vtkSetMacro(BackgroundLabel, int);
  vtkGetMacro(BackgroundLabel, int);
  ///@}

  ///@{
  /**
   * Precision of the output points: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION, or
   * DEFAULT_PRECISION (default): that of the surface's points, double for images.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

protected:
  vtkOrthogonalSlicer();
  ~vtkOrthogonalSlicer() override = default;

  ///@{
  /// What the pipeline of VTK calls.
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  ///@}

private:
  vtkOrthogonalSlicer(const vtkOrthogonalSlicer&) = delete;
  void operator=(const vtkOrthogonalSlicer&) = delete;

  bool SliceSurface(vtkPolyData* input, vtkInformationVector* outputs);
  bool SliceSamples(
    vtkDataSet* input, vtkInformationVector** inputs, vtkInformationVector* outputs);
  bool ReadGrid(vtkDataSet* input, orthoslices::ImageFrame& frame, orthoslices::SampleGrid& grid);
  vtkDataArray* FindScalars(vtkDataSet* input, vtkInformationVector** inputs);
  bool PlacePlanes(int axis, double lo, double hi, std::vector<double>& planes);
  bool PlaceByNumber(int axis, double lo, double hi, std::vector<double>& planes);
  bool PlaceBySpacing(int axis, double lo, double hi, std::vector<double>& planes);
  bool PlaceByCoordinates(int axis, std::vector<double>& planes);

  int PlaneMode = BY_NUMBER;
  int NumberOfSlices[3] = { 32, 32, 32 };
  double Spacing[3] = { 1.0, 1.0, 1.0 };
  std::vector<double> Coordinates[3];
  double IsoValue = 0.0;
  bool UseLabel = false;
  int LabelValue = 1;
  bool EveryLabel = false;
  int BackgroundLabel = 0;
  int OutputPointsPrecision = DEFAULT_PRECISION;
};

#endif
