#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "engine/analyse/statistics/observations.hpp"
#include "engine/analyse/statistics/return_path.hpp"
#include "engine/analyse/study/trials.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::study {

/// Error of the path of one trial.
struct PathError {
  std::string subject, condition;
  double error = 0.0;       ///< Error of the thesis, in the unit of the table.
  double normalised = 0.0;  ///< Error over the largest one of the table.
  double raw = 0.0;         ///< Error before resampling, in the same unit.
  /// Error that does not depend on sampling and length. Of a circle: root mean square of the radial
  /// deviations [m]. Of a way back: mean angle, the error over the length of the resampled path [rad].
  double deviation = 0.0;
  double length = 0.0;  ///< Length of the scored path, as recorded [m].
  double duration =
      0.0;  ///< Duration of the scored path; that of a way back up to its first point inside [s].
  std::size_t points = 0;  ///< Number of scored points.
};

/// Path errors of one task, with the method of scoring. The name of the task is free.
struct PathErrors {
  std::string task;
  std::string unit;            ///< Unit of error and raw: "m^2", "m".
  std::string deviation_unit;  ///< Unit of the deviation: "m", "rad".
  std::string rule;            ///< Description of the scoring.
  std::vector<PathError> rows;
  std::map<std::string, statistics::Circle> circles;  ///< Circle by subject [m]; empty for a way back.
  std::vector<std::string> warnings;                  ///< Trials that lasted longer than the thesis allows.

  std::vector<std::string> conditions() const;  ///< Returns the conditions in order of first occurrence.
};

/// Drawing of a circle (thesis, section 4.3.1): each drawing is compared with the circle fitted to the same
/// subject's drawing under one condition.
struct CircleTask {
  std::string task;
  std::string of;  ///< Condition of the drawing to which the circle is fitted.
  statistics::CircleFit fit = statistics::CircleFit::geometric;
  double time_limit = 75.0;  ///< In s; a longer trial is scored with a warning. The thesis repeats it.
};

/// Scores drawings. Throws StatisticsError, with the trial's name, for a subject without that drawing and for
/// the faults of fit_circle. It also throws without any trial of the task.
PathErrors circle_errors(const std::vector<Trial>& trials, const CircleTask& task);

/// Return to a region (thesis, section 4.3.2): equations 17 to 25.
struct ReturnTask {
  std::string task;
  statistics::Resampling resampling{};
  double time_limit = 20.0;  ///< In s, as of a CircleTask.
};

/// Scores returns. Throws StatisticsError, with the trial's name, for the faults of return_error, and if
/// there are no trials of the task.
PathErrors return_errors(const std::vector<Trial>& trials, const statistics::WayBack& way_back,
                         const ReturnTask& task);

/// Returns the errors as a table: subject, condition, error, normalised, raw, deviation, length [mm],
/// duration [s], points. Adds the names of subjects and conditions to `words`.
table::Table error_table(const PathErrors& errors, table::ColumnWords& words);

/// Columns of a drawing: the circle of the trial.
inline constexpr std::array circle_columns{"circle.x", "circle.y", "circle.radius"};

/// Returns the errors in SI for figures and claims: one row per trial, `time` is the trial's number. Drawings
/// also have the circle.
record::Recording error_recording(const PathErrors& errors);

/// A condition and the factors that it names, true where the factor is present. A factor that it does not
/// name is absent.
struct Condition {
  std::string name;
  std::vector<std::pair<std::string, bool>> factors;

  bool has(const std::string& factor) const;
};

/// Returns the factors that are present in some conditions and absent in others, in the order in which the
/// conditions name them.
std::vector<std::string> factors_of(const std::vector<Condition>& conditions);

/// Returns the normalised errors with the factors in which they differ (levels "absent" and "present"),
/// condition and subject. Throws StatisticsError for an unknown condition.
statistics::Observations observations(const PathErrors& errors, const std::vector<Condition>& conditions);

}  // namespace stepwire::study
