#pragma once

#include <vector>

#include "blocks/haptics/region/plane.hpp"

namespace stepwire {

/// A straight line or an arc of a circle as a piece of a boundary or of a curve. An arc runs
/// counterclockwise.
struct PlanePiece {
  double radius = 0.0;  ///< 0 for a line
  Vector2 start;        ///< of a line
  Vector2 along;        ///< direction of a line
  Vector2 centre;       ///< of an arc
  double from = 0.0;    ///< angle at which an arc begins
  double extent = 0.0;  ///< length of a line, possibly infinite, or angle of an arc
  double side = 1.0;    ///< 1: the region is to the left, -1: to the right

  bool is_line() const { return radius == 0.0; }
  double length() const { return is_line() ? extent : radius * extent; }
  /// The point this far along it.
  Vector2 at(double s) const;
  Vector2 direction(double s) const;
  Vector2 end() const { return at(length()); }
  PlanePiece part(double first, double last) const;
  PlanePiece with_side(double new_side) const;
};

/// Lowest and highest coordinates of something.
struct PlaneBox {
  Vector2 low, high;
  bool meets(const PlaneBox& other, double margin) const;
  double diagonal() const { return length(high - low); }
};

PlanePiece line_between(Vector2 a, Vector2 b);
/// From a point without end.
PlanePiece ray_from(Vector2 start, Vector2 along);
PlanePiece arc_about(Vector2 centre, double radius, double from, double extent);
/// From a through b to c, with side 1 where the region is to the left of one who goes that way; a line where
/// the three are in one.
PlanePiece arc_through(Vector2 a, Vector2 b, Vector2 c);

PlaneBox box_of(const PlanePiece& piece);
PlaneBox joined(const PlaneBox& a, const PlaneBox& b);

/// How far along `piece` it meets `other`; where they share a stretch, where that begins and ends.
std::vector<double> crossings(const PlanePiece& piece, const PlanePiece& other, double tolerance);

}  // namespace stepwire
