#include "blocks/haptics/region/plane_chain.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stepwire {

std::string shown(double length) {
  return fmt::format("{:.6g} mm", 1e3 * length);
}

std::string shown(Vector2 point) {
  return fmt::format("({:.6g}, {:.6g}) mm", 1e3 * point.x, 1e3 * point.y);
}

namespace {

constexpr std::size_t max_pieces = 20000;

/// Fits arcs through three points of a curve each, in as many pieces as needed.
class ArcFit {
 public:
  ArcFit(const PlaneCurve& curve, double first, double last, double tolerance)
      : curve_(curve), tolerance_(tolerance), narrow_(1e-4 * std::abs(last - first)) {
    chain_.knots.push_back(at(first));
    add(first, last);
  }

  PlaneChain take() { return std::move(chain_); }

 private:
  static double middle(double first, double last) { return first + 0.5 * (last - first); }

  void add(double first, double last) {
    const PlanePiece piece = arc_through(at(first), at(middle(first, last)), at(last));
    if (fits(piece, first, last)) {
      if (std::abs(last - first) < narrow_) refuse_jump(first, last);
      return append(piece, last);
    }
    if (chain_.pieces.size() > max_pieces)
      throw ShapeError(
          fmt::format("it takes more than {} arcs to follow it; give a smoother one", max_pieces));
    add(first, middle(first, last));
    add(middle(first, last), last);
  }

  Vector2 at(double parameter) const {
    const Vector2 point = curve_(parameter);
    if (std::isfinite(point.x) && std::isfinite(point.y)) return point;
    throw ShapeError(fmt::format("it has no finite value at {}", shown(parameter)));
  }

  /// Beyond this radius the distance from the centre loses too many digits.
  static constexpr double largest_radius = 1e5;

  bool fits(const PlanePiece& piece, double first, double last) const {
    constexpr int samples = 16;
    if (piece.radius > largest_radius) return false;
    if (!(piece.extent > 0.0)) return true;
    for (int i = 1; i < samples; ++i)
      if (!(distance(piece, at(first + (last - first) * i / samples)) < tolerance_)) return false;
    return true;
  }

  static double distance(const PlanePiece& piece, Vector2 point) {
    if (piece.is_line()) return std::abs(cross(piece.along, point - piece.start));
    return std::abs(length(point - piece.centre) - piece.radius);
  }

  /// Throws if a curve jumps between two parameters. At a jump the points stay apart however close the
  /// parameters are, and a nearly horizontal line would fit.
  void refuse_jump(double first, double last) const {
    const double before = length(at(last) - at(first));
    for (int i = 0; i < 18; ++i) {
      const double half = middle(first, last);
      const bool in_first = length(at(half) - at(first)) > length(at(last) - at(half));
      (in_first ? last : first) = half;
    }
    if (before > 10.0 * tolerance_ && length(at(last) - at(first)) > 0.5 * before)
      throw ShapeError(fmt::format("it jumps near {}; it must be continuous", shown(at(first))));
  }

  void append(const PlanePiece& piece, double last) {
    if (!(piece.extent > 0.0)) return;
    chain_.pieces.push_back(piece);
    chain_.knots.push_back(at(last));
  }

  const PlaneCurve& curve_;
  double tolerance_, narrow_;
  PlaneChain chain_;
};

}  // namespace

PlaneChain chain_along(const PlaneCurve& curve, double first, double last, double tolerance) {
  return ArcFit(curve, first, last, tolerance).take();
}

PlaneChain chain_through(const std::vector<Vector2>& points, bool closed) {
  PlaneChain chain{{}, points, closed};
  if (closed) chain.knots.push_back(points.front());
  for (std::size_t i = 0; i + 1 < chain.knots.size(); ++i) {
    if (!(length(chain.knots[i + 1] - chain.knots[i]) > 0.0))
      throw ShapeError(
          fmt::format("two points that follow each other are both {}; leave one out", shown(chain.knots[i])));
    chain.pieces.push_back(line_between(chain.knots[i], chain.knots[i + 1]));
  }
  return chain;
}

namespace {

/// Equations for the derivatives at the knots of a cubic spline of continuous curvature: a tridiagonal
/// matrix, for a closed spline with two corner elements.
class SlopeEquations {
 public:
  explicit SlopeEquations(std::size_t count) : rows_(count, std::vector<double>(count, 0.0)), right_(count) {}

  /// Adds the contribution of an interval with derivative `slope` between its knots to the equation of the
  /// first knot.
  void add(std::size_t knot, std::size_t other, double width, Vector2 slope) {
    rows_[knot][knot] += 2.0 / width;
    rows_[knot][other] += 1.0 / width;
    right_[knot] = right_[knot] + (3.0 / width) * slope;
  }

  std::vector<Vector2> solve() && {
    for (std::size_t k = 0; k < rows_.size(); ++k)
      for (std::size_t i = k + 1; i < rows_.size(); ++i) eliminate(i, k);
    for (std::size_t k = rows_.size(); k-- > 0;) {
      for (std::size_t j = k + 1; j < rows_.size(); ++j) right_[k] = right_[k] - rows_[k][j] * right_[j];
      right_[k] = (1.0 / rows_[k][k]) * right_[k];
    }
    return std::move(right_);
  }

 private:
  /// Eliminates unknown k from row i. The matrix is diagonally dominant, so no pivoting is needed.
  void eliminate(std::size_t i, std::size_t k) {
    const double share = rows_[i][k] / rows_[k][k];
    if (share == 0.0) return;
    for (std::size_t j = k; j < rows_.size(); ++j) rows_[i][j] -= share * rows_[k][j];
    right_[i] = right_[i] - share * right_[k];
  }

  std::vector<std::vector<double>> rows_;
  std::vector<Vector2> right_;
};

std::vector<Vector2> spline_slopes(const std::vector<Vector2>& knots, const std::vector<double>& widths,
                                   bool closed) {
  const std::size_t n = closed ? widths.size() : knots.size();
  const auto rise = [&](std::size_t i) { return (1.0 / widths[i]) * (knots[i + 1] - knots[i]); };
  SlopeEquations equations(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool starts = !closed && i == 0, ends = !closed && i == n - 1;
    const std::size_t before = i == 0 ? widths.size() - 1 : i - 1;
    if (!starts) equations.add(i, before, widths[before], rise(before));
    if (!ends) equations.add(i, (i + 1) % n, widths[i], rise(i));
  }
  std::vector<Vector2> slopes = std::move(equations).solve();
  if (closed) slopes.push_back(slopes.front());
  return slopes;
}

/// Evaluates the cubic with these values and derivatives at the ends of an interval of this width.
Vector2 cubic(Vector2 a, Vector2 b, Vector2 slope_a, Vector2 slope_b, double width, double t) {
  const double u = 1.0 - t;
  return (u * u * (1.0 + 2.0 * t)) * a + (t * t * (1.0 + 2.0 * u)) * b +
         (width * t * u) * (u * slope_a - t * slope_b);
}

void append(PlaneChain& chain, PlaneChain more) {
  if (chain.knots.empty()) chain.knots.push_back(more.knots.front());
  chain.knots.insert(chain.knots.end(), more.knots.begin() + 1, more.knots.end());
  chain.pieces.insert(chain.pieces.end(), more.pieces.begin(), more.pieces.end());
}

}  // namespace

PlaneChain spline_through(const std::vector<Vector2>& points, bool closed, double tolerance) {
  const PlaneChain straight = chain_through(points, closed);
  const std::vector<Vector2>& knots = straight.knots;
  std::vector<double> widths;
  for (const PlanePiece& piece : straight.pieces) widths.push_back(piece.extent);
  const std::vector<Vector2> slopes = spline_slopes(knots, widths, closed);
  PlaneChain chain{{}, {}, closed};
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const auto curve = [&](double t) {
      return cubic(knots[i], knots[i + 1], slopes[i], slopes[i + 1], widths[i], t);
    };
    append(chain, chain_along(curve, 0.0, 1.0, tolerance));
  }
  return chain;
}

}  // namespace stepwire
