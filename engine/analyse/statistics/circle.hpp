#pragma once

#include <Eigen/Core>

namespace stepwire::statistics {

/// Points of a plane, one in each column, in one unit of length.
using PlanePoints = Eigen::Matrix2Xd;

/// A circle in the plane, in the unit of the fitted points.
struct Circle {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0.0;
};

/// Objective of a circle fit; r_i is the distance of a point from the centre, R the radius.
enum class CircleFit {
  geometric,  ///< Sum of (r_i - R)^2, by the Levenberg-Marquardt method, started from taubin.
  kasa,       ///< Sum of (r_i^2 - R^2)^2 (Kasa 1976); R is too small on a short arc.
  pratt,      ///< Objective of kasa over (2 R)^2 (Pratt 1987).
  taubin      ///< Objective of kasa over the mean of (2 r_i)^2 (Taubin 1991).
};

/// Returns the best-fitting circle. Throws StatisticsError for fewer than three points, for coordinates that
/// are not finite, and for collinear points. Points count as collinear if the radius would exceed 100000
/// times their spread.
Circle fit_circle(const PlanePoints& points, CircleFit fit = CircleFit::geometric);

/// Returns the sum of (r_i - R)^2 over all points, in the square of the points' unit. It is the path error of
/// task 1 (section 4.3.1) before normalisation.
double squared_deviations(const PlanePoints& points, const Circle& circle);

}  // namespace stepwire::statistics
