// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesStripClearer_h
#define OrthoSlicesStripClearer_h

#include "Core/Labels/LineStrips.h"

namespace orthoslices
{
/**
 * Clears the strips beside the lines of one direction on one slice, all contours of which are known
 * as polygons; see ClearLines.
 */
class StripClearer
{
public:
  /// The planes lie across the slice's first axis (0) or its second one (1).
  StripClearer(const SpatialGrid& grid, int axis, double coordinate, int across)
    : Grid(grid)
    , Axis(axis)
    , Coordinate(coordinate)
    , Across(across)
    , Planes(grid, AxisOf(across))
    , Along(grid, AxisOf(1 - across))
  {
  }

  /// Adds the places at which polygons pass the lines.
  void ListNodes(const std::vector<std::vector<Point2>>& polygons, NodesOfLines& nodes) const;
  /// Clears the strips; what is within strips of the other direction, too, if `withEnds`.
  void Run(const NodesOfLines& nodes, bool withEnds, std::vector<std::vector<Point2>>& polygons);

private:
  /// A place on a contour: a vertex, or where it leaves a band for the next one.
  struct Station
  {
    Point2 Place;
    Index Band; ///< of a vertex; the lower one of two
    bool IsVertex;

    bool IsNode() const { return !this->IsVertex && StripBands::EndsOnPlane(this->Band); }
  };

  /// What a contour does in a strip: the stations from one end of the strip to another, or all.
  struct Passage
  {
    std::size_t Contour, First, Last;
    Index Strip;
    double Low = HUGE_VAL, High = -HUGE_VAL; ///< its range along the strip
    bool IsMoved = false;                    ///< to the rim
    bool Returns = false;                    ///< it begins and ends on the plane
  };

  int AxisOf(int side) const { return side == 0 ? FirstAxis(this->Axis) : SecondAxis(this->Axis); }
  double AlongOf(const Station& station) const { return station.Place[1 - this->Across]; }
  GridLine LineAt(const Station& node) const;
  double NewPlaceOf(const Station& node) const;
  Station LeaveBand(Index band, const Point2& from, const Point2& to) const;
  std::vector<Station> Walk(const std::vector<Point2>& polygon) const;
  void ListPassages(std::size_t contour);
  void AddPassage(Passage passage);
  void MoveBesideReturns(std::size_t first);
  void MoveNeighbors();
  void MarkStations();
  std::vector<Point2> Draw(std::size_t contour) const;
  void DrawNode(std::size_t contour, std::size_t number, std::vector<Point2>& polygon) const;
  void AddPlace(double across, double along, std::vector<Point2>& polygon) const;

  const SpatialGrid& Grid;
  const int Axis;
  const double Coordinate;
  const int Across;
  const StripBands Planes, Along;
  const NodesOfLines* Nodes = nullptr;
  bool WithEnds = false;
  std::vector<std::vector<Station>> Stations; ///< of each contour
  std::vector<Passage> Passages;
  std::vector<std::vector<std::uint8_t>> IsMoved; ///< what follows on each station
};
}

#endif
