#include "blocks/haptics/region/plane_piece.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "engine/base/math/elementary.hpp"

namespace stepwire {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// Returns the angle in [0, 2 pi).
double positive(double angle) {
  const double rest = std::fmod(angle, turn);
  return rest < 0.0 ? rest + turn : rest;
}

}  // namespace

Vector2 PlanePiece::at(double s) const {
  return is_line() ? start + s * along : centre + radius * direction_at(from + s / radius);
}

Vector2 PlanePiece::direction(double s) const {
  return is_line() ? along : turned_left(direction_at(from + s / radius));
}

PlanePiece PlanePiece::part(double first, double last) const {
  PlanePiece result = *this;
  if (is_line()) result.start = at(first);
  if (!is_line()) result.from = from + first / radius;
  result.extent = is_line() ? last - first : (last - first) / radius;
  return result;
}

PlanePiece PlanePiece::with_side(double new_side) const {
  PlanePiece result = *this;
  result.side = new_side;
  return result;
}

bool PlaneBox::meets(const PlaneBox& other, double margin) const {
  return low.x <= other.high.x + margin && other.low.x <= high.x + margin && low.y <= other.high.y + margin &&
         other.low.y <= high.y + margin;
}

PlanePiece line_between(Vector2 a, Vector2 b) {
  PlanePiece piece;
  piece.extent = length(b - a);
  piece.start = a;
  piece.along = (1.0 / piece.extent) * (b - a);
  return piece;
}

PlanePiece ray_from(Vector2 start, Vector2 along) {
  PlanePiece piece;
  piece.start = start;
  piece.along = along;
  piece.extent = std::numeric_limits<double>::infinity();
  return piece;
}

PlanePiece arc_about(Vector2 centre, double radius, double from, double extent) {
  PlanePiece piece;
  piece.radius = radius;
  piece.centre = centre;
  piece.from = from;
  piece.extent = extent;
  return piece;
}

PlanePiece arc_through(Vector2 a, Vector2 b, Vector2 c) {
  // Height above its chord below which an arc is replaced by a line, far below the promised tolerance.
  constexpr double flat = 2e-11;
  const Vector2 chord = c - a, to_b = b - a;
  const double twice_area = cross(chord, to_b);
  if (std::abs(twice_area) <= flat * length(chord)) return line_between(a, c);
  const double square = dot(chord, chord), b_square = dot(to_b, to_b);
  const Vector2 to_centre = (1.0 / (2.0 * twice_area)) * turned_left(b_square * chord - square * to_b);
  const Vector2 centre = a + to_centre;
  const bool left = twice_area < 0.0;  // b is to the right of the chord: the arc turns left
  const Vector2 first = left ? a - centre : c - centre, last = left ? c - centre : a - centre;
  const double from = fn::atan2(first.y, first.x);
  const double extent = positive(fn::atan2(cross(first, last), dot(first, last)));
  return arc_about(centre, length(to_centre), from, extent).with_side(left ? 1.0 : -1.0);
}

PlaneBox joined(const PlaneBox& a, const PlaneBox& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

namespace {

/// Returns the end of an infinite line: infinite in each coordinate with a component of its direction.
Vector2 far_end(const PlanePiece& ray) {
  const auto far = [&](double start, double along) { return along == 0.0 ? start : along * ray.extent; };
  return {far(ray.start.x, ray.along.x), far(ray.start.y, ray.along.y)};
}

PlaneBox box_between(Vector2 a, Vector2 b) {
  return joined({a, a}, {b, b});
}

}  // namespace

PlaneBox box_of(const PlanePiece& piece) {
  if (piece.is_line())
    return box_between(piece.start, std::isinf(piece.extent) ? far_end(piece) : piece.end());
  PlaneBox box = box_between(piece.at(0.0), piece.end());
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double angle = quarter * 0.25 * turn;
    if (positive(angle - piece.from) > piece.extent) continue;
    const Vector2 extreme = piece.centre + piece.radius * direction_at(angle);
    box = joined(box, {extreme, extreme});
  }
  return box;
}

namespace {

/// Collects the places on `piece` of points that are on it.
class Places {
 public:
  Places(const PlanePiece& piece, double tolerance) : piece_(piece), tolerance_(tolerance) {}

  void add(Vector2 point) {
    double s = piece_.is_line() ? dot(point - piece_.start, piece_.along) : on_arc(point);
    if (s < -tolerance_ || s > piece_.length() + tolerance_) return;
    if (length(piece_.at(s) - point) <= 2.0 * tolerance_) found_.push_back(s);
  }
  std::vector<double> take() { return std::move(found_); }

 private:
  double on_arc(Vector2 point) const {
    const Vector2 arm = point - piece_.centre;
    double angle = positive(fn::atan2(arm.y, arm.x) - piece_.from);
    if (angle > piece_.extent + 0.5 * (turn - piece_.extent)) angle -= turn;  // just before its start
    return piece_.radius * angle;
  }

  const PlanePiece& piece_;
  double tolerance_;
  std::vector<double> found_;
};

using Points = std::vector<Vector2>;

Points line_and_line(const PlanePiece& a, const PlanePiece& b) {
  const double sine = cross(a.along, b.along);
  if (std::abs(sine) < 1e-12) return {};
  return {a.start + (cross(b.start - a.start, b.along) / sine) * a.along};
}

/// Returns the intersections; places on the line are relative to its point nearest to the centre.
Points line_and_circle(const PlanePiece& line, const PlanePiece& arc, double tolerance) {
  const double foot = dot(arc.centre - line.start, line.along);
  const Vector2 nearest = line.start + foot * line.along;
  const double away = length(nearest - arc.centre);
  if (away > arc.radius + tolerance) return {};
  const double half = std::sqrt(std::max(0.0, (arc.radius - away) * (arc.radius + away)));
  return {nearest - half * line.along, nearest + half * line.along};
}

Points circle_and_circle(const PlanePiece& a, const PlanePiece& b, double tolerance) {
  const Vector2 way = b.centre - a.centre;
  const double between = length(way);
  if (between <= tolerance || between > a.radius + b.radius + tolerance ||
      between < std::abs(a.radius - b.radius) - tolerance)
    return {};
  const double along = 0.5 * (between + (a.radius - b.radius) * (a.radius + b.radius) / between);
  const double half = std::sqrt(std::max(0.0, (a.radius - along) * (a.radius + along)));
  const Vector2 u = (1.0 / between) * way, foot = a.centre + along * u;
  return {foot + half * turned_left(u), foot - half * turned_left(u)};
}

Points common_points(const PlanePiece& a, const PlanePiece& b, double tolerance) {
  if (a.is_line() && b.is_line()) return line_and_line(a, b);
  if (a.is_line()) return line_and_circle(a, b, tolerance);
  if (b.is_line()) return line_and_circle(b, a, tolerance);
  return circle_and_circle(a, b, tolerance);
}

}  // namespace

std::vector<double> crossings(const PlanePiece& piece, const PlanePiece& other, double tolerance) {
  Places on_piece(piece, tolerance), on_other(other, tolerance);
  for (const Vector2 point : common_points(piece, other, tolerance)) {
    Places here(other, tolerance);
    here.add(point);
    if (!here.take().empty()) on_piece.add(point);
  }
  // Adds the ends of the other piece that are on this one: ends of a common section, and points of contact.
  on_piece.add(other.at(0.0));
  if (std::isfinite(other.length())) on_piece.add(other.end());
  return on_piece.take();
}

}  // namespace stepwire
