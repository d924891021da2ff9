// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPlaneContours_h
#define OrthoSlicesPlaneContours_h

#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/// Floating-point type in which coordinates are stored in the end.
enum class Precision : std::uint8_t
{
  Single,
  Double
};

/// The value that is left of a coordinate once it is stored.
inline double RoundTo(Precision precision, double value)
{
  return precision == Precision::Single ? static_cast<double>(static_cast<float>(value)) : value;
}

/// A place on an edge of what was cut: its ends, and the fraction of the way from one to the other.
struct EdgePlace
{
  Index From, To;
  double Fraction;
};

/**
 * The closed contours of one plane, in its axes U and V. Contour i has the vertices Offsets[i] to
 * Offsets[i + 1] - 1; the first is not repeated. The interior is on the left.
 */
struct PlaneContours
{
  std::vector<double> U, V;
  std::vector<Index> Offsets{ 0 };
  std::vector<EdgePlace> Edges; ///< of each vertex, where whoever draws them keeps them; else empty

  Index Count() const { return static_cast<Index>(this->Offsets.size()) - 1; }

  /// Adds a vertex to the contour that is being drawn, unless it repeats the one before.
  void AddVertex(double u, double v)
  {
    if (this->U.size() == this->FirstOpen() || this->U.back() != u || this->V.back() != v)
    {
      this->U.push_back(u);
      this->V.push_back(v);
    }
  }

  /// The same with the place on an edge, which all vertices have then.
  void AddVertex(double u, double v, const EdgePlace& edge)
  {
    this->AddVertex(u, v);
    if (this->Edges.size() < this->U.size())
    {
      this->Edges.push_back(edge);
    }
  }

  /// Ends the contour; it is dropped if fewer than three distinct vertices are left.
  void CloseContour();

private:
  std::size_t FirstOpen() const { return static_cast<std::size_t>(this->Offsets.back()); }
  bool HasThreePlaces() const;
  void Shorten(std::size_t size);
};
}

#endif
