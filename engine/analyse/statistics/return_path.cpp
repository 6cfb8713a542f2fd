#include "engine/analyse/statistics/return_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/analyse/statistics/statistics_error.hpp"

namespace stepwire::statistics {
namespace {

void check(const PlanePoints& path, double spacing) {
  if (path.cols() < 2)
    throw StatisticsError(fmt::format("a path needs two points or more; there are {}", path.cols()));
  if (!path.allFinite()) throw StatisticsError("a coordinate of the path is no finite number");
  if (!(spacing > 0.0)) throw StatisticsError(fmt::format("a spacing is above 0, not {}", spacing));
}

PlanePoints as_points(const std::vector<Eigen::Vector2d>& list) {
  PlanePoints points(2, static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = list[i];
  return points;
}

PlanePoints by_arc_length(const PlanePoints& path, double spacing) {
  const double length = path_length(path);
  const auto steps = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(std::ceil(length / spacing - 1e-9)));
  PlanePoints points(2, steps + 1);
  points.col(0) = path.col(0);
  Eigen::Index segment = 0;
  double before = 0.0;  // length up to the segment
  for (Eigen::Index i = 1; i < steps; ++i) {
    const double at = length * static_cast<double>(i) / static_cast<double>(steps);
    double size = (path.col(segment + 1) - path.col(segment)).norm();
    while (before + size < at && segment + 2 < path.cols()) {
      before += size;
      ++segment;
      size = (path.col(segment + 1) - path.col(segment)).norm();
    }
    const double part = size > 0.0 ? std::min(1.0, (at - before) / size) : 0.0;
    points.col(i) = path.col(segment) + part * (path.col(segment + 1) - path.col(segment));
  }
  points.col(steps) = path.col(path.cols() - 1);
  return points;
}

/// Returns the point between `a` and `b` at the distance `spacing` from `last`; `a` is nearer, `b` is
/// farther.
Eigen::Vector2d crossing(const Eigen::Vector2d& last, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         double spacing) {
  const Eigen::Vector2d along = b - a, from = a - last;
  const double square = along.squaredNorm(), half = along.dot(from);
  const double rest = from.squaredNorm() - spacing * spacing;
  return a + (-half + std::sqrt(std::max(0.0, half * half - square * rest))) / square * along;
}

PlanePoints by_chord(const PlanePoints& path, double spacing) {
  std::vector<Eigen::Vector2d> points{path.col(0)};
  Eigen::Vector2d at = path.col(0);
  for (Eigen::Index i = 1; i < path.cols(); ++i) {
    const Eigen::Vector2d end = path.col(i);
    while ((end - points.back()).norm() > spacing) {
      at = crossing(points.back(), at, end, spacing);
      points.push_back(at);
    }
    at = end;
  }
  if (const Eigen::Vector2d last = path.col(path.cols() - 1); points.size() == 1 || points.back() != last)
    points.push_back(last);
  return as_points(points);
}

double angle_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  // Equals the arc cosine of equation 24, which loses half of the digits near 0.
  return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
}

bool is_inside(const Eigen::Vector2d& point, const WayBack& way_back) {
  return way_back(point).isZero(0.0);
}

/// Returns the path up to its first point inside.
PlanePoints history(const PlanePoints& path, const WayBack& way_back) {
  if (is_inside(path.col(0), way_back)) throw StatisticsError("the path starts inside the region");
  for (Eigen::Index i = 1; i < path.cols(); ++i)
    if (is_inside(path.col(i), way_back)) return path.leftCols(i + 1);
  throw StatisticsError("the path never gets into the region");
}

/// Returns the error of equation 25 for a path without resampling: e = sum of d_i theta_i over its steps.
/// Length of a step: d_i = |p_(i+1) - p_i| (equations 19 to 21). Theta_i is the angle between the step and
/// the way back at p_i (equation 24). Steps of no length and steps from points inside add 0. The unit is that
/// of the points times rad.
double angular_error(const PlanePoints& path, const WayBack& way_back) {
  double error = 0.0;
  for (Eigen::Index i = 0; i + 1 < path.cols(); ++i) {
    const Eigen::Vector2d step = path.col(i + 1) - path.col(i), back = way_back(path.col(i));
    if (!back.isZero(0.0)) error += step.norm() * angle_between(step, back);
  }
  return error;
}

}  // namespace

double path_length(const PlanePoints& path) {
  double length = 0.0;
  for (Eigen::Index i = 0; i + 1 < path.cols(); ++i) length += (path.col(i + 1) - path.col(i)).norm();
  return length;
}

PlanePoints resampled(const PlanePoints& path, const Resampling& resampling) {
  check(path, resampling.spacing);
  return resampling.rule == Resampling::Rule::arc_length ? by_arc_length(path, resampling.spacing)
                                                         : by_chord(path, resampling.spacing);
}

ReturnError return_error(const PlanePoints& path, const WayBack& way_back, const Resampling& resampling) {
  check(path, resampling.spacing);
  const PlanePoints recorded = history(path, way_back);
  const PlanePoints points = resampled(recorded, resampling);
  return {angular_error(points, way_back), angular_error(recorded, way_back), path_length(recorded),
          points.cols(), recorded.cols()};
}

}  // namespace stepwire::statistics
