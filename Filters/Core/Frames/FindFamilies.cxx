// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/FindFamilies.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/// Contours whose normals are that close belong to one family, whatever their noise: 2 degrees.
/// Planes drawn or moved by hand are not that parallel; planes at different angles on purpose are
/// farther.
const double CosineWithin = std::cos(2.0 * 3.14159265358979323846 / 180.0);

/// Families have to be that far apart, by the volume of the box of their unit normals: two of them
/// by 15 degrees. Closer ones make cells so oblique that nothing is left of their shape.
constexpr double LeastVolume = 0.25;

/// A family has a contour of at least this part of the weight of the greatest one, or three
/// contours: a small piece that is left over somewhere is none, but slices through a thin plate
/// are.
constexpr double LeastShare = 0.02;
constexpr Index LeastContours = 3;

/// So many families, the greatest ones, are combined to three.
constexpr std::size_t MaxCandidates = 24;

/// Contours of fewer points than that do not show how thick they are.
constexpr Index LeastPoints = 6;

/// How far a root mean square of noise may be from the typical one.
constexpr double NoiseFactor = 4.0;

double AbsoluteCosine(const Point3& a, const Point3& b) { return std::abs(Dot(a, b)); }

void AddTo(PlaneFamily& family, const PieceGroup& group)
{
  family.Points.Add(group.Points);
  ++family.Contours;
  family.Weight += group.Weight();
  family.Largest = std::max(family.Largest, group.Weight());
  if (group.Port < 3)
  {
    family.WeightOfPort[group.Port] += group.Weight();
  }
  family.Normal = FitPlane(family.Points).Normal;
}

/// Contours with about the same normal, the greatest ones first.
std::vector<PlaneFamily> Cluster(const std::vector<PieceGroup>& groups, const PlaneNoise& noise)
{
  std::vector<Index> order(groups.size());
  std::iota(order.begin(), order.end(), 0);
  order.erase(
    std::remove_if(order.begin(), order.end(), [&](Index i) { return !groups[i].IsPlanar(); }),
    order.end());
  std::stable_sort(order.begin(), order.end(),
    [&](Index a, Index b) { return groups[a].Weight() > groups[b].Weight(); });
  std::vector<PlaneFamily> families;
  for (const Index i : order)
  {
    const PieceGroup& group = groups[i];
    PlaneFamily* nearest = nullptr;
    for (PlaneFamily& family : families)
    {
      const bool fits = noise.IsExplained(group, family.Normal);
      if (fits &&
        (nearest == nullptr ||
          group.Points.Along(family.Normal) < group.Points.Along(nearest->Normal)))
      {
        nearest = &family;
      }
    }
    if (nearest == nullptr)
    {
      families.emplace_back();
      nearest = &families.back();
    }
    AddTo(*nearest, group);
  }
  return families;
}

/// Whether contours make a family, where `largest` is the weight of the greatest contour of all.
bool SaysEnough(const PlaneFamily& family, double largest)
{
  const bool isLarge = family.Largest >= LeastShare * largest;
  const bool isPlane = family.Points.Points > 3; // any three points lie on one
  return (isLarge && isPlane) || family.Contours >= LeastContours;
}

/// Normals of which an axis of the world says as much become that.
void PreferWorld(const PlaneNoise& noise, PlaneFamily& family)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Point3 unit{ 0.0, 0.0, 0.0 };
    unit[axis] = 1.0;
    if (AbsoluteCosine(unit, family.Normal) > 0.9 && family.Allows(unit, noise))
    {
      family.Normal = unit;
    }
  }
}

/// Families that have become the same are one: the earlier one keeps its normal.
void MergeAlike(std::vector<PlaneFamily>& families)
{
  std::vector<PlaneFamily> merged;
  for (const PlaneFamily& family : families)
  {
    const auto same = std::find_if(merged.begin(), merged.end(),
      [&](const PlaneFamily& other)
      { return AbsoluteCosine(other.Normal, family.Normal) >= CosineWithin; });
    if (same == merged.end())
    {
      merged.push_back(family);
      continue;
    }
    same->Points.Add(family.Points);
    same->Contours += family.Contours;
    same->Weight += family.Weight;
    same->Largest = std::max(same->Largest, family.Largest);
    for (int port = 0; port < 3; ++port)
    {
      same->WeightOfPort[port] += family.WeightOfPort[port];
    }
  }
  families.swap(merged);
}

/// The greatest families that are well apart: three if there are, else two, else one.
class FamilyChoice
{
public:
  explicit FamilyChoice(const std::vector<PlaneFamily>& families)
    : Families(families)
  {
  }

  std::vector<Index> Run()
  {
    const Index count = static_cast<Index>(this->Families.size());
    for (Index i = 0; i < count; ++i)
    {
      this->Try({ i }, 1.0);
      for (Index j = i + 1; j < count; ++j)
      {
        const Point3 cross = Cross(this->Families[i].Normal, this->Families[j].Normal);
        this->Try({ i, j }, Length(cross));
        for (Index k = j + 1; k < count; ++k)
        {
          this->Try({ i, j, k }, std::abs(Dot(cross, this->Families[k].Normal)));
        }
      }
    }
    return this->Best;
  }

private:
  void Try(const std::vector<Index>& chosen, double volume)
  {
    double weight = 0.0;
    for (const Index i : chosen)
    {
      weight += this->Families[i].Weight;
    }
    const double score = weight * volume;
    const bool better = chosen.size() > this->Best.size() ||
      (chosen.size() == this->Best.size() && score > this->Score);
    if (volume >= LeastVolume && better)
    {
      this->Best = chosen;
      this->Score = score;
    }
  }

  const std::vector<PlaneFamily>& Families;
  std::vector<Index> Best;
  double Score = 0.0;
};
}

double PlaneNoise::Of(const PieceGroup& group) const
{
  const double known = std::max(group.Fit.Thickness, this->Typical);
  return this->Typical < 0.0 ? std::max(known, 1e-3 * group.Fit.Length) : known;
}

bool PlaneNoise::IsExplained(const PieceGroup& group, const Point3& normal) const
{
  const double most = std::max(0.5 * this->Tolerance, NoiseFactor * this->Of(group));
  return group.Points.Along(normal) <= most ||
    (group.IsPlanar() && AbsoluteCosine(group.Fit.Normal, normal) >= CosineWithin);
}

PlaneNoise MeasureNoise(const std::vector<PieceGroup>& groups, double tolerance)
{
  PlaneNoise noise;
  noise.Tolerance = tolerance;
  std::vector<double> thicknesses;
  for (const PieceGroup& group : groups)
  {
    if (group.IsPlanar() && group.Points.Points >= LeastPoints)
    {
      thicknesses.push_back(group.Fit.Thickness);
    }
  }
  if (!thicknesses.empty())
  {
    const auto middle = thicknesses.begin() + thicknesses.size() / 2;
    std::nth_element(thicknesses.begin(), middle, thicknesses.end());
    noise.Typical = *middle;
  }
  return noise;
}

bool PlaneFamily::Allows(const Point3& normal, const PlaneNoise& noise) const
{
  const PlaneFit fit = FitPlane(this->Points);
  const double unknown = noise.Typical < 0.0 ? 1e-3 * fit.Length : noise.Typical;
  const double thickness = std::max(this->Points.Along(this->Normal), unknown);
  return this->Points.Along(normal) <= std::max(0.5 * noise.Tolerance, 2.0 * thickness);
}

std::vector<PlaneFamily> FindFamilies(
  const std::vector<PieceGroup>& groups, const PlaneNoise& noise)
{
  std::vector<PlaneFamily> families = Cluster(groups, noise);
  double largest = 0.0;
  for (PlaneFamily& family : families)
  {
    PreferWorld(noise, family);
    largest = std::max(largest, family.Largest);
  }
  MergeAlike(families);
  families.erase(std::remove_if(families.begin(), families.end(),
                   [&](const PlaneFamily& family) { return !SaysEnough(family, largest); }),
    families.end());
  std::stable_sort(families.begin(), families.end(),
    [](const PlaneFamily& a, const PlaneFamily& b) { return a.Weight > b.Weight; });
  families.resize(std::min(families.size(), MaxCandidates));
  std::vector<PlaneFamily> chosen;
  for (const Index i : FamilyChoice(families).Run())
  {
    chosen.push_back(families[i]);
  }
  return chosen;
}
}
