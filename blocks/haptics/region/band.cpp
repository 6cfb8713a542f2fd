#include <fmt/format.h>

#include "blocks/haptics/region/plane_shape.hpp"

namespace stepwire {

namespace {

constexpr double touching = 1e-9;  ///< [m] sides that are nearer to each other touch

double gap_at(const BandSide& left, const BandSide& right, double y) {
  return right.x(y) - left.x(y);
}

/// Returns the heights at which the sides are compared: those of all pieces and many in between.
std::vector<double> heights(const BandSide& left, const BandSide& right, double low, double high) {
  constexpr int steps = 1000;
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) all.push_back(low + (high - low) * i / steps);
  for (const BandSide* side : {&left, &right})
    for (const Vector2 knot : side->chain.knots) all.push_back(knot.y);
  return all;
}

void refuse_crossing(const BandSide& left, const BandSide& right, double low, double high) {
  bool empty = true;
  for (const double y : heights(left, right, low, high)) {
    const double gap = gap_at(left, right, y);
    if (gap < -touching)
      throw ShapeError(fmt::format(
          "at y = {} the left boundary is {} to the right of the right one; they may meet but not cross: end "
          "y where they do",
          shown(y), shown(-gap)));
    empty = empty && gap <= touching;
  }
  if (empty) throw ShapeError("the left boundary is the right one, so that the region is empty");
}

/// Adds the edge at one end of y; with `above`, the region is above it.
void close_end(const BandSide* left, const BandSide* right, double y, bool above, PlaneShape& shape) {
  const double side = above ? 1.0 : -1.0;
  if (left && right) {
    const Vector2 a{left->x(y), y}, b{right->x(y), y};
    if (b.x - a.x > touching) shape.push_back(line_between(a, b).with_side(side));
  } else if (right) {
    shape.push_back(ray_from({right->x(y), y}, {-1.0, 0.0}).with_side(-side));
  } else {
    shape.push_back(ray_from({left->x(y), y}, {1.0, 0.0}).with_side(side));
  }
}

}  // namespace

PlaneShape band(const BandSide* left, const BandSide* right, double low, double high) {
  if (left && right) refuse_crossing(*left, *right, low, high);
  PlaneShape shape;
  if (right) shape = right->chain.pieces;
  close_end(left, right, high, false, shape);
  if (left)
    for (const PlanePiece& piece : left->chain.pieces) shape.push_back(piece.with_side(-piece.side));
  close_end(left, right, low, true, shape);
  return shape;
}

}  // namespace stepwire
