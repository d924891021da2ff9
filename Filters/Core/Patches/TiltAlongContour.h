// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTiltAlongContour_h
#define OrthoSlicesTiltAlongContour_h

#include "Core/Patches/SlopeOverSlice.h"
#include "Core/Slices/ContourCurve.h"

#include <vector>

namespace orthoslices
{
/**
 * Sine of the angle between the two contours of a node point below which their tangents give no
 * normal there. An error e (radians) of a tangent becomes an error e / sine of the normal: at 0.15
 * it is nearly seven times as large, and the tilt interpolated from the neighbours is better. With
 * half the value the normals of coarse contours are up to 16 % worse, with twice the value those of
 * exact and coarse ones change by -3 to +1 % (Testing/Benchmarks/PatchErrors).
 */
constexpr double MinSine = 0.15;

/**
 * Node points closer than this along a contour, as a part of the mean plane spacing, count as one.
 * A slope between them would be the difference of their tilts, errors included, by a small length.
 * With half and with twice the value the normals are worse by up to 5 % and 4 %, and better by up
 * to 3 % (Testing/Benchmarks/PatchErrors).
 */
constexpr double MergedNodes = 0.2;

/// A contour in the plane of its slice, and what is known of the surface's normals along it.
struct ContourRing
{
  int Axis = 2;         ///< of the slice
  double Spacing = 0.0; ///< the lesser mean spacing of the planes that cut the contour, world units
  MeasuredCurve Measured;
  std::vector<std::array<float, 2>> Tangents; ///< at each point, of unit length
  /// In space at each point: at a node point the outward normal, as long as the sine of the angle
  /// between its contours; zero at all others.
  std::vector<std::array<float, 3>> KnownNormals;

  Point3 KnownNormal(Index i) const
  {
    const std::array<float, 3>& n = this->KnownNormals[i];
    return { n[0], n[1], n[2] };
  }
};

/**
 * The *tilt* of a surface along one of its contours (our own addition): the angle in radians, from
 * -pi/2 to pi/2, of the outward normal against the slice, positive towards the slice's axis. With
 * the tangent of the contour it gives the normal.
 *
 * It is known at node points and interpolated between them by cubics (E. Catmull and R. Rom, 1974).
 * Where the surface runs nearly along the slice, the tilt changes as fast as the contour turns
 * there; it then follows from the slope of a height over the slice (SlopeOverSlice), if that has
 * the known tilts. Nothing is interpolated across corners of the contour: on either side of one the
 * tilt is that of the sample there.
 */
class TiltAlongContour
{
public:
  /// REQUIRES: the ring outlives this object.
  explicit TiltAlongContour(const ContourRing& ring);

  /// Whether the tilt is known at any node point.
  bool IsKnown() const { return !this->Samples.empty(); }

  /// At a point of the ring; 0 if nothing is known. REQUIRES: points are asked for in their order.
  double At(Index point);

private:
  /// The tilt at a node point.
  struct Sample
  {
    Index Place;   ///< point of the ring
    double Length; ///< along the contour, from its first point
    double Tilt;   ///< radians
    double Weight; ///< square of the sine of the angle between the contours
    double Slope;  ///< radians per length, where the interpolation is not broken by a corner
    /// How far from here, before the next sample, the contour has its first corner and its last
    /// one; negative if it has none.
    double FirstCorner = -1.0, LastCorner = -1.0;

    bool CornerAfter() const { return this->FirstCorner >= 0.0; }
  };

  /// The slope over the slice between two samples, and by how much it misses their tilts.
  struct Fit
  {
    SlopeOverSlice Slope;
    bool Valid = false;
    double Sign = 1.0; ///< of the tilt
    double MissedBefore = 0.0, MissedAfter = 0.0;
  };

  void SampleNodePoints();
  void MergeEnds();
  void FindCorners();
  void SetSlopes();
  void FitSlope(std::size_t before);
  void AddPart(Index first, Index count);
  double FittedTilt(Index point, double other) const;
  static double TiltBesideCorners(const Sample& p, const Sample& q, double length, double gone);
  static double Interpolate(const Sample& p, const Sample& q, double length, double share);

  const ContourRing& Ring;
  double Total; ///< length of the contour
  std::vector<Sample> Samples;
  std::size_t Next = 0; ///< the first sample after the last point asked for
  std::size_t Fitted;   ///< the sample after which the fit is made, or none
  Fit Height;
};
}

#endif
