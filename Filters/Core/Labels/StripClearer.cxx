// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/StripClearer.h"

#include "Core/Crossings/RegisterCrossings.h"

#include <algorithm>

namespace orthoslices
{
GridLine StripClearer::LineAt(const Station& node) const
{
  return LineOf(
    this->Axis, this->Coordinate, this->AxisOf(this->Across), this->Planes.EndOf(node.Band));
}

double StripClearer::NewPlaceOf(const Station& node) const
{
  const auto found = this->Nodes->find(this->LineAt(node));
  return found == this->Nodes->end() ? this->AlongOf(node)
                                     : found->second.NewPlace(this->AlongOf(node), this->Along);
}

StripClearer::Station StripClearer::LeaveBand(
  Index band, const Point2& from, const Point2& to) const
{
  const int across = this->Across, along = 1 - across;
  Point2 place;
  place[across] = this->Planes.EndOf(band);
  place[along] = this->Grid.Round(
    InterpolateFromLesser(place[across], { from[across], from[along] }, { to[across], to[along] }));
  return { place, band, false };
}

/// The stations of a contour, from one on at which it leaves a band, if there is any.
std::vector<StripClearer::Station> StripClearer::Walk(const std::vector<Point2>& polygon) const
{
  std::vector<Station> stations;
  Index band = this->Planes.Find(polygon.back()[this->Across]);
  const Point2* from = &polygon.back();
  for (const Point2& vertex : polygon)
  {
    const Index next = this->Planes.Find(vertex[this->Across]);
    for (; band < next; ++band)
    {
      stations.push_back(this->LeaveBand(band, *from, vertex));
    }
    for (; band > next; --band)
    {
      stations.push_back(this->LeaveBand(band - 1, *from, vertex));
    }
    stations.push_back({ vertex, band, true });
    from = &vertex;
  }
  const auto leaves = std::find_if(
    stations.begin(), stations.end(), [](const Station& station) { return !station.IsVertex; });
  if (leaves != stations.end())
  {
    std::rotate(stations.begin(), leaves, stations.end());
  }
  return stations;
}

void StripClearer::ListNodes(
  const std::vector<std::vector<Point2>>& polygons, NodesOfLines& nodes) const
{
  for (const std::vector<Point2>& polygon : polygons)
  {
    for (const Station& station : this->Walk(polygon))
    {
      if (station.IsNode())
      {
        nodes[this->LineAt(station)].Add(this->AlongOf(station));
      }
    }
  }
}

/// Adds what a contour does in a strip. It is moved if it does more there than to go straight across
/// from where it may pass the line.
void StripClearer::AddPassage(Passage passage)
{
  const std::vector<Station>& stations = this->Stations[passage.Contour];
  const std::size_t size = stations.size();
  const Station &first = stations[passage.First], &last = stations[passage.Last % size];
  const auto extend = [&](double along)
  {
    passage.Low = std::min(passage.Low, along);
    passage.High = std::max(passage.High, along);
  };
  for (std::size_t i = passage.First; i <= passage.Last; ++i)
  {
    const Station& station = stations[i % size];
    extend(this->AlongOf(station));
    if (station.IsVertex)
    {
      // One at which it passes the line is no other place than that.
      const auto isAt = [&](const Station& end)
      { return end.IsNode() && end.Place == station.Place; };
      passage.IsMoved |= isAt(first) == isAt(last);
    }
    else if (station.IsNode())
    {
      const double place = this->NewPlaceOf(station);
      extend(place);
      passage.IsMoved |= place != this->AlongOf(station);
    }
  }
  passage.Returns = first.IsNode() && last.IsNode();
  passage.IsMoved |= this->WithEnds && this->Along.IsStripIn(passage.Low, passage.High);
  this->Passages.push_back(passage);
}

void StripClearer::ListPassages(std::size_t contour)
{
  const std::vector<Station>& stations = this->Stations[contour];
  const std::size_t size = stations.size(), begin = this->Passages.size();
  if (stations.front().IsVertex) // all in one band
  {
    if (StripBands::IsStrip(stations.front().Band))
    {
      this->AddPassage({ contour, 0, size - 1, stations.front().Band });
    }
    return;
  }
  for (std::size_t first = 0, last = 0; first < size; first = last)
  {
    for (last = first + 1; stations[last % size].IsVertex; ++last)
    {
    }
    // Vertices tell the band; without any it has both ends.
    const Index band = last > first + 1
      ? stations[first + 1].Band
      : std::max(stations[first].Band, stations[last % size].Band);
    if (StripBands::IsStrip(band))
    {
      this->AddPassage({ contour, first, last, band });
    }
  }
  this->MoveBesideReturns(begin);
}

/// What leads to a place on a plane and back from it is moved, so that it does not end there. The
/// passages from `first` on are those of one contour.
void StripClearer::MoveBesideReturns(std::size_t first)
{
  const std::size_t count = this->Passages.size() - first;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (this->Passages[first + i].Returns)
    {
      for (const std::size_t beside : { i, i + 1, i + count - 1 })
      {
        this->Passages[first + beside % count].IsMoved = true;
      }
    }
  }
}

/// What overlaps with what is moved is moved, too.
void StripClearer::MoveNeighbors()
{
  std::vector<Passage*> sorted;
  for (Passage& passage : this->Passages)
  {
    sorted.push_back(&passage);
  }
  std::sort(sorted.begin(), sorted.end(),
    [](const Passage* a, const Passage* b)
    { return a->Strip != b->Strip ? a->Strip < b->Strip : a->Low < b->Low; });
  for (std::size_t first = 0, last = 0; first < sorted.size(); first = last)
  {
    double high = sorted[first]->High;
    bool isMoved = false;
    for (; last < sorted.size() && sorted[last]->Strip == sorted[first]->Strip &&
         sorted[last]->Low <= high;
         ++last)
    {
      high = std::max(high, sorted[last]->High);
      isMoved |= sorted[last]->IsMoved;
    }
    for (std::size_t i = first; i < last; ++i)
    {
      sorted[i]->IsMoved = isMoved;
    }
  }
}

/// Marks the stations on which a passage that is moved follows.
void StripClearer::MarkStations()
{
  for (const std::vector<Station>& stations : this->Stations)
  {
    this->IsMoved.emplace_back(stations.size(), 0);
  }
  for (const Passage& passage : this->Passages)
  {
    std::vector<std::uint8_t>& isMoved = this->IsMoved[passage.Contour];
    const bool isWhole = this->Stations[passage.Contour].front().IsVertex;
    for (std::size_t i = passage.First; i < passage.Last + (isWhole ? 1 : 0); ++i)
    {
      isMoved[i % isMoved.size()] |= passage.IsMoved ? 1 : 0;
    }
  }
}

void StripClearer::AddPlace(double across, double along, std::vector<Point2>& polygon) const
{
  Point2 place;
  place[this->Across] = across;
  place[1 - this->Across] = along;
  if (polygon.empty() || polygon.back() != place)
  {
    polygon.push_back(place);
  }
}

/// From rim to rim straight across the line, where what is beside it is moved.
void StripClearer::DrawNode(
  std::size_t contour, std::size_t number, std::vector<Point2>& polygon) const
{
  const std::vector<Station>& stations = this->Stations[contour];
  const std::size_t size = stations.size();
  const Station& node = stations[number];
  const double place = this->NewPlaceOf(node);
  Index from = node.Band, to = node.Band + 1;
  if (stations[(number + 1) % size].Band <= node.Band)
  {
    std::swap(from, to);
  }
  if (this->IsMoved[contour][(number + size - 1) % size] != 0)
  {
    this->AddPlace(this->Planes.RimOf(from), place, polygon);
  }
  this->AddPlace(node.Place[this->Across], place, polygon);
  if (this->IsMoved[contour][number] != 0)
  {
    this->AddPlace(this->Planes.RimOf(to), place, polygon);
  }
}

std::vector<Point2> StripClearer::Draw(std::size_t contour) const
{
  const std::vector<Station>& stations = this->Stations[contour];
  const std::vector<std::uint8_t>& isMoved = this->IsMoved[contour];
  const std::size_t size = stations.size();
  std::vector<Point2> polygon;
  for (std::size_t i = 0; i < size; ++i)
  {
    const Station& station = stations[i];
    const bool isBesideMoved = isMoved[(i + size - 1) % size] != 0 || isMoved[i] != 0;
    if (station.IsNode() && isBesideMoved)
    {
      this->DrawNode(contour, i, polygon);
    }
    else if (station.IsVertex || (!station.IsNode() && isBesideMoved))
    {
      const bool isToRim = station.IsVertex && isMoved[i] != 0;
      this->AddPlace(isToRim ? this->Planes.RimOf(station.Band) : station.Place[this->Across],
        this->AlongOf(station), polygon);
    }
  }
  while (polygon.size() > 1 && polygon.front() == polygon.back())
  {
    polygon.pop_back();
  }
  return polygon;
}

void StripClearer::Run(
  const NodesOfLines& nodes, bool withEnds, std::vector<std::vector<Point2>>& polygons)
{
  this->Nodes = &nodes;
  this->WithEnds = withEnds;
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    this->Stations.push_back(
      polygons[i].size() < 3 ? std::vector<Station>() : this->Walk(polygons[i]));
    if (!this->Stations.back().empty())
    {
      this->ListPassages(i);
    }
  }
  this->MoveNeighbors();
  this->MarkStations();
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    polygons[i] = this->Draw(i);
  }
}
}
