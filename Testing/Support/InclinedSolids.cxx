// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/InclinedSolids.h"

#include "Core/Base/Predicates.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace support
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Negative inside, about a distance near the surface.
using Field = std::function<double(const Point3&)>;

/// Moved by shear * z along x and y.
struct Shear
{
  double X, Y;
};

Field Sheared(const Field& field, const Shear& shear)
{
  return [=](const Point3& p) {
    return field({ p[0] - shear.X * p[2], p[1] - shear.Y * p[2], p[2] });
  };
}

Field Union(const std::vector<Field>& fields)
{
  return [fields](const Point3& p)
  {
    double value = HUGE_VAL;
    for (const Field& field : fields)
    {
      value = std::min(value, field(p));
    }
    return value;
  };
}

/// The part between two heights.
Field Between(double low, double high, const Field& field)
{
  return [=](const Point3& p) { return std::max({ field(p), low - p[2], p[2] - high }); };
}

/// Half the width along x and y, before the shear.
using Size = std::array<double, 2>;

InclinedSolid Make(char family, const std::string& name, const Field& field, const Shear& shear,
  const Size& size, int components, int genus)
{
  InclinedSolid object;
  object.Family = family;
  Solid& solid = object.Shape;
  solid.Name = name;
  solid.Components = components;
  solid.Genus = genus;
  solid.Function = Sheared(field, shear);
  const double x = size[0] + std::abs(shear.X) + 0.1;
  const double y = size[1] + std::abs(shear.Y) + 0.1;
  solid.Low = { -x, -y, -1.0 };
  solid.High = { x, y, 1.0 };
  object.Planes =
    EqualPlanes(solid, { static_cast<int>(2.0 * x / 0.08), static_cast<int>(2.0 * y / 0.08), 10 });
  return object;
}

//----------------------------------------------------------------------------
// Sections
Field Ellipse(const std::function<Point2(double z)>& center, double a, double b)
{
  return [=](const Point3& p)
  {
    const Point2 c = center(p[2]);
    return (std::hypot((p[0] - c[0]) / a, (p[1] - c[1]) / b) - 1.0) * std::min(a, b);
  };
}

Field Column(double y, double a, double b)
{
  return Ellipse([=](double) { return Point2{ 0.0, y }; }, a, b);
}

Field Star(double y, int arms, double radius, double depth)
{
  return [=](const Point3& p)
  {
    const double angle = std::atan2(p[1] - y, p[0]);
    return 0.5 * (std::hypot(p[0], p[1] - y) - radius * (1.0 + depth * std::cos(arms * angle)));
  };
}

Field Crescent(double radius, double notch)
{
  return [=](const Point3& p)
  {
    return std::max(
      std::hypot(p[0], p[1]) - radius, 0.85 * radius - std::hypot(p[0], p[1] - notch));
  };
}

/// Along a curve in space.
Field Along(std::vector<Point3> curve, double radius)
{
  const Tube tube = CurveTube(std::move(curve), false, radius);
  return [tube](const Point3& p)
  {
    const Point3 q = tube.Nearest(p);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) - tube.Radius;
  };
}

//----------------------------------------------------------------------------
constexpr double End = 0.96;  ///< flat ends, beyond the last slices
constexpr double Foot = 0.91; ///< where axes of tubes with round ends end

void AddFamilyA(std::vector<InclinedSolid>& solids)
{
  const auto add =
    [&](const char* name, const Field& field, const Shear& shear, const Size& size, int count = 1)
  { solids.push_back(Make('A', name, Between(-End, End, field), shear, size, count, 0)); };

  add("tube", Column(0.0, 0.1, 0.1), { 1.5, 0.0 }, { 0.1, 0.1 });
  add("thick tube, more inclined", Column(0.0, 0.2, 0.2), { 2.3, 0.0 }, { 0.2, 0.2 });
  add("oblique oval tube", Column(0.0, 0.11, 0.08), { 1.2, 0.9 }, { 0.11, 0.08 });
  add("broad tube", Column(0.0, 0.09, 0.2), { 1.3, 0.0 }, { 0.09, 0.2 });
  const auto bend = [](double z) { return Point2{ 0.0, 0.5 * std::sin(1.5 * z) }; };
  add("bent tube", Ellipse(bend, 0.1, 0.1), { 1.5, 0.0 }, { 0.1, 0.6 });
  add("two tubes", Union({ Column(-0.5, 0.1, 0.1), Column(0.5, 0.1, 0.1) }), { 1.5, 0.0 },
    { 0.1, 0.6 }, 2);
  add("three tubes",
    Union({ Column(-0.95, 0.1, 0.1), Column(0.0, 0.1, 0.12), Column(0.95, 0.12, 0.1) }),
    { 1.6, 0.0 }, { 0.12, 1.05 }, 3);
}

/// A trunk that divides at the given height: two equal circles move apart.
Field Fork(double height, double radius, double spread)
{
  std::vector<Field> branches;
  for (const double side : { -1.0, 1.0 })
  {
    branches.push_back(Ellipse(
      [=](double z) {
        return Point2{ 0.0, side * spread * std::max(0.0, z - height) };
      },
      radius, radius));
  }
  return Union(branches);
}

void AddFamilyB(std::vector<InclinedSolid>& solids)
{
  const auto add =
    [&](const char* name, const Field& field, const Shear& shear, const Size& size, int count = 1)
  { solids.push_back(Make('B', name, Between(-End, End, field), shear, size, count, 0)); };

  add("star of three arms", Star(0.0, 3, 0.1, 0.55), { 1.8, 0.0 }, { 0.16, 0.16 });
  add("star of five arms", Star(0.0, 5, 0.12, 0.5), { 2.0, 0.0 }, { 0.18, 0.18 });
  add("crescent", Crescent(0.15, 0.12), { 1.7, 0.0 }, { 0.15, 0.15 });
  add("two stars", Union({ Star(-0.6, 4, 0.13, 0.4), Star(0.6, 3, 0.12, 0.5) }), { 2.0, 0.0 },
    { 0.19, 0.8 }, 2);
  // The slice at z = -0.1 cuts where the branches begin to part.
  add("fork", Fork(-0.24, 0.1, 0.6), { 1.5, 0.0 }, { 0.1, 0.85 });
  add("wide fork", Fork(-0.2, 0.12, 1.0), { 1.6, 0.0 }, { 0.12, 1.3 });
  add("fork of stars",
    Union({ Between(-End, -0.2, Star(0.0, 3, 0.12, 0.5)),
      Between(-0.22, End,
        Ellipse(
          [](double z) {
            return Point2{ 0.0, -0.11 - 0.5 * (z + 0.2) };
          },
          0.1, 0.1)),
      Between(-0.22, End,
        Ellipse(
          [](double z) {
            return Point2{ 0.0, 0.11 + 0.5 * (z + 0.2) };
          },
          0.1, 0.1)),
      Between(-0.22, -0.05, Column(0.0, 0.08, 0.2)) }),
    { 1.8, 0.0 }, { 0.18, 0.8 });
}

/// Columns on a plate, under a plate; plates reach beyond the outer columns.
Field Colonnade(double low, double high, double thickness, const std::vector<double>& places,
  double reach, double radius)
{
  std::vector<Field> parts{ Between(low - thickness, low, Column(0.0, 0.1, reach)),
    Between(high, high + thickness, Column(0.0, 0.1, reach)) };
  for (const double y : places)
  {
    parts.push_back(
      Between(low - 0.5 * thickness, high + 0.5 * thickness, Column(y, radius, radius)));
  }
  return Union(parts);
}

void AddFamilyC(std::vector<InclinedSolid>& solids)
{
  const auto add =
    [&](const char* name, const Field& field, const Shear& shear, const Size& size, int genus)
  { solids.push_back(Make('C', name, field, shear, size, 1, genus)); };

  add("two columns", Colonnade(-0.8, 0.8, 0.16, { -0.45, 0.45 }, 0.7, 0.09), { 1.5, 0.0 },
    { 0.1, 0.7 }, 1);
  add("two columns, oblique", Colonnade(-0.8, 0.8, 0.16, { -0.45, 0.45 }, 0.7, 0.08), { 1.5, 0.3 },
    { 0.1, 0.7 }, 1);
  add("three columns", Colonnade(-0.8, 0.8, 0.16, { -0.6, 0.0, 0.6 }, 0.85, 0.09), { 1.6, 0.0 },
    { 0.1, 0.85 }, 2);
  add("four columns", Colonnade(-0.8, 0.8, 0.16, { -0.9, -0.3, 0.3, 0.9 }, 1.15, 0.09),
    { 1.6, 0.0 }, { 0.1, 1.15 }, 3);
  add("thick plates", Colonnade(-0.4, 0.4, 0.56, { -0.45, 0.45 }, 0.7, 0.09), { 1.5, 0.0 },
    { 0.1, 0.7 }, 1);
  add("ladder",
    Union({ Colonnade(-0.8, 0.0, 0.16, { -0.45, 0.45 }, 0.7, 0.09),
      Colonnade(0.0, 0.8, 0.16, { -0.45, 0.45 }, 0.7, 0.09) }),
    { 1.5, 0.0 }, { 0.1, 0.7 }, 2);
  add(
    "ring", [](const Point3& p) { return std::hypot(std::hypot(p[1], p[2]) - 0.66, p[0]) - 0.13; },
    { 1.6, 0.0 }, { 0.13, 0.8 }, 1);
}

/// An arc about (y, z) in the plane x = 0, angles in degrees from +y towards +z.
void AppendArc(
  std::vector<Point3>& curve, const Point2& center, double radius, double from, double to)
{
  for (int i = 0; i <= 24; ++i)
  {
    const double angle = (from + (to - from) * i / 24.0) * Pi / 180.0;
    curve.push_back(
      { 0.0, center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle) });
  }
}

/// Legs that end at +-foot, under an arch as wide as 2 * radius. Its top lies between two slices.
Field Arch(double foot, double radius, double thickness)
{
  std::vector<Point3> curve{ { 0.0, -foot, -Foot } };
  AppendArc(curve, { 0.0, 0.8 - radius }, radius, 180.0, 0.0);
  curve.push_back({ 0.0, foot, -Foot });
  return Along(curve, thickness);
}

/// Up, down, up, ... : legs side by side at the given distance, with turns between two slices.
Field Serpent(int legs, double distance, double thickness)
{
  std::vector<Point3> curve;
  const double first = -0.5 * distance * (legs - 1);
  curve.push_back({ 0.0, first, -Foot });
  for (int i = 0; i + 1 < legs; ++i)
  {
    const double y = first + distance * (i + 0.5);
    const double radius = 0.5 * distance;
    if (i % 2 == 0)
    {
      AppendArc(curve, { y, 0.8 - radius }, radius, 180.0, 0.0);
    }
    else
    {
      AppendArc(curve, { y, radius - 0.8 }, radius, 180.0, 360.0);
    }
  }
  curve.push_back({ 0.0, first + distance * (legs - 1), legs % 2 == 0 ? -Foot : Foot });
  return Along(curve, thickness);
}

/// A spiral in planes of constant x that advances along x.
Field Spiral(double turns, double inner, double outer, double advance, double thickness)
{
  std::vector<Point3> curve;
  const int steps = static_cast<int>(40 * turns);
  for (int i = 0; i <= steps; ++i)
  {
    const double s = static_cast<double>(i) / steps;
    const double angle = 2.0 * Pi * turns * s + 0.3;
    const double radius = outer + (inner - outer) * s;
    curve.push_back({ advance * (s - 0.5), radius * std::cos(angle), radius * std::sin(angle) });
  }
  return Along(curve, thickness);
}

void AddFamilyD(std::vector<InclinedSolid>& solids)
{
  const auto add = [&](const char* name, const Field& field, const Shear& shear, const Size& size)
  { solids.push_back(Make('D', name, field, shear, size, 1, 0)); };

  add("horseshoe", Arch(0.16, 0.45, 0.07), { 0.0, 0.0 }, { 0.07, 0.52 });
  add("inclined horseshoe", Arch(0.16, 0.45, 0.06), { 1.0, 0.0 }, { 0.06, 0.51 });
  add("wide horseshoe", Arch(0.2, 0.6, 0.07), { 0.5, 0.0 }, { 0.07, 0.67 });
  add("serpent of three legs", Serpent(3, 0.36, 0.08), { 0.0, 1.1 }, { 0.08, 0.44 });
  add("serpent of four legs", Serpent(4, 0.36, 0.08), { 0.3, 1.1 }, { 0.08, 0.62 });
  add("serpent of five legs", Serpent(5, 0.38, 0.08), { 0.0, -1.2 }, { 0.08, 0.84 });
}
}

//----------------------------------------------------------------------------
std::vector<InclinedSolid> FigureOneSolids()
{
  std::vector<InclinedSolid> solids;
  AddFamilyA(solids);
  AddFamilyB(solids);
  AddFamilyC(solids);
  AddFamilyD(solids);
  return solids;
}

//----------------------------------------------------------------------------
std::vector<InclinedSolid> FigureTwoSolids()
{
  std::vector<InclinedSolid> solids;
  const auto add = [&](const char* name, const Field& field, const Shear& shear, const Size& size)
  { solids.push_back(Make('D', name, field, shear, size, 1, 0)); };
  add("spiral of 1.25 turns", Spiral(1.25, 0.45, 0.88, 0.5, 0.07), { 0.0, 0.0 }, { 0.32, 0.95 });
  add("spiral of 2.25 turns", Spiral(2.25, 0.25, 0.88, 0.8, 0.07), { 0.0, 0.0 }, { 0.47, 0.95 });
  add("inclined spiral", Spiral(2.5, 0.25, 0.88, 0.8, 0.07), { 0.6, 0.0 }, { 0.47, 0.95 });
  add("spiral of 3.25 turns", Spiral(3.25, 0.21, 0.86, 1.2, 0.06), { 0.0, 0.2 }, { 0.66, 0.95 });
  return solids;
}

//----------------------------------------------------------------------------
std::vector<InclinedSolid> Exceptions()
{
  std::vector<InclinedSolid> solids;
  solids.push_back(Make('A', "two close tubes",
    Between(-End, End, Union({ Column(-0.2, 0.1, 0.1), Column(0.2, 0.1, 0.1) })), { 1.5, 0.0 },
    { 0.1, 0.3 }, 2, 0));
  solids.push_back(Make('B', "fork with oval sections", Between(-End, End, Fork(-0.18, 0.1, 0.6)),
    { 1.5, 0.0 }, { 0.1, 0.85 }, 1, 0));
  solids.push_back(
    Make('D', "arch on legs apart", Arch(0.7, 0.4, 0.07), { 0.0, 0.0 }, { 0.07, 0.77 }, 1, 0));
  solids.push_back(Make(
    'D', "inclined arch on legs apart", Arch(0.7, 0.4, 0.06), { 1.0, 0.0 }, { 0.06, 0.76 }, 1, 0));
  return solids;
}

} // namespace support
} // namespace orthoslices
