#include "blocks/haptics/region/plane_shape.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>

#include "engine/base/math/elementary.hpp"

namespace stepwire {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void append_numbers(const PlanePiece& piece, std::vector<double>& numbers) {
  if (piece.is_line()) {
    numbers.insert(numbers.end(), {0.0, piece.start.x, piece.start.y, piece.along.x, piece.along.y,
                                   piece.extent, piece.side});
    return;
  }
  const Vector2 middle = direction_at(piece.from + 0.5 * piece.extent);
  numbers.insert(numbers.end(), {piece.side * piece.radius, piece.centre.x, piece.centre.y, middle.x,
                                 middle.y, fn::cos(0.5 * piece.extent), fn::sin(0.5 * piece.extent)});
}

PlaneBox no_box() {
  return {{infinity, infinity}, {-infinity, -infinity}};
}

/// Returns the bounding box without infinite pieces.
PlaneBox finite_box(const PlaneShape& shape) {
  PlaneBox box = no_box();
  for (const PlanePiece& piece : shape)
    box = joined(box, std::isinf(piece.extent) ? PlaneBox{piece.start, piece.start} : box_of(piece));
  return box;
}

}  // namespace

namespace {

/// Start and end of a piece in the direction with the region on its left.
struct Way {
  explicit Way(const PlanePiece& piece) {
    const bool is_ray = std::isinf(piece.extent);
    const Vector2 far = is_ray ? Vector2{infinity, infinity} : piece.end();
    start = piece.side > 0.0 ? piece.at(0.0) : far;
    end = piece.side > 0.0 ? far : piece.at(0.0);
  }
  Vector2 start, end;
};

double distance_to(const PlanePiece& line, Vector2 point) {
  const double s = std::clamp(dot(point - line.start, line.along), 0.0, line.extent);
  return length(point - (line.start + s * line.along));
}

/// Returns an upper bound of the distance between a line and the points of a piece. The bound for an arc is
/// its height above its chord.
double farthest(const PlanePiece& line, const PlanePiece& piece) {
  if (std::isinf(piece.extent)) return infinity;
  const double at_ends = std::max(distance_to(line, piece.at(0.0)), distance_to(line, piece.end()));
  if (piece.is_line()) return at_ends;
  const double about_centre = distance_to(line, piece.centre) + piece.radius;
  if (piece.extent > std::numbers::pi) return about_centre;
  return std::min(about_centre, at_ends + piece.radius * (1.0 - fn::cos(0.5 * piece.extent)));
}

void append_sleeve(const PlaneShape& shape, std::size_t first, std::size_t last,
                   std::vector<double>& numbers) {
  last = std::min(last, shape.size());
  if (first >= last) {  // empty sleeve, never visited
    numbers.insert(numbers.end(), {0.0, 0.0, 0.0, 0.0, 0.0, -infinity});
    return;
  }
  const Vector2 start = Way(shape[first]).start, end = Way(shape[last - 1]).end;
  if (!std::isfinite(start.x) || !std::isfinite(end.x)) {  // infinite line: always visited
    numbers.insert(numbers.end(), {0.0, 0.0, 0.0, 0.0, 0.0, infinity});
    return;
  }
  PlanePiece line = line_between(start, end);
  if (!(line.extent > 0.0)) line.along = {0.0, 0.0};
  double radius = 0.0;
  for (std::size_t i = first; i < last; ++i) radius = std::max(radius, farthest(line, shape[i]));
  radius += 1e-9 * radius + 1e-15;  // margin for rounding
  numbers.insert(numbers.end(), {start.x, start.y, line.along.x, line.along.y, line.extent, radius});
}

}  // namespace

BoundaryTable::BoundaryTable(const PlaneShape& pieces_in_any_order)
    : tolerance(fineness_of(pieces_in_any_order)) {
  PlaneShape shape;  // ordered, so that neighbours share a tight sleeve
  for (const PlaneShape& loop : loops_of(pieces_in_any_order))
    shape.insert(shape.end(), loop.begin(), loop.end());
  for (const PlanePiece& piece : shape) append_numbers(piece, pieces);
  constexpr auto leaf = static_cast<std::size_t>(BoundarySearch::leaf_size);
  while (static_cast<std::size_t>(leaves) * leaf < shape.size()) leaves *= 2;
  for (Index row = 1; row <= leaves; row *= 2)
    for (Index node = 0; node < row; ++node) {
      const auto share = static_cast<std::size_t>(leaves / row) * leaf,
                 first = static_cast<std::size_t>(node) * share;
      append_sleeve(shape, first, first + share, sleeves);
    }
}

double fineness_of(const PlaneShape& shape) {
  return 1e-10 * finite_box(shape).diagonal();
}

PlaneShape disk(Vector2 centre, double radius, double inner_radius) {
  constexpr double turn = 2.0 * std::numbers::pi;
  PlaneShape shape{arc_about(centre, radius, 0.0, turn)};
  if (inner_radius > 0.0) shape.push_back(arc_about(centre, inner_radius, 0.0, turn).with_side(-1.0));
  return shape;
}

Vector2 inner_point(const PlanePiece& piece, double reach) {
  return piece.at(std::isinf(piece.extent) ? reach : 0.5 * piece.length());
}

namespace {

/// Finds pieces whose boxes may meet a given box, sorted by their left ends.
class Neighbours {
 public:
  explicit Neighbours(const PlaneShape& pieces) : pieces_(pieces), order_(pieces.size()) {
    for (const PlanePiece& piece : pieces) boxes_.push_back(box_of(piece));
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(),
              [&](auto a, auto b) { return boxes_[a].low.x < boxes_[b].low.x; });
    for (const PlaneBox& box : boxes_) widest_ = std::max(widest_, box.high.x - box.low.x);
  }

  template <class Function>
  void each(const PlaneBox& box, double margin, const Function& call) const {
    const double from = box.low.x - widest_ - margin;
    auto at = std::lower_bound(order_.begin(), order_.end(), from,
                               [&](std::size_t i, double x) { return boxes_[i].low.x < x; });
    for (; at != order_.end() && boxes_[*at].low.x <= box.high.x + margin; ++at)
      if (boxes_[*at].meets(box, margin)) call(pieces_[*at]);
  }

 private:
  const PlaneShape& pieces_;
  std::vector<PlaneBox> boxes_;
  std::vector<std::size_t> order_;
  double widest_ = 0.0;
};

/// Returns the places along a piece, sorted, with both ends, without those close to their predecessor.
std::vector<double> apart(const PlanePiece& piece, std::vector<double> places, double tolerance) {
  std::sort(places.begin(), places.end());
  std::vector<double> result{0.0};
  for (const double place : places)
    if (place > result.back() + 2.0 * tolerance && place < piece.length() - 2.0 * tolerance)
      result.push_back(place);
  result.push_back(piece.length());
  return result;
}

/// Appends the kept parts of a piece; adjacent ones are merged.
void append_kept(const PlanePiece& piece, const std::vector<double>& places, const IsKept& is_kept,
                 PlaneShape& result) {
  double first = 0.0;
  bool open = false;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const bool keep = is_kept(piece.part(places[i], places[i + 1]));
    if (open && !keep) result.push_back(piece.part(first, places[i]));
    if (!open) first = places[i];
    open = keep;
  }
  if (open) result.push_back(piece.part(first, piece.length()));
}

}  // namespace

PlaneShape kept_parts(const PlaneShape& pieces, const PlaneShape& others, double tolerance,
                      const IsKept& is_kept) {
  const Neighbours neighbours(others);
  PlaneShape result;
  for (const PlanePiece& piece : pieces) {
    std::vector<double> places;
    neighbours.each(box_of(piece), tolerance, [&](const PlanePiece& other) {
      for (const double place : crossings(piece, other, tolerance)) places.push_back(place);
    });
    append_kept(piece, apart(piece, places, tolerance), is_kept, result);
  }
  return result;
}

namespace {

/// Returns the smallest index.
std::size_t smallest(const std::multimap<double, std::size_t>& left) {
  std::size_t least = left.begin()->second;
  for (const auto& [x, i] : left) least = std::min(least, i);
  return least;
}

/// Returns the unused piece whose start is nearest to a point, within a distance; the number of ways without
/// one.
std::size_t next_after(Vector2 point, const std::vector<Way>& ways,
                       const std::multimap<double, std::size_t>& left, double within) {
  std::size_t best = ways.size();
  for (auto at = left.lower_bound(point.x - within); at != left.end() && at->first <= point.x + within;
       ++at) {
    const double gap = length(ways[at->second].start - point);
    if (gap > within) continue;
    within = gap;
    best = at->second;
  }
  return best;
}

}  // namespace

std::vector<PlaneShape> loops_of(const PlaneShape& shape) {
  const double within = 1e6 * fineness_of(shape);  // beside a slight bend edges have a gap
  std::vector<Way> ways(shape.begin(), shape.end());
  std::multimap<double, std::size_t> left;  // by their start
  for (std::size_t i = 0; i < ways.size(); ++i) left.emplace(ways[i].start.x, i);
  const auto take = [&](std::size_t i) {
    const auto [first, last] = left.equal_range(ways[i].start.x);
    left.erase(std::find_if(first, last, [&](const auto& entry) { return entry.second == i; }));
  };
  std::vector<PlaneShape> loops;
  while (!left.empty()) {
    // An infinite piece without a predecessor is the first of its loop.
    std::size_t i = std::isinf(left.rbegin()->first) ? left.rbegin()->second : smallest(left);
    loops.emplace_back();
    for (; i < ways.size(); i = next_after(ways[i].end, ways, left, within)) {
      take(i);
      loops.back().push_back(shape[i]);
      if (std::isinf(ways[i].end.x)) break;
    }
  }
  return loops;
}

namespace {

/// True if a piece of shape `own` is part of the boundary of the union. It is not if it is inside of another
/// shape. Where two boundaries coincide, one of them is kept, or none if the shapes are on opposite sides.
bool bounds_all(const PlanePiece& piece, std::size_t own, const std::vector<BoundaryTable>& tables,
                double reach, double tolerance) {
  const Vector2 point = inner_point(piece, reach);
  const double s = piece.is_line() ? 0.0 : 0.5 * piece.length();
  const Vector2 outward = -piece.side * turned_left(piece.direction(s));
  for (std::size_t i = 0; i < tables.size(); ++i) {
    if (i == own) continue;
    const BoundaryPoint near = tables[i].search().nearest(point);
    if (near.distance > tolerance && near.facing > 0.0) continue;
    if (near.distance > tolerance) return false;
    if (i < own || dot(near.normal, outward) < 0.0) return false;
  }
  return true;
}

}  // namespace

PlaneShape united(const std::vector<PlaneShape>& shapes) {
  PlaneShape all;
  std::vector<BoundaryTable> tables;
  for (const PlaneShape& shape : shapes) {
    all.insert(all.end(), shape.begin(), shape.end());
    tables.emplace_back(shape);
  }
  const double reach = finite_box(all).diagonal(), tolerance = 10.0 * fineness_of(all);
  PlaneShape result;
  for (std::size_t own = 0; own < shapes.size(); ++own) {
    const auto is_kept = [&](const PlanePiece& part) {
      return bounds_all(part, own, tables, reach, tolerance);
    };
    const PlaneShape kept = kept_parts(shapes[own], all, 0.1 * tolerance, is_kept);
    result.insert(result.end(), kept.begin(), kept.end());
  }
  return result;
}

}  // namespace stepwire
