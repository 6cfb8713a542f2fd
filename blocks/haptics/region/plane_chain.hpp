#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "blocks/haptics/region/plane_piece.hpp"

namespace stepwire {

/// Successive pieces along a curve.
struct PlaneChain {
  std::vector<PlanePiece> pieces;
  std::vector<Vector2> knots;  ///< their joints, with both ends; the first is the last of a closed one
  bool closed = false;
};

/// Fault of a curve or a shape, with its cure.
class ShapeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using PlaneCurve = std::function<Vector2(double parameter)>;

/// Returns lines and arcs within `tolerance` of a curve. Throws ShapeError if it jumps, is not finite, or
/// needs too many pieces.
PlaneChain chain_along(const PlaneCurve& curve, double first, double last, double tolerance);

/// Returns straight lines between successive points. Throws ShapeError for equal points.
PlaneChain chain_through(const std::vector<Vector2>& points, bool closed);

/// Returns the cubic spline of continuous curvature through points, with chord-length parameters. Its ends
/// have zero curvature, or it is closed smoothly.
PlaneChain spline_through(const std::vector<Vector2>& points, bool closed, double tolerance);

/// Returns "(3, 180) mm".
std::string shown(Vector2 point);
/// Returns "1.5 mm".
std::string shown(double length);

}  // namespace stepwire
