#pragma once

#include <Eigen/Core>

namespace stepwire::statistics {

/// Points of a plane, one in each column, in one unit of length.
using PlanePoints = Eigen::Matrix2Xd;

/// A circle in the plane, in the unit of the points that it was fitted to.
struct Circle {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0.0;
};

/// What a fit makes as small as it can, with r_i the distance of a point from the centre:
/// - geometric: sum of (r_i - R)^2, the distances themselves (Levenberg-Marquardt, started from taubin);
/// - kasa: sum of (r_i^2 - R^2)^2 (Kasa 1976); too small on a short arc;
/// - pratt: the same over (2 R)^2 (Pratt 1987);
/// - taubin: the same over the mean of (2 r_i)^2 (Taubin 1991).
enum class CircleFit { geometric, kasa, pratt, taubin };

/// The circle that fits points best. Throws StatisticsError for fewer than three points, for coordinates that
/// are not finite, and for points on a line, or so near to one
/// that the circle would be 100000 times as large as their spread.
Circle fit_circle(const PlanePoints& points, CircleFit fit = CircleFit::geometric);

/// Sum of (r_i - R)^2 over all points: the path error of task 1 (section 4.3.1) before it is normalised, in
/// the square of the points' unit.
double squared_deviations(const PlanePoints& points, const Circle& circle);

}  // namespace stepwire::statistics
