#pragma once

#include <functional>

#include "engine/analyse/statistics/circle.hpp"

namespace stepwire::statistics {

/// Resampling of a recorded path before it is scored. New points are on the line through the recorded ones;
/// the first and the last point remain.
struct Resampling {
  enum class Rule {
    /// Equal lengths along the recorded line, at most `spacing` each. A resting hand with a noisy sensor
    /// still
    /// travels along this line.
    arc_length,
    /// The next point is the first one of the line at the distance `spacing` from the last one, as with
    /// dividers. Noise below that distance has no effect.
    chord
  };

  Rule rule = Rule::arc_length;
  double spacing = 2e-3;  ///< [m], or the unit of the points; above 0.
};

/// Returns the resampled path. Throws StatisticsError for fewer than two points, for non-finite coordinates,
/// and for a spacing that is not above 0.
PlanePoints resampled(const PlanePoints& path, const Resampling& resampling);

/// Returns the length of the line through the points.
double path_length(const PlanePoints& path);

/// Returns the way back at a point: outside of the region the direction of the greatest resisting force
/// (F_max, toward the region), inside zero. Its length is not used.
using WayBack = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

/// The path error of one trial of task 2.
struct ReturnError {
  double error = 0.0;       ///< Error of the resampled path [unit of the points times rad].
  double raw = 0.0;         ///< Error of the recorded points.
  double length = 0.0;      ///< Length of the recorded path up to its first point inside.
  Eigen::Index points = 0;  ///< Number of points of the resampled path.
  Eigen::Index raw_points =
      0;  ///< Number of points of the recorded path, from its start to its first point inside.
};

/// Scores the history p_1 .. p_N of equation 17, from the start outside to the first point inside; later
/// points are ignored. Throws StatisticsError if the path starts inside or never enters the region, and for
/// the faults of `resampled`.
ReturnError return_error(const PlanePoints& path, const WayBack& way_back, const Resampling& resampling = {});

}  // namespace stepwire::statistics
