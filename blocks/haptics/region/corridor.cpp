#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "blocks/haptics/region/plane_shape.hpp"
#include "engine/base/math/elementary.hpp"

namespace stepwire {

namespace {

/// Short straight section of a chain.
struct Stretch {
  PlanePiece line;
  double start = 0.0;     ///< distance of its begin along the chain
  std::size_t piece = 0;  ///< index of its piece
};

double length_of(const PlaneChain& chain) {
  double whole = 0.0;
  for (const PlanePiece& piece : chain.pieces) whole += piece.length();
  return whole;
}

std::vector<Stretch> stretches_of(const PlaneChain& chain, double half_width) {
  constexpr double most = 1500.0;
  const double step = std::max(0.25 * half_width, length_of(chain) / most);
  std::vector<Stretch> stretches;
  double start = 0.0;
  for (std::size_t i = 0; i < chain.pieces.size(); ++i) {
    const PlanePiece& piece = chain.pieces[i];
    const bool forward = length(piece.at(0.0) - chain.knots[i]) <= length(piece.end() - chain.knots[i]);
    const int parts = static_cast<int>(std::ceil(piece.length() / step));
    const double part = piece.length() / parts;
    for (int k = 0; k < parts; ++k, start += part) {
      const double from = forward ? k * part : piece.length() - k * part;
      stretches.push_back(
          {line_between(piece.at(from), piece.at(forward ? from + part : from - part)), start, i});
    }
  }
  return stretches;
}

double distance_to_stretch(const PlanePiece& line, Vector2 point) {
  const double s = std::clamp(dot(point - line.start, line.along), 0.0, line.extent);
  return length(point - line.at(s));
}

double distance_between(const PlanePiece& a, const PlanePiece& b) {
  const double sine = cross(a.along, b.along);
  if (sine != 0.0) {
    const double s = cross(b.start - a.start, b.along) / sine, t = cross(b.start - a.start, a.along) / sine;
    if (s >= 0.0 && s <= a.extent && t >= 0.0 && t <= b.extent) return 0.0;
  }
  return std::min({distance_to_stretch(a, b.start), distance_to_stretch(a, b.end()),
                   distance_to_stretch(b, a.start), distance_to_stretch(b, a.end())});
}

/// True if two sections are part of one bend. The edges of a turn on the spot meet half a circle further on.
/// At a corner two lines are near to each other for any angle.
bool is_one_bend(const PlaneChain& chain, const Stretch& a, const Stretch& b, double half_width) {
  const double between = b.start - a.start - a.line.extent;
  const double least = std::numbers::pi * half_width;
  if (between <= least) return true;
  if (chain.closed && length_of(chain) - (b.start + b.line.extent - a.start) <= least) return true;
  if (!chain.pieces[a.piece].is_line() || !chain.pieces[b.piece].is_line()) return false;
  const bool around = chain.closed && a.piece == 0 && b.piece + 1 == chain.pieces.size();
  return b.piece <= a.piece + 1 || around;
}

void refuse_contact(const PlaneChain& chain, double half_width) {
  const std::vector<Stretch> stretches = stretches_of(chain, half_width);
  for (std::size_t i = 0; i < stretches.size(); ++i)
    for (std::size_t k = i + 1; k < stretches.size(); ++k) {
      const Stretch &a = stretches[i], &b = stretches[k];
      const double apart = distance_between(a.line, b.line);
      if (apart > 2.0 * half_width || is_one_bend(chain, a, b, half_width)) continue;
      throw ShapeError(fmt::format(
          "it touches itself: near {} it is {} from another part of its middle line; that must be more than "
          "its width of {} (a way that crosses itself is a union of corridors that do not, or layers of "
          "them)",
          shown(a.line.start), shown(apart), shown(2.0 * half_width)));
    }
}

/// Adds both edges of a piece of the centre line. An arc with a smaller radius than the half width has no
/// inner edge.
void add_edges(const PlanePiece& piece, double half_width, PlaneShape& edges) {
  for (const double side : {1.0, -1.0}) {
    PlanePiece edge = piece.with_side(side);
    if (piece.is_line()) edge.start = piece.start - (side * half_width) * turned_left(piece.along);
    if (!piece.is_line()) edge.radius = piece.radius + side * half_width;
    if (edge.is_line() == piece.is_line() && edge.radius >= 0.0) edges.push_back(edge);
  }
}

/// Adds the circle about a knot, cut where the edges of the adjacent pieces touch it.
void add_joint(Vector2 knot, const std::vector<Vector2>& directions, double half_width, PlaneShape& edges) {
  std::vector<double> angles;
  for (const Vector2 along : directions)
    for (const double side : {1.0, -1.0}) {
      const Vector2 normal = side * turned_left(along);
      angles.push_back(fn::atan2(normal.y, normal.x));
    }
  std::sort(angles.begin(), angles.end());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles.front() + 2.0 * std::numbers::pi;
    if (next > angles[i]) edges.push_back(arc_about(knot, half_width, angles[i], next - angles[i]));
  }
}

/// True for a bend so slight that the gap between the adjacent edges is negligible.
bool is_smooth(const std::vector<Vector2>& directions) {
  return directions.size() == 2 && std::abs(cross(directions[0], directions[1])) < 1e-4;
}

Vector2 direction_near(const PlanePiece& piece, Vector2 knot) {
  const bool at_start = length(piece.at(0.0) - knot) <= length(piece.end() - knot);
  return piece.direction(at_start ? 0.0 : piece.length());
}

PlaneShape edges_of(const PlaneChain& chain, double half_width) {
  PlaneShape edges;
  const std::size_t count = chain.pieces.size();
  for (const PlanePiece& piece : chain.pieces) add_edges(piece, half_width, edges);
  for (std::size_t i = 0; i <= count; ++i) {
    if (chain.closed && i == count) break;
    std::vector<Vector2> directions;
    if (i > 0 || chain.closed)
      directions.push_back(direction_near(chain.pieces[(i + count - 1) % count], chain.knots[i]));
    if (i < count) directions.push_back(direction_near(chain.pieces[i], chain.knots[i]));
    if (!is_smooth(directions)) add_joint(chain.knots[i], directions, half_width, edges);
  }
  return edges;
}

}  // namespace

PlaneShape corridor(const PlaneChain& chain, double half_width) {
  refuse_contact(chain, half_width);
  const PlaneShape edges = edges_of(chain, half_width);
  const BoundaryTable middle(chain.pieces);
  const double tolerance = fineness_of(edges);
  return kept_parts(edges, edges, 0.1 * tolerance, [&](const PlanePiece& part) {
    return middle.search().nearest(inner_point(part, 0.0)).distance > half_width - tolerance;
  });
}

}  // namespace stepwire
