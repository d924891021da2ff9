// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what the volume methods share: sampled distance fields between slices, iso-surface
 *
 * Everything is sampled on a rectilinear lattice that contains the planes of the slices, so that
 * irregular planes need no resampling.
 */

#ifndef OrthoSlicesDistanceVolume_h
#define OrthoSlicesDistanceVolume_h

#include "PlanarContours.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace orthoslices
{
namespace baselines
{

/// Ascending coordinates of the samples on the x-, y- and z-axis; x runs fastest in arrays.
struct Lattice
{
  std::array<std::vector<double>, 3> Coordinates;

  std::size_t NumberOfSamples() const
  {
    return this->Coordinates[0].size() * this->Coordinates[1].size() * this->Coordinates[2].size();
  }

  std::size_t Index(const std::array<std::size_t, 3>& at) const
  {
    return at[0] + this->Coordinates[0].size() * (at[1] + this->Coordinates[1].size() * at[2]);
  }
};

/**
 * Adds an empty slice at both ends, one spacing away and beyond [low, high]: there the object has
 * ended. A single slice gets `low` and `high`, or the distance 1 if these do not lie outside.
 */
void PadWithEmptySlices(std::vector<Slice>& slices, double low, double high);

/// The planes of the slices, with every interval divided into equal parts of at most LONGEST.
std::vector<double> RefineByLength(const std::vector<Slice>& slices, double longest);

/// The planes of the slices, with every interval divided into PARTS equal parts.
std::vector<double> RefineByNumber(const std::vector<Slice>& slices, int parts);

/**
 * Signed distances to the contours of one family, linear between two slices (R. Klein,
 * A. Schilling, "Fast distance field interpolation for reconstruction of surfaces from contours",
 * Eurographics 1999 short papers; the shape-based interpolation of S. P. Raya and J. K. Udupa,
 * IEEE Transactions on Medical Imaging 9(1), 1990, with exact distances).
 *
 * A slice without contours has no distances. Towards it, inner values become negative a little
 * before the middle of the interval, the sooner the smaller they are, which makes a rounded end; of
 * the rules tried on real shapes (flat lids, roofs, constants) it had the least RMS error.
 */
class FamilyField
{
public:
  /// SLICES after PadWithEmptySlices(); their planes are coordinates of LATTICE on AXIS.
  FamilyField(const std::vector<Slice>& slices, int axis, const Lattice& lattice);
  FamilyField(const FamilyField&) = delete;
  void operator=(const FamilyField&) = delete;

  /// What the family knows about a sample of the lattice.
  struct Estimate
  {
    double Value;    ///< interpolated distance, positive inside
    double Slope;    ///< its derivative along the axis
    double Distance; ///< from the nearest slice; padding does not count
  };

  Estimate At(const std::array<std::size_t, 3>& at) const
  {
    const Place& place = this->Places[at[this->Axis]];
    const std::size_t raster = at[(this->Axis + 1) % 3] + this->RowSize * at[(this->Axis + 2) % 3];
    const double* below = this->Planes[place.Below];
    const double* above = this->Planes[place.Below + 1];
    const double low = below ? below[raster] : EndOf(above, raster, place.Length);
    const double high = above ? above[raster] : EndOf(below, raster, place.Length);
    return { low + place.Fraction * (high - low), (high - low) / place.Length, place.Distance };
  }

private:
  // Where a coordinate lies between the slices Below and Below + 1.
  struct Place
  {
    std::size_t Below = 0;
    double Fraction = 0.0;
    double Length = 1.0;
    double Distance = 0.0;
  };

  // Value on an empty slice where an interval ends at OTHER, the field of its other slice.
  static double EndOf(const double* other, std::size_t raster, double length)
  {
    return other && other[raster] > 0.0 ? -other[raster] - 0.5 * length : -length;
  }

  void SamplePlane(const Slice& slice, const Lattice& lattice, double* values) const;
  void FindPlaces(const std::vector<Slice>& slices, const std::vector<double>& coordinates);

  int Axis;
  std::size_t RowSize;
  std::vector<double> Values;
  std::vector<const double*> Planes; // null for empty slices
  std::vector<Place> Places;         // of the lattice's coordinates on the axis
};

/**
 * The surface where VALUES, one for each sample of LATTICE, pass zero, oriented towards negative
 * values. Values at the border of the lattice have to be negative for a closed surface. Values of
 * almost zero are moved by a thousandth of the lattice's smallest distance, so that the surface
 * passes no sample and has no collapsed triangles.
 */
vtkSmartPointer<vtkPolyData> ExtractZeroSurface(const Lattice& lattice, std::vector<double> values);

/// Largest number of samples that the volume methods accept.
constexpr std::size_t MaximumNumberOfSamples = std::size_t(1) << 28;

/// @throw std::runtime_error if LATTICE has more than MaximumNumberOfSamples.
void CheckSize(const Lattice& lattice);

/// Evaluates VALUE(i, j, k) at all samples in parallel, given as std::array<std::size_t, 3>.
template <typename Functor>
std::vector<double> SampleAll(const Lattice& lattice, const Functor& value);

} // namespace baselines
} // namespace orthoslices

#include "DistanceVolume.txx"

#endif
