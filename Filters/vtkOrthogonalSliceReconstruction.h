// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOrthogonalSliceReconstruction
 * @brief   closed surface from up to three sets of planar contours, orthogonal to each other as a
 * rule
 *
 * Reconstructs a closed, oriented triangle surface from contours that were drawn (or cut) on three
 * families of parallel planes, each orthogonal to one coordinate axis, after R. Svitak and
 * V. Skala, "Robust Surface Reconstruction from Orthogonal Slices" (2004, arXiv:2301.01713).
 *
 * Where contours of two orthogonal slices cross, they belong to the same surface. These *node
 * points* and the contour parts (*arcs*) between them form a graph G on the edges and faces of the
 * spatial grid M that the planes span. In each cell of M, G leaves closed *cycles*, the spatial
 * polygons, and each of them is filled with a patch around a central point. No correspondence
 * between slices is guessed where orthogonal slices meet.
 *
 * Whatever passes from one cell to the next leaves a contour on the slice between them. All that
 * the slices leave open is therefore inside cells with several cycles: which of them are ends of
 * one tube, and which are ends of their own. There SeveralCycles decides, by the directions of the
 * surface at the node points and the positions of the cycles, or as ExpectedComponents and
 * ExpectedGenus require. Contours without node points (*isolated*: tips and thin parts between the
 * other planes) are joined to what they continue, and end in domes.
 *
 * Where slices are too few for that, with one stack, two families or a stack with a few slices
 * across, the surface of the same topology that bends least between the contours is cut on
 * *virtual* planes between the real ones, and the surface is made once more from all of them
 * (VirtualSlices). Through a few slices of several families, a smooth field may take the place of
 * that surface (FollowField).
 *
 * @section Inputs Inputs
 * Ports 0, 1 and 2: contours on planes of constant x, y and z. Port 3: contours on planes of any
 * families. In fact each port takes any contours: they are sorted by the planes that they lie on. A
 * port takes a vtkPolyData, or a vtkMultiBlockDataSet, vtkPartitionedDataSet or
 * vtkPartitionedDataSetCollection, of which all vtkPolyData count as one input. Ports without
 * contours are families without slices; with one family the filter joins parallel slices.
 *
 * Planes need not lie across the axes of the world (see Frame). If they do not, the normals of up
 * to three families are fitted to the contours by least squares. Which of them are the x-, y- and
 * z-slices, their nearest axes say, or, if a normal is more than 40 degrees from any, their ports.
 * If they are at right angles to each other, as far as noise lets one see, the surface is that of
 * slices across x, y and z, turned. Else coordinates along the axes are distances along the normals
 * of the families, the surface is made there, and mapped back by the inverse (see AxisFrame and
 * ReconstructSorted in Core). Contours on planes of no family are no slices. Where the surface
 * bends from slice to slice (VirtualSlices), it bends through them, too. A warning names them and
 * says whether they guide the surface, and how far it is from them.
 *
 * The planes may come in any order and spacing, with different numbers on each axis. Contours are
 * accepted as lines and polygons: closed polylines (first point repeated or not), polygons, open
 * pieces and loose two-point segments in any order and direction, and any mixture; vertices and
 * strips are ignored. Points may be float or double and may be duplicated. Pieces are joined where
 * their end points coincide; a single polyline of three or more points whose ends meet no other
 * piece is closed if the gap is at most twice its longest segment, and is open otherwise. What is
 * wrong with open contours and others, by default, is mended (InvalidContours).
 *
 * With ORIENT_BY_NESTING (the default) directions are ignored: the outermost contours of a slice
 * enclose the interior, the contours directly inside them enclose holes, and so on. With
 * ORIENT_AS_DRAWN they are trusted: seen from the positive end of the axis, the interior lies on
 * the left of the contour (outer boundaries run counter-clockwise).
 *
 * @section Threads Threads
 * Loops run on as many threads as vtkSMPTools would take, and where VTK was built to run loops in
 * one thread by default, on as many as there are processors that the process may run on.
 * vtkSMPTools::Initialize and the environment
 * (VTK_SMP_MAX_THREADS; VTK_SMP_BACKEND_IN_USE=Sequential) set a limit; within a parallel loop of
 * VTK there is one thread. Progress is that of the work, GetProgressText says what is being done;
 * AbortExecute is heard within stages and leaves empty outputs.
 *
 * @section Outputs Outputs
 * Port 0, the surface (vtkPolyData): triangles, oriented outwards. Where the slices agree, every
 * surface passes within its accuracy (field data "Accuracy") of every vertex of every contour that
 * meets another family (of the contours that Smoothing and ContourTolerance leave). With
 * KeepContourVertices, or without few triangles (AutomaticAccuracy off, Accuracy 0), every such
 * vertex is a vertex of the surface. Points: first the node points, then
 * the vertices of the arcs and of the isolated contours, then one for each spatial polygon (of fans
 * the central point, else one of those inside its patch), last the other points inside patches;
 * with few triangles, those of them that are left.
 *  - point data "Normals" (float, 3 components; active normals), if ComputeNormals or
 *    ComputeCurvatures is on: of smooth patches those of the smooth surface, of others the mean of
 *    the triangles around;
 *  - cell data "ComponentId" (int): connected component, numbered from 0;
 *  - cell data "GridCell" (unsigned short, 3 components): the cell of M along x, y, z, where cell
 *    i lies below plane i and above plane i - 1; with few triangles, that of the patch from which
 *    a triangle is, which may reach into its neighbours;
 *  - cell data "PolygonSize" (unsigned short): number of node points of the spatial polygon (65535
 *    stands for more), of all polygons together where a patch joins several; 0 for isolated
 *    contours;
 *  - field data "NumberOfComponents", "NumberOfContours", "NumberOfIsolatedContours",
 *    "NumberOfContoursLeftOut" (isolated ones that take no part in the surface),
 *    "NumberOfComponentsLeftOut" (see MinimumComponentSize), "NumberOfUndecidedPlaces",
 *    "TotalGenus" (of all components together), "NumberOfCellsWithSeveralCycles",
 *    "NumberOfNodePoints", "NumberOfReconciledEdges", "NumberOfReconciledVertices",
 *    "NumberOfRepairs" (vtkIdType, one value each); on the shape of the triangles "SmallestAngle"
 *    (degrees), "ShareOfTrianglesAbove20Degrees" (all of whose angles are larger),
 *    "LargestAspectRatio" (longest side by the height over it) (double, one value each); "Accuracy"
 *    (double): how far contours may be from the surface, in plane spacings, 0 if they keep their
 *    vertices; "NumberOfPointsEqualInFloat" (vtkIdType): points that would be the same as others
 *    once rounded to float, as files in STL format are: what is written then is no closed manifold
 *    there (OutputPointsPrecision set to single keeps points apart); only where
 *    the families do not lie across the axes of the world, "FamilyNormals" (double, 3 x 3), their
 *    unit normals. Points, normals and curvatures are those of the world in any frame; axes, planes
 *    and cells of M are those of the families, "PlaneCoordinate" a distance from the origin along
 *    the normal;
 *  - point data "MeanCurvature" and "GaussianCurvature" (float, see ComputeCurvatures; 1 / world
 *    units and its square, mean curvature positive where the surface is convex);
 *  - point data "Disagreement" (float): at a node point, the distance of the two contours along
 *    the grid edge in world units; 0 at other points;
 *  - cell data "Repaired" (unsigned char): sum of 1 (a node point of the polygon disagrees by
 *    more than ReportTolerance), 2 (an arc was changed so that it crosses no other) and 4 (the
 *    patch was separated from another).
 * Where there are virtual slices, their planes are planes of M like the real ones: "GridCell" and
 * "SlicePlane" (ports 1, 3 and 4) number all of them in ascending order, and the numbers of node
 * points, isolated contours and cells with several cycles count what is on them. All other numbers
 * and tables are of the real slices alone, undecided places and histogram before virtual ones were
 * added.
 *
 * Port 1, the graph G with all vertices of contours, also with few triangles, and the repairs
 * (vtkPolyData): one vertex cell for each node point, one for each repair, then one polyline for
 * each arc, then one closed polyline for each isolated contour (a contour without node points).
 * Cell data:
 *  - "Kind" (unsigned char): 0 node point, 1 arc, 2 isolated contour; repairs: 3 a slice was
 *    overruled on whether a vertex of M is inside, 4 two crossings that the other slice does not
 *    have were taken out, 8 arcs that crossed on a face of M were taken apart (they pass their
 *    vertices in another order), 5 arcs that touched otherwise were drawn anew, 6 the same and
 *    their ends were joined in another way, 7 patches that crossed within a cell were separated,
 *    9 a contour that the slice lacks was interpolated (see InsertMissingContours);
 *  - "Disagreement" (double): at a node point, the distance of the two contours along the grid
 *    edge in world units; 0 elsewhere;
 *  - "SliceAxis" (int): 0, 1, 2 for arcs and repairs on x-, y-, z-slices, else -1;
 *  - "SlicePlane" (int): index of the plane on that axis in ascending order, else -1;
 *  - "Length" (double): length of the arc or isolated contour in world units, else 0;
 *  - "ComponentId" (int): as on port 0; -1 for repairs, and for isolated contours that take no
 *    part in the surface: they touch others, are too small or too thin, or are parts of contours
 *    that the other slices contradict;
 *  - "RepairSize" (float): in world units, how far the slice's nearest crossing was from the
 *    vertex (kind 3), distance of the crossings (4), length of the new arcs (5, 6), of the border
 *    of the patch (7), by how much the arcs became shorter (8);
 *  - "SliceRmsDisagreement" (float; active scalars): of arcs and isolated contours,
 *    "RmsDisagreement" of their slice on port 4; of node points their "Disagreement"; of repairs 0;
 *  - "ContourRmsDisagreement" (float): the same of their contour on port 3, of several cells that
 *    make one contour on the arcs of the one that it is listed under;
 *  - "Virtual" (unsigned char), only where there are virtual slices: 1 for their arcs and isolated
 *    contours, and for node points on them. Nothing that they contradict is reported.
 *
 * Port 2, the histogram of polygon sizes (vtkTable; the paper's Figure 8): columns "PolygonSize"
 * and "Count" (vtkIdType), one row for every size from the smallest to the largest that occurs.
 *
 * Port 3, the contours (vtkTable), one row each: "Port", "SlicePlane" (int), "Cell" (vtkIdType; of
 * a contour made of several cells, one of them), "PlaneCoordinate" (double), and how it agrees with
 * the orthogonal contours: "NodePoints" (vtkIdType), "RmsDisagreement", "MaxDisagreement" (double,
 * world units). Only where contours come through other ports than those of their axes, "SliceAxis"
 * (int), and only where inputs are composite, "Block" (vtkIdType), the flat index of the block.
 * Contours on planes of no family come last, with "SlicePlane" -1 and the distances of their points
 * from the surface as disagreement.
 *
 * Port 4, the slices (vtkTable), one row for each plane: "SliceAxis", "SlicePlane" (int),
 * "PlaneCoordinate", "NodePoints", "RmsDisagreement", "MaxDisagreement" as above; of the repairs
 * "OverruledVertices" (kind 3) and "SnippedCrossings" (two for each of kind 4) (vtkIdType); and
 * "ShiftX", "ShiftY", "ShiftZ" (double): the translation within its plane that would bring the
 * slice closest to the others. A slice that was moved as a whole shows here. "SliceName" (string)
 * is axis and coordinate in words, "y = 0.25". Only where there are virtual slices, "Virtual"
 * (unsigned char) is 1 for them; these agree with nothing.
 *
 * Port 5, the undecided places (vtkTable), one row each: "X", "Y", "Z" (double): where; "Kind"
 * (int): 0 two cycles that are the ends of a tube or ends of their own, 1 an isolated contour and
 * the patch that it may continue, 2 two isolated contours; "Choice" (int): 0 separate, 1 joined, 2
 * separate because no joined patch without crossings was found; "Evidence" (double): for joining
 * them, the logarithm of the odds: 0 says nothing, and from 3 or -3 on (95 %) a place is not
 * listed; and where to slice next: "PlaneAxis" (int), "PlaneCoordinate" (double), the slice that
 * would settle the place, "PlaneSettles" (vtkIdType), how many places it would settle, and
 * "PlaneRank" (int), 0 for the slice that settles most: a place counts the more, the less certain
 * it is (see UncertaintyOf() in Core/Cells/UndecidedPlaces.h). "KindName", "ChoiceName" and
 * "PlaneName" (string) say kind, choice and slice in words. The rows ascend by that rank.
 *
 * Port 6, the input problems (vtkTable), one row for each contour that was mended, left out or
 * crosses another: "Port" (int), "Cell" (vtkIdType; of a contour made of several cells, one of
 * them), "SliceAxis" (int), "Kind" (int) and "KindName" (string): 0 NotFinite, 1 OffPlane, 2 Open,
 * 3 CrossesItself, 4 CrossesOther, 5 TooShort (one or two points that join nothing), 6 Flat (no
 * area), 7 MovedOntoPlane, 8 GapClosed, 9 OverrunTrimmed (it ran past its start), 10
 * ClosedAlongBorder (of the image), 11 LeftOpen (there), 12 LoopsUnited (they overlap), 13
 * BridgeRemoved (between outline and hole, drawn there and back), 14 LoopSplit (it touches or
 * crosses itself), 15 DrawnTwice; "LeftOut" (unsigned char): 1 if the contour takes no part in the
 * surface; "X", "Y", "Z" (double): where; "Size" (double, world units): distance from the plane,
 * length of the gap, of what was trimmed, added or left out, distance of the two contours, or 0.
 *
 * Port 7, the components (vtkTable), one row for each: "ComponentId" (int), as on port 0; "Area",
 * "Volume" (double, world units), exact for the triangles: the volume is positive for an outer
 * surface and negative for that of a cavity, which is a component of its own, so that volumes add
 * up to that of the body; "CentroidX", "CentroidY", "CentroidZ" (double): of the solid that the
 * component encloses; "Triangles" (vtkIdType); "SeedX", "SeedY", "SeedZ" (double): a point in the
 * region that the component encloses, right beside it, for mesh generators: of a body one in its
 * material, of a cavity one in the hole. A component that is open has the volume NaN, the
 * centroid of its surface, and perhaps no seed (NaN). With labels, other labels within one are
 * passed over.
 *
 * @section Labels Labels
 * With LabelArray, each label is reconstructed from its contours, with common axes of the slices,
 * and the outputs of all labels are appended in ascending order of labels. Every surface is closed
 * by itself: no points are shared between labels. Labels that stay clear of each other have the
 * surfaces of runs of their own. Where contours of labels run along each other, to within a
 * hundredth of the spacing, the surfaces have the same triangles, and where they do not cross, no
 * triangle of one pierces one of another; Filters/Core/README.md says what is left. Labels whose contours
 * overlap keep them, and a warning names those that overlap most. Ports 0 and 1 have the cell data
 * "Label" (on port 0, active scalars), of the type of the input's array; names stand as their
 * number (int) in the field data "LabelNames" (vtkStringArray) of port 0. The tables of ports 2 to
 * 7 have a first column "Label", the number or the name. "ComponentId" runs on from label to label,
 * field data that count are of all labels together, "SlicePlane" and "GridCell" count the planes of
 * the label, with those of its neighbours next to it. Port 0 also has the field data "LabelNames"
 * (of numbers their text), "LabelArea" and "LabelVolume" (double), one value for each label.
 * Fractions of a diagonal are those of the box around the contours of a label.
 *
 * 0 is a label like any other (vtkOrthogonalSlicer takes it for the background of an image of
 * labels, and makes no contours of it). Contours without a label (of an input that lacks the array,
 * NaN, an empty name) take no part, and a warning counts them. A label whose contours are refused
 * leaves the others as they are; a warning names it. Only if all are refused, this is an error.
 *
 * @section Processes Several processes
 * In a parallel run each process has its contours, and gets its piece of the surface: the surface
 * of one process that has the contours of all, divided. Pieces have the point data "GlobalPointIds"
 * and the cell data "GlobalCellIds" (vtkIdType): ids in that surface. A point of several pieces is
 * marked in "vtkGhostType" on all but the first of them (DUPLICATEPOINT), as vtkGenerateGlobalIds
 * does it. There are no ghost cells; vtkGhostCellsGenerator makes them from the global ids. Field
 * data are those of the whole surface, on all; the other outputs are whole, on the first process
 * alone. If the filter fails or is aborted on one process, it ends with an error on all others;
 * what fails before it on one process alone is not heard of, and the others wait. With labels,
 * virtual slices, curvatures, BorderContours = LEAVE_OPEN_AT_BORDER or contours on planes of no
 * family each process makes the whole and keeps its part: the same result, without gain in time.
 * With AutomaticAccuracy or Accuracy, each has the memory for all triangles.
 *
 * @section Guarantees Guarantees
 * G1 to G7 in Core/Reconstruct.h: closed (but for BorderContours = LEAVE_OPEN_AT_BORDER),
 * 2-manifold, consistently oriented outwards, contour vertices kept, the same bytes for any number
 * of threads and on every execution, no two triangles that cross, nothing outside the box of the
 * contours by more than half a spacing. If slices do not lie across the axes of the world, the box
 * is one along the axes of the families, and vertices are kept but for rounding.
 *
 * @section Errors Errors
 * No contours on any port, contours of which none can be used, and given axes that are none are
 * errors, with empty outputs. Contours that are open, leave their plane by more than the tolerance,
 * have no area, or coordinates that are not finite are mended or else left out (InvalidContours =
 * MEND, the default): one warning counts them by kinds, with port, cell and coordinate of the first
 * of each kind, and port 6 lists them all. With REFUSE they are errors, with LEAVE_OUT all of them
 * are left out. So are contours that cross themselves or each other within one slice
 * (CrossingContours); by default one warning counts them, and LoopRule says what they bound. Where
 * the families contradict each other by more than ReportTolerance, one warning says so, and the
 * "Disagreement" array shows where. It also tells of inputs that are points alone or look like the
 * surface of a model, of contours that take no part in the surface, of a surface that is inside
 * out, of ExpectedComponents and ExpectedGenus that cannot be met, and of undecided places where
 * the odds are near even and that matter: both parts are at least as wide as the planes are apart,
 * or remain in different components. All other undecided places are in the table only.
 *
 * @sa vtkOrthogonalSlicer vtkRuledSurfaceFilter vtkCutter
 */

#ifndef vtkOrthogonalSliceReconstruction_h
#define vtkOrthogonalSliceReconstruction_h

#include "vtkFiltersOrthogonalSlicesModule.h" // for export macro
#include "vtkNew.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;
class vtkTable;

namespace orthoslices
{
struct ContourLabels;
struct FrameOptions;
struct LabelSurfaces;
struct Options;
struct Polylines;
class ProcessGroup;
struct Reconstruction;
struct SortedSlices;
}

class VTKFILTERSORTHOGONALSLICES_EXPORT vtkOrthogonalSliceReconstruction
  : public vtkPolyDataAlgorithm
{
public:
  ///@{
  /// As in every class of VTK.
  static vtkOrthogonalSliceReconstruction* New();
  vtkTypeMacro(vtkOrthogonalSliceReconstruction, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /// Values of SetOrientation().
  enum OrientationMode
  {
    ORIENT_BY_NESTING = 0,
    ORIENT_AS_DRAWN = 1
  };

  /// Values of SetInvalidContours().
  enum InvalidContoursMode
  {
    REFUSE = 0,
    LEAVE_OUT = 1,
    MEND = 2
  };

  /// Values of SetBorderContours().
  enum BorderContoursMode
  {
    CLOSE_ALONG_BORDER = 0,
    LEAVE_OPEN_AT_BORDER = 1,
    REFUSE_AT_BORDER = 2
  };

  /// Values of SetCrossingContours().
  enum CrossingContoursMode
  {
    REPAIR_CROSSING = 0,
    REFUSE_CROSSING = 1,
    LEAVE_OUT_CROSSING = 2
  };

  /// Values of SetLoopRule().
  enum LoopRuleMode
  {
    UNION = 0,
    EVEN_ODD = 1,
    NON_ZERO = 2
  };

  /// Values of SetFrame().
  enum FrameMode
  {
    AUTOMATIC_FRAME = 0,
    WORLD_FRAME = 1,
    GIVEN_FRAME = 2
  };

  /// Values of SetSeveralCycles().
  enum SeveralCyclesMode
  {
    BY_EVIDENCE = 0,
    DISCS = 1
  };

  /// Values of SetVirtualSlices().
  enum VirtualSlicesMode
  {
    AUTOMATIC_VIRTUAL_SLICES = 0,
    NO_VIRTUAL_SLICES = 1,
    VIRTUAL_SLICES_BY_SPACING = 2
  };

  /// Values of SetEndCaps().
  enum EndCapsMode
  {
    DOME_ENDS = 0,
    FLAT_ENDS = 1,
    HALF_SLICE_ENDS = 2
  };

  /// Values of SetCorrespondence().
  enum CorrespondenceMode
  {
    CORRESPOND_BY_EVIDENCE = 0,
    CORRESPOND_BY_OVERLAP = 1,
    CORRESPOND_BY_ELLIPTICAL_CYLINDERS = 2,
    CORRESPOND_BY_SPANNING_TREE = 3,
    CORRESPOND_BY_REEB_GRAPH = 4
  };

  /// Values of SetPatchType().
  enum PatchTypeMode
  {
    SMOOTH = 0,
    FAN = 1,
    COONS = 2
  };

  /// Values of SetCentralPoint().
  enum CentralPointMode
  {
    LEAST_SQUARES = 0,
    CENTROID = 1
  };

  ///@{
  /**
   * Largest distance of a contour's vertices from its plane, of two planes that are taken for
   * one, and of two end points that are joined, as a fraction of the diagonal of the bounding box
   * of all inputs. Default 1e-5, range 0 to 0.1. NaN is an error.
   */
  vtkSetClampMacro(PlaneTolerance, double, 0.0, 0.1);
  vtkGetMacro(PlaneTolerance, double);
  ///@}

  ///@{
  /**
   * Name of the cell array of the inputs that says which structure a contour belongs to: numbers,
   * or names (vtkStringArray). One run then makes one closed surface for each label, from its
   * contours alone, with these properties, and appends all outputs (see Labels). Empty (default) or
   * "None": all contours belong to one structure. A name that no input has is an error.
   */
  vtkSetStdStringFromCharMacro(LabelArray);
  vtkGetCharFromStdStringMacro(LabelArray);
  ///@}

  /**
   * The names that LabelArray may have: those of the cell arrays of all inputs, sorted. Inputs that
   * were not updated yet have none.
   */
  vtkStringArray* GetCellArrayNames();

  ///@{
  /**
   * How the interior of a contour is found: by nesting (default) or from its direction as drawn,
   * on the left seen from the positive end of its axis. As drawn, contours that run clockwise on
   * the whole bound the outside: the surface is inside out, and a warning says so.
   */
  vtkSetClampMacro(Orientation, int, ORIENT_BY_NESTING, ORIENT_AS_DRAWN);
  vtkGetMacro(Orientation, int);
  void SetOrientationToNesting() { this->SetOrientation(ORIENT_BY_NESTING); }
  void SetOrientationToAsDrawn() { this->SetOrientation(ORIENT_AS_DRAWN); }
  ///@}

  ///@{
  /**
   * What happens to contours that are open, off their plane, without area or not finite. MEND
   * (default): they are mended with a warning, and listed on port 6. Vertices that are off their
   * plane by at most a tenth of the least distance between the slices of their port are put on it;
   * gaps of at most a fifth of the length of the contours are closed, by straight lines; what runs
   * past its own start, or past that of the next piece, is trimmed, and at most a quarter of it;
   * contours that end at the border of the image are closed along it (see BorderContours). Pieces
   * of one or two points, loops without area and what cannot be mended are left out. REFUSE: an
   * error, and no surface. LEAVE_OUT: they are left out with a warning.
   */
  vtkSetClampMacro(InvalidContours, int, REFUSE, MEND);
  vtkGetMacro(InvalidContours, int);
  void SetInvalidContoursToRefuse() { this->SetInvalidContours(REFUSE); }
  void SetInvalidContoursToLeaveOut() { this->SetInvalidContours(LEAVE_OUT); }
  void SetInvalidContoursToMend() { this->SetInvalidContours(MEND); }
  ///@}

  ///@{
  /**
   * What happens, with InvalidContours = MEND, to contours that end at the border of the image.
   * They are closed along it (default), or the surface is left open there, or the input is refused
   * with an error. The border is a rectangle in the planes of each port. A side of it is where the
   * contours reach farthest along an axis and two or more loose ends lie. Where contours could be
   * closed on either side, they keep to the sides at which ends lie, and to the shorter way.
   *
   * Left open, the contours are continued at right angles across the border, for the mean distance
   * of the slices, and the surface of these is cut off at it. It ends there with a boundary that
   * lies on the border, and is closed elsewhere. The graph shows the contours as continued, and
   * numbers of components and handles are those before the cut.
   */
  vtkSetClampMacro(BorderContours, int, CLOSE_ALONG_BORDER, REFUSE_AT_BORDER);
  vtkGetMacro(BorderContours, int);
  void SetBorderContoursToCloseAlongBorder() { this->SetBorderContours(CLOSE_ALONG_BORDER); }
  void SetBorderContoursToLeaveOpen() { this->SetBorderContours(LEAVE_OPEN_AT_BORDER); }
  void SetBorderContoursToRefuse() { this->SetBorderContours(REFUSE_AT_BORDER); }
  ///@}

  ///@{
  /**
   * The border of the image, where it is known (see BorderContours): least and greatest x, y and z,
   * as vtkDataSet::GetBounds has them. A single loose end at a side is enough then, and contours
   * that reach farther elsewhere do not matter. An axis whose least value is not below its greatest
   * is not given: its sides are found from the contours. So are infinite sides not there. Default:
   * 0, -1 for all axes, nothing given. World units. Where the planes are turned, the values are
   * those along the axes of the families: distances along their normals (field data FamilyNormals).
   *
   * Contours end on the border exactly. With slices of three families, or two, that are no fewer
   * than two across each axis at whose sides contours end, the surface ends flat there, with an
   * edge, two thousandths of a spacing beyond at most: each side counts as a slice, a virtual one
   * (array Virtual of the graph, and column of the tables). Else, and with labels or Smoothing,
   * the edge is rounded between two slices, and the surface ends two hundredths of a spacing
   * beyond at most.
   */
  vtkSetVector6Macro(BorderBounds, double);
  vtkGetVector6Macro(BorderBounds, double);
  ///@}

  ///@{
  /**
   * What happens to contours that cross or overlap themselves or another contour of their slice:
   * LoopRule says what they bound, with a warning (default), the input is refused with an error if
   * any cross, or these are left out with a warning.
   */
  vtkSetClampMacro(CrossingContours, int, REPAIR_CROSSING, LEAVE_OUT_CROSSING);
  vtkGetMacro(CrossingContours, int);
  void SetCrossingContoursToRepair() { this->SetCrossingContours(REPAIR_CROSSING); }
  void SetCrossingContoursToRefuse() { this->SetCrossingContours(REFUSE_CROSSING); }
  void SetCrossingContoursToLeaveOut() { this->SetCrossingContours(LEAVE_OUT_CROSSING); }
  ///@}

  ///@{
  /**
   * What contours of one slice bound together that cross or overlap each other or themselves, with
   * CrossingContours = REPAIR_CROSSING.
   *
   * UNION (default): loops that overlap count as their union, loops within others as holes, and so
   * on inwards, whatever their directions. All lobes of a loop that crosses itself are inside. An
   * outline and a hole that are joined by a bridge drawn there and back are two loops.
   *
   * EVEN_ODD: what an odd number of loops runs around is inside. NON_ZERO: what they run around
   * more often in one direction than in the other one.
   *
   * With Orientation = ORIENT_AS_DRAWN, UNION and NON_ZERO both take for inside what contours run
   * around more often counter-clockwise than clockwise. Where no contours meet, UNION and EVEN_ODD
   * are the same.
   */
  vtkSetClampMacro(LoopRule, int, UNION, NON_ZERO);
  vtkGetMacro(LoopRule, int);
  void SetLoopRuleToUnion() { this->SetLoopRule(UNION); }
  void SetLoopRuleToEvenOdd() { this->SetLoopRule(EVEN_ODD); }
  void SetLoopRuleToNonZero() { this->SetLoopRule(NON_ZERO); }
  ///@}

  ///@{
  /**
   * The axes across which the planes of the contours lie. Automatic (default): those of the world
   * if all contours lie on planes across them, as far as noise lets one see; else they are found
   * from the contours, whose planes may be turned any way, and need not be at right angles to each
   * other (see Inputs). World: those of the world, whatever the contours look like; those of ports
   * 0, 1 and 2 belong to x, y and z unless they lie on a plane across another axis. Given:
   * FrameNormals.
   */
  vtkSetClampMacro(Frame, int, AUTOMATIC_FRAME, GIVEN_FRAME);
  vtkGetMacro(Frame, int);
  void SetFrameToAutomatic() { this->SetFrame(AUTOMATIC_FRAME); }
  void SetFrameToWorld() { this->SetFrame(WORLD_FRAME); }
  void SetFrameToGiven() { this->SetFrame(GIVEN_FRAME); }
  ///@}

  ///@{
  /**
   * A contour that was drawn a second time counts once, with a warning: if it is closer than this
   * to the first one everywhere, as a share of its thickness (twice the area by the length: the
   * radius of a circle, the width of a strip). A thin wall looks the same; it stays where slices
   * across show both of its sides, or, without slices across, where its sides run in opposite
   * directions on neighbouring slices. With 0, only exact copies are left out. Default 0.05, range
   * 0 to 0.5.
   */
  vtkSetClampMacro(RedrawnTolerance, double, 0.0, 0.5);
  vtkGetMacro(RedrawnTolerance, double);
  ///@}

  ///@{
  /**
   * With Frame Given, the normals of the planes of the x-, y- and z-slices, one after another, of
   * any length; of slices of an image, the columns of its direction matrix. If they are
   * left-handed, the third one is reversed. Three that are nearly in one plane are an error.
   * Default: the axes of the world.
   */
  vtkSetVectorMacro(FrameNormals, double, 9);
  vtkGetVectorMacro(FrameNormals, double, 9);
  ///@}

  ///@{
  /**
   * Whether a contour is interpolated on a slice that lacks it: where those of the slices before
   * and after it overlap, do not shrink towards it and have no other one to continue, while other
   * contours are drawn on the slice; with LabelArray also for a label that the slice lacks, up to
   * the borders that other labels have there, if it is left empty. A warning says how many there
   * are, and on which slices. Default: on.
   */
  vtkSetMacro(InsertMissingContours, bool);
  vtkGetMacro(InsertMissingContours, bool);
  vtkBooleanMacro(InsertMissingContours, bool);
  ///@}

  ///@{
  /**
   * What carries the shape across cells that are large against it: where a family of slices is
   * missing, and between slices that are far apart. First the surface is made from the slices as
   * they are; then the surface of the same topology that bends least between their contours is cut
   * on additional, virtual planes, and the surface is made once more from real and virtual slices.
   * Real slices outrank virtual ones everywhere: contours that meet no other real ones keep their
   * vertices. The report is of real slices, and an array "Virtual" tells them from virtual ones in
   * the graph and in the table of slices. Of a stack with a few slices across, the surface of the
   * stack alone is bent, through the contours of the slices across, and its topology counts. Should
   * the topology come out otherwise, that of all slices is bent, and at last the first surface
   * stays, and there are no virtual slices in the outputs. None are added to a surface that is
   * inside out.
   *
   * Automatic (default): on the axes of missing families, and where a family has three times the
   * planes of another and 8 or more (5, if there are no others), between planes of the other one
   * that are farther apart than 0.117 of the extent. Virtual planes are as far apart as the slices
   * of the densest family, at most a twelfth and at least a 64th of the extent along their axis.
   * Three families with about as many slices each get none. Off: none. By spacing: as far apart as
   * VirtualSliceSpacing says, in world units, wherever slices are farther apart than 1.4 times
   * that. Valid range of the spacing: 0 (as with Automatic) or more, but for more than 1024 planes
   * on an axis; default 0.
   */
  vtkSetClampMacro(VirtualSlices, int, AUTOMATIC_VIRTUAL_SLICES, VIRTUAL_SLICES_BY_SPACING);
  vtkGetMacro(VirtualSlices, int);
  void SetVirtualSlicesToAutomatic() { this->SetVirtualSlices(AUTOMATIC_VIRTUAL_SLICES); }
  void SetVirtualSlicesToOff() { this->SetVirtualSlices(NO_VIRTUAL_SLICES); }
  void SetVirtualSlicesToBySpacing() { this->SetVirtualSlices(VIRTUAL_SLICES_BY_SPACING); }
  vtkSetClampMacro(VirtualSliceSpacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(VirtualSliceSpacing, double);
  ///@}

  ///@{
  /**
   * With several families of fewer than a dozen slices each, or a stack of 8 to 16 with a few
   * across: whether virtual slices are those of a smooth function that is zero on all contours
   * (radial basis functions with derivatives), if it foretells slices that are left out about as
   * well as what there is without it. Of round things with few slices that is mostly much closer.
   * It may join what the slices leave open, but what ExpectedComponents and ExpectedGenus have
   * decided stays so; it depends on rounding, so that the same contours along other axes give a
   * surface that differs a little. Takes a second or two. Nothing with VirtualSlices off. Default:
   * on.
   */
  vtkSetMacro(FollowField, bool);
  vtkGetMacro(FollowField, bool);
  vtkBooleanMacro(FollowField, bool);
  ///@}

  ///@{
  /**
   * How the object ends where there is one family of slices. Dome (default): in domes, half a
   * spacing high at most, or flat at the last slice where the last section is at least 0.98 of the
   * one before. Flat: flat at the last slice of each part, also where a part ends between two
   * slices; what is on one slice alone keeps its domes. Half slice: walls go on from the first and
   * the last slice at right angles, by half the distance of the two slices there (half the mean
   * distance at most), and end flat, so that each of equally spaced slices stands for one spacing:
   * the volume of a cylinder of n slices is n times area times spacing, as in treatment planning. A
   * single slice becomes a plate, half as thick as the greater extent of its contours. Parts that
   * end between two slices end in the middle between them in the same way, unless VirtualSlices is
   * off: then, in domes. The rims are copies of the last contours on virtual planes, which the
   * outputs say (see VirtualSlices).
   * With two families and more, slices across show the ends, and nothing changes.
   */
  vtkSetClampMacro(EndCaps, int, DOME_ENDS, HALF_SLICE_ENDS);
  vtkGetMacro(EndCaps, int);
  void SetEndCapsToDome() { this->SetEndCaps(DOME_ENDS); }
  void SetEndCapsToFlat() { this->SetEndCaps(FLAT_ENDS); }
  void SetEndCapsToHalfSlice() { this->SetEndCaps(HALF_SLICE_ENDS); }
  ///@}

  ///@{
  /**
   * How cells with several cycles are filled: by discs, tubes and branchings, as the evidence says
   * (default), or by a disc for every cycle, as in the paper. Patches do not cross in either case.
   */
  vtkSetClampMacro(SeveralCycles, int, BY_EVIDENCE, DISCS);
  vtkGetMacro(SeveralCycles, int);
  void SetSeveralCyclesToByEvidence() { this->SetSeveralCycles(BY_EVIDENCE); }
  void SetSeveralCyclesToDiscs() { this->SetSeveralCycles(DISCS); }
  ///@}

  ///@{
  /**
   * Which isolated contours of neighbouring slices belong together; with one family of slices these
   * are all contours. By evidence (default): those that overlap, and others whose positions speak
   * for it. Or by one of the criteria that the paper compares with
   * (Core/Correspondence/FindCorrespondences.h): overlap; generalized elliptical cylinders (Soroka
   * 1981; Bresler, Fessler and Macovski 1989); minimum spanning tree (Skinner); Reeb graph
   * (Shinagawa and Kunii 1991), which uses ExpectedComponents and ExpectedGenus. Has no effect with
   * DISCS.
   */
  vtkSetClampMacro(Correspondence, int, CORRESPOND_BY_EVIDENCE, CORRESPOND_BY_REEB_GRAPH);
  vtkGetMacro(Correspondence, int);
  void SetCorrespondenceToEvidence() { this->SetCorrespondence(CORRESPOND_BY_EVIDENCE); }
  void SetCorrespondenceToOverlap() { this->SetCorrespondence(CORRESPOND_BY_OVERLAP); }
  void SetCorrespondenceToEllipticalCylinders()
  {
    this->SetCorrespondence(CORRESPOND_BY_ELLIPTICAL_CYLINDERS);
  }
  void SetCorrespondenceToSpanningTree() { this->SetCorrespondence(CORRESPOND_BY_SPANNING_TREE); }
  void SetCorrespondenceToReebGraph() { this->SetCorrespondence(CORRESPOND_BY_REEB_GRAPH); }
  ///@}

  ///@{
  /**
   * What is known of the surface: its number of components (default 0: unknown) and the genus of
   * all components together (default -1: unknown). Of the undecided places as many are joined, in
   * the order of their evidence, as meet these numbers; a warning says so if there are not enough.
   * Has no effect with DISCS.
   */
  vtkSetClampMacro(ExpectedComponents, int, 0, VTK_INT_MAX);
  vtkGetMacro(ExpectedComponents, int);
  vtkSetClampMacro(ExpectedGenus, int, -1, VTK_INT_MAX);
  vtkGetMacro(ExpectedGenus, int);
  ///@}

  ///@{
  /**
   * Components of the surface, and isolated contours, whose bounding box has a smaller diagonal are
   * left out; as a fraction of the diagonal of the bounding box of all inputs. Default 0 (nothing
   * is left out), range 0 to 1.
   */
  vtkSetClampMacro(MinimumComponentSize, double, 0.0, 1.0);
  vtkGetMacro(MinimumComponentSize, double);
  vtkSetClampMacro(MinimumIsolatedContourSize, double, 0.0, 1.0);
  vtkGetMacro(MinimumIsolatedContourSize, double);
  ///@}

  ///@{
  /**
   * How spatial polygons are filled. Smooth (default): each patch passes through the contours
   * around it and has their tangent planes, so that the whole surface is smooth. Fan: the paper's
   * quadrilaterals, each a fan around the central point. Coons: the paper's quadrilaterals,
   * bilinearly blended. Patches that join several polygons are built from plain triangles in all
   * cases.
   */
  vtkSetClampMacro(PatchType, int, SMOOTH, COONS);
  vtkGetMacro(PatchType, int);
  void SetPatchTypeToSmooth() { this->SetPatchType(SMOOTH); }
  void SetPatchTypeToFan() { this->SetPatchType(FAN); }
  void SetPatchTypeToCoons() { this->SetPatchType(COONS); }
  ///@}

  ///@{
  /**
   * Length of the sides of triangles inside smooth patches, in plane spacings (the least mean
   * spacing of the three axes). Coons patches get 0.5 / EdgeLength parts on each side. Default
   * 0.25, range 0.02 to 10. Contours keep their vertices: beside them, sides are about as long as
   * theirs.
   */
  vtkSetClampMacro(EdgeLength, double, 0.02, 10.0);
  vtkGetMacro(EdgeLength, double);
  ///@}

  ///@{
  /**
   * Distance of triangles from the smooth surface that is aimed at, in plane spacings: where the
   * normals of the border of a patch say that it is more curved, its triangles are smaller; they
   * are no larger than EdgeLength. Default 0: all are as large as EdgeLength. Range 0 to 1.
   */
  vtkSetClampMacro(ChordTolerance, double, 0.0, 1.0);
  vtkGetMacro(ChordTolerance, double);
  ///@}

  ///@{
  /**
   * With few triangles of good shape: how far contours may be from the surface, in plane spacings
   * (the least mean spacing of the two axes in each slice). At 0.05, three families of slices get
   * about a seventh of the triangles at nearly the same accuracy. Contours do not keep their
   * vertices then, but the surface passes within this distance of them; where slices contradict
   * each other, within twice what they disagree on (RMS), if that is more. The field data
   * "Accuracy" say what was used. Triangles are as large as that allows; EdgeLength bounds them,
   * in quarters of the mean radius of a patch, and ChordTolerance says nothing. For smooth
   * patches; on common borders of labels, triangles of both stay the same. Default 0: see
   * AutomaticAccuracy. Range 0 to 1.
   */
  vtkSetClampMacro(Accuracy, double, 0.0, 1.0);
  vtkGetMacro(Accuracy, double);
  ///@}

  ///@{
  /**
   * Whether the accuracy follows from the surface's own error, as the fit of smooth patches to
   * contours and what slices disagree on tell it: as few triangles as add about a twentieth to that
   * error. Where Accuracy or ChordTolerance are not 0, these say it. On by default; off,
   * and with Accuracy 0, all contours keep their vertices and the surface has all triangles.
   */
  vtkSetMacro(AutomaticAccuracy, bool);
  vtkGetMacro(AutomaticAccuracy, bool);
  vtkBooleanMacro(AutomaticAccuracy, bool);
  ///@}

  ///@{
  /**
   * Whether contours keep all of their vertices also with few triangles (Accuracy,
   * AutomaticAccuracy): then triangles inside patches are few, and those along contours as many as
   * these have vertices. Off by default: the surface passes within the accuracy of every contour.
   * Without Accuracy and AutomaticAccuracy all contours keep their vertices in any case.
   */
  vtkSetMacro(KeepContourVertices, bool);
  vtkGetMacro(KeepContourVertices, bool);
  vtkBooleanMacro(KeepContourVertices, bool);
  ///@}

  ///@{
  /**
   * Angle in degrees by which a contour turns at a corner. Smooth patches keep corners as creases
   * of the surface, where that fits the contours better than a smooth surface, and Smoothing keeps
   * them. Where virtual slices are made, edges of the object run straight from corner to corner of
   * neighbouring slices. Corners that noise may have made are none. Default 60, range 0 to 180 (no
   * corners).
   */
  vtkSetClampMacro(CornerAngle, double, 0.0, 180.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /**
   * Length of contour over which noise is smoothed out, in plane spacings. Default 0: the surface
   * passes through the contours as they are. Range 0 to 10; about as long as the noise is coarse,
   * and for the steps of outlines of pixels four to six pixels.
   */
  vtkSetClampMacro(Smoothing, double, 0.0, 10.0);
  vtkGetMacro(Smoothing, double);
  ///@}

  ///@{
  /**
   * Contour vertices within this distance of the line through the others are left out, in plane
   * spacings: for contours with far more vertices than needed. Normals come from what is left, so
   * that a hundredth is a large value. Contours that meet no other family keep theirs. Default 0:
   * all are kept. Range 0 to 1.
   */
  vtkSetClampMacro(ContourTolerance, double, 0.0, 1.0);
  vtkGetMacro(ContourTolerance, double);
  ///@}

  ///@{
  /**
   * Central point of a spatial polygon, for fans and Coons patches: from a least-squares quadratic
   * through the arcs and the surface normals at the node points (default), or the centroid of the
   * arcs.
   */
  vtkSetClampMacro(CentralPoint, int, LEAST_SQUARES, CENTROID);
  vtkGetMacro(CentralPoint, int);
  void SetCentralPointToLeastSquares() { this->SetCentralPoint(LEAST_SQUARES); }
  void SetCentralPointToCentroid() { this->SetCentralPoint(CENTROID); }
  ///@}

  ///@{
  /**
   * Trust in the x-, y- and z-slices where they contradict each other: a node point is the
   * weighted mean of its two contours, and the heavier side decides whether a grid vertex is
   * inside. Default 1, 1, 1; all zero counts as all one. Negative weights and weights that are not
   * finite are an error.
   */
  vtkSetVector3Macro(AxisWeights, double);
  vtkGetVector3Macro(AxisWeights, double);
  ///@}

  ///@{
  /**
   * Distance of two contours at a node point above which it is counted in the warning and marked
   * in the array "Repaired", and size ("RepairSize") above which a repair is reported, as a
   * fraction of the diagonal of the bounding box of all inputs. Default 1e-3, range 0 to 1. NaN is
   * an error.
   */
  vtkSetClampMacro(ReportTolerance, double, 0.0, 1.0);
  vtkGetMacro(ReportTolerance, double);
  ///@}

  ///@{
  /**
   * Whether a warning says so if only the x-slices (port 0) have contours, and all of them are of one
   * family: in a dialog that asks for three inputs, the others may have been forgotten. Default off;
   * on in ParaView's Orthogonal Slice Reconstruction.
   */
  vtkSetMacro(WarnOfMissingFamilies, bool);
  vtkGetMacro(WarnOfMissingFamilies, bool);
  vtkBooleanMacro(WarnOfMissingFamilies, bool);
  ///@}

  ///@{
  /**
   * Whether the surface gets point normals: those of the smooth surface, or of the triangles around
   * a point where there is no smooth surface. Default on.
   */
  vtkSetMacro(ComputeNormals, bool);
  vtkGetMacro(ComputeNormals, bool);
  vtkBooleanMacro(ComputeNormals, bool);
  ///@}

  ///@{
  /**
   * Whether the surface gets the point data "MeanCurvature" and "GaussianCurvature", and normals.
   * Default off.
   */
  vtkSetMacro(ComputeCurvatures, bool);
  vtkGetMacro(ComputeCurvatures, bool);
  vtkBooleanMacro(ComputeCurvatures, bool);
  ///@}

  ///@{
  /**
   * Whether the cell arrays of the contours are passed on to the graph and to the surface (see
   * Outputs). Default on.
   */
  vtkSetMacro(PassCellArrays, bool);
  vtkGetMacro(PassCellArrays, bool);
  vtkBooleanMacro(PassCellArrays, bool);
  ///@}

  ///@{
  /**
   * Precision of the output points: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION, or
   * DEFAULT_PRECISION (default): double if any input has double points, if the slices do not lie
   * across the axes of the world, or if they are closer than 4096 steps of float at their
   * coordinates, as far from the origin; single precision may make slivers of triangles touch in
   * the second case, and takes slices closer than 256 steps for one in the last.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * The processes that make the surface together; DEFAULT: the global controller. Each has to
   * update the filter, with its own piece of as many pieces as there are processes. Otherwise, or
   * with no controller, piece 0 is the whole surface of the contours of its process, and all other
   * pieces are empty.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  /**
   * Connects one family of slices: the same as SetInputConnection(family - 1, output), with the
   * x-slices as family 1, the y-slices as family 2, the z-slices as family 3, and slices of any
   * families as 4. ParaView's proxies
   * use it: its Python takes the active source for an input with port index 0 that a script leaves
   * out, and no family may be made up.
   */
  void SetFamilyConnection(int family, vtkAlgorithmOutput* output);

  /**
   * Connects slices of any families: the same as SetInputConnection(3, output). It is all the input
   * that one family of parallel slices needs, whatever the direction of their planes.
   */
  void SetContoursConnection(vtkAlgorithmOutput* output);

  ///@{
  /**
   * The graph G (port 1), the histogram of polygon sizes (port 2), and the tables of contours
   * (port 3), slices (port 4), undecided places (port 5), input problems (port 6) and components
   * (port 7).
   */
  vtkPolyData* GetGraphOutput();
  vtkTable* GetHistogramOutput();
  vtkTable* GetContourTable();
  vtkTable* GetSliceTable();
  vtkTable* GetUndecidedTable();
  vtkTable* GetProblemTable();
  vtkTable* GetComponentTable();
  ///@}

protected:
  vtkOrthogonalSliceReconstruction();
  ~vtkOrthogonalSliceReconstruction() override;

  ///@{
  /// What the pipeline of VTK calls.
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  ///@}

private:
  vtkOrthogonalSliceReconstruction(const vtkOrthogonalSliceReconstruction&) = delete;
  void operator=(const vtkOrthogonalSliceReconstruction&) = delete;

  // The steps of RequestData; checks that fail have reported an error.
  bool MakeWithOthers(vtkInformationVector* outputs);
  bool MakePieces(vtkInformationVector* outputs);
  bool MakeOutputs(vtkInformationVector* outputs);
  bool CanBeDivided(const orthoslices::SortedSlices& sorted) const;
  void Warn(const std::string& text);
  bool CheckProperties();
  bool CheckInputs(const std::vector<vtkDataObject*>& inputs);
  orthoslices::SortedSlices SortInputs(const std::vector<vtkDataObject*>& inputs) const;
  bool NeedsDoublePrecision(
    const std::vector<vtkDataObject*>& inputs, const orthoslices::SortedSlices& sorted);
  orthoslices::FrameOptions GetFrameOptions() const;
  void GetOptions(orthoslices::Options& options) const;
  orthoslices::ContourLabels ReadLabels(
    const std::vector<vtkDataObject*>& inputs, const orthoslices::SortedSlices& sorted);
  bool WriteResult(orthoslices::Reconstruction&& result, const orthoslices::Polylines& others,
    const orthoslices::Options& options, const std::function<vtkInformationVector*()>& outputs,
    std::string& text);
  bool ReconstructAll(orthoslices::SortedSlices&& sorted, const orthoslices::Options& options,
    vtkInformationVector* outputs);
  bool ReconstructLabels(orthoslices::SortedSlices&& sorted,
    const orthoslices::ContourLabels& labels, const orthoslices::Options& options,
    vtkInformationVector* outputs);
  bool WriteLabels(orthoslices::LabelSurfaces&& surfaces,
    const std::vector<orthoslices::Polylines>& others, const orthoslices::ContourLabels& labels,
    const orthoslices::Options& options, vtkInformationVector* outputs);
  bool UsesLabels() const { return !this->LabelArray.empty() && this->LabelArray != "None"; }
  std::string DescribeFailure(const orthoslices::Reconstruction& result) const;
  std::string Report(orthoslices::Reconstruction& result) const;
  void WriteOutputs(
    orthoslices::Reconstruction&& result, bool doublePrecision, vtkInformationVector* outputs);
  std::string CompareOthers(const orthoslices::Polylines& others,
    const std::vector<std::uint8_t>& guiding, vtkInformationVector* outputs) const;
  std::vector<vtkDataObject*> ListInputs();

  vtkMultiProcessController* Controller = nullptr;
  orthoslices::ProcessGroup* Processes = nullptr; ///< during RequestData: this one or several
  std::vector<vtkSmartPointer<vtkDataObject>> GatheredInputs; ///< of all ports, if several
  std::string InputRemarks; ///< what to tell the user of the inputs of this update
  std::string LabelArray;
  vtkNew<vtkStringArray> CellArrayNames; ///< see GetCellArrayNames
  double PlaneTolerance = 1e-5;
  int Orientation = ORIENT_BY_NESTING;
  int InvalidContours = MEND;
  int BorderContours = CLOSE_ALONG_BORDER;
  double BorderBounds[6] = { 0.0, -1.0, 0.0, -1.0, 0.0, -1.0 };
  int CrossingContours = REPAIR_CROSSING;
  int LoopRule = UNION;
  double RedrawnTolerance = 0.05;
  int SeveralCycles = BY_EVIDENCE;
  int Correspondence = CORRESPOND_BY_EVIDENCE;
  int ExpectedComponents = 0;
  int ExpectedGenus = -1;
  double MinimumComponentSize = 0.0;
  double MinimumIsolatedContourSize = 0.0;
  int PatchType = SMOOTH;
  double EdgeLength = 0.25;
  double ChordTolerance = 0.0;
  double Accuracy = 0.0;
  bool AutomaticAccuracy = true;
  bool KeepContourVertices = false;
  double CornerAngle = 60.0;
  double Smoothing = 0.0;
  double ContourTolerance = 0.0;
  int CentralPoint = LEAST_SQUARES;
  double AxisWeights[3] = { 1.0, 1.0, 1.0 };
  double ReportTolerance = 1e-3;
  bool WarnOfMissingFamilies = false;
  int Frame = AUTOMATIC_FRAME;
  double FrameNormals[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  bool InsertMissingContours = true;
  int VirtualSlices = AUTOMATIC_VIRTUAL_SLICES;
  double VirtualSliceSpacing = 0.0;
  bool FollowField = true;
  int EndCaps = DOME_ENDS;
  bool ComputeNormals = true;
  bool ComputeCurvatures = false;
  bool PassCellArrays = true;
  int OutputPointsPrecision = DEFAULT_PRECISION;
};

#endif
