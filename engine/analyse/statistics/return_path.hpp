#pragma once

#include <functional>

#include "engine/analyse/statistics/circle.hpp"

namespace stepwire::statistics {

/// How a recorded path is resampled before it is scored. Every new point lies on the line through the
/// recorded ones; the first and the last stay.
struct Resampling {
  /// - arc_length: equal lengths along the recorded line, at most `spacing` each. A hand that rests with a
  ///   noisy sensor still travels along this line.
  /// - chord: the next point is the first one of the line that lies `spacing` away from the last one, as
  ///   dividers walk; noise smaller than that counts nothing.
  enum class Rule { arc_length, chord };

  Rule rule = Rule::arc_length;
  double spacing = 2e-3;  ///< [m], or the unit of the points; above 0
};

/// The resampled path. Throws StatisticsError for fewer than two points, for what is not finite, and for a
/// spacing that is not above 0.
PlanePoints resampled(const PlanePoints& path, const Resampling& resampling);

/// Length of the line through the points.
double path_length(const PlanePoints& path);

/// The way back at a point: the direction of the greatest resisting force (F_max, toward the region) outside,
/// zero inside. Its length counts nothing.
using WayBack = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

/// Equation 25: e = sum of d_i theta_i over the steps of a path as it is, with d_i = |p_(i+1) - p_i|
/// (equations 19 to 21) and theta_i the angle between the step and the way back at p_i (equation 24). Steps
/// of no length count nothing, and so do steps from points inside. [unit of the points times rad]
double angular_error(const PlanePoints& path, const WayBack& way_back);

/// The path error of one trial of task 2.
struct ReturnError {
  double error = 0.0;           ///< of the resampled path [unit of the points times rad]
  double raw = 0.0;             ///< of the recorded points
  double length = 0.0;          ///< of the recorded path up to its first point inside
  Eigen::Index points = 0;      ///< of the resampled path
  Eigen::Index raw_points = 0;  ///< of the recorded path, from its start to its first point inside
};

/// Scores the history p_1 .. p_N of equation 17: from the start, which is outside, to the first point inside;
/// what comes behind it is left out. Throws StatisticsError where the path starts inside or never gets there,
/// besides what `resampled` throws.
ReturnError return_error(const PlanePoints& path, const WayBack& way_back, const Resampling& resampling = {});

}  // namespace stepwire::statistics
