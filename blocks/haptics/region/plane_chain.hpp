#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "blocks/haptics/region/plane_piece.hpp"

namespace stepwire {

/// Pieces that follow each other, as one goes along them.
struct PlaneChain {
  std::vector<PlanePiece> pieces;
  std::vector<Vector2> knots;  ///< where they meet, with both ends; the first is the last of a closed one
  bool closed = false;
};

/// What is wrong with a curve or a shape, and what would be right.
class ShapeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using PlaneCurve = std::function<Vector2(double parameter)>;

/// Lines and arcs that stay within `tolerance` of a curve. Throws ShapeError where it jumps, is not finite,
/// or takes too many pieces.
PlaneChain chain_along(const PlaneCurve& curve, double first, double last, double tolerance);

/// Straight from point to point; points that are the same are refused.
PlaneChain chain_through(const std::vector<Vector2>& points, bool closed);

/// The cubic spline of continuous curvature through points, over the lengths between them; its ends are
/// straight, or it closes smoothly.
PlaneChain spline_through(const std::vector<Vector2>& points, bool closed, double tolerance);

/// "(3, 180) mm"
std::string shown(Vector2 point);
/// "1.5 mm"
std::string shown(double length);

}  // namespace stepwire
