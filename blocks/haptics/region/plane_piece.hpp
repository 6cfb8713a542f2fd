#pragma once

#include <vector>

#include "blocks/haptics/region/plane.hpp"

namespace stepwire {

/// Straight line or circular arc, as a piece of a boundary or of a curve. Arcs run counterclockwise.
struct PlanePiece {
  double radius = 0.0;  ///< 0 for a line.
  Vector2 start;        ///< Start of a line.
  Vector2 along;        ///< Direction of a line.
  Vector2 centre;       ///< Centre of an arc.
  double from = 0.0;    ///< Angle of the start of an arc.
  double extent = 0.0;  ///< Length of a line, which may be infinite, or angle of an arc.
  double side = 1.0;    ///< 1: the region is to the left; -1: to the right.

  bool is_line() const { return radius == 0.0; }
  double length() const { return is_line() ? extent : radius * extent; }
  /// Returns the point at this distance along the piece.
  Vector2 at(double s) const;
  Vector2 direction(double s) const;
  Vector2 end() const { return at(length()); }
  PlanePiece part(double first, double last) const;
  PlanePiece with_side(double new_side) const;
};

/// Bounding box.
struct PlaneBox {
  Vector2 low, high;
  bool meets(const PlaneBox& other, double margin) const;
  double diagonal() const { return length(high - low); }
};

PlanePiece line_between(Vector2 a, Vector2 b);
/// Returns an infinite line from a point.
PlanePiece ray_from(Vector2 start, Vector2 along);
PlanePiece arc_about(Vector2 centre, double radius, double from, double extent);
/// Returns the arc from a through b to c, with side 1 if the region is to its left; a line if the points are
/// collinear.
PlanePiece arc_through(Vector2 a, Vector2 b, Vector2 c);

PlaneBox box_of(const PlanePiece& piece);
PlaneBox joined(const PlaneBox& a, const PlaneBox& b);

/// Returns the places along `piece` where it meets `other`; for a common section its begin and end.
std::vector<double> crossings(const PlanePiece& piece, const PlanePiece& other, double tolerance);

}  // namespace stepwire
