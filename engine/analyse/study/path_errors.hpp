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

/// How well one trial followed its path.
struct PathError {
  std::string subject, condition;
  double error = 0.0;       ///< as the thesis scores it, in the unit of the table
  double normalised = 0.0;  ///< over the largest of the table
  double raw = 0.0;         ///< before resampling, in the same unit
  /// What sampling and length do not change: task 1, root mean square of the radial deviations [m]; task 2,
  /// mean angle, which is the error over the length of the resampled path [rad].
  double deviation = 0.0;
  double length = 0.0;     ///< of the path that is scored, as it was recorded [m]
  double duration = 0.0;   ///< of the path that is scored: in task 2 up to its first point inside [s]
  std::size_t points = 0;  ///< that are scored
};

/// The path errors of one task, with how they were made.
struct PathErrors {
  std::string task;
  std::string unit;            ///< of error and raw: "m^2", "m"
  std::string deviation_unit;  ///< "m", "rad"
  std::string rule;            ///< in words
  std::vector<PathError> rows;
  std::map<std::string, statistics::Circle> circles;  ///< of task 1, by subject [m]
  std::vector<std::string> warnings;                  ///< trials that lasted longer than the thesis allows

  std::vector<std::string> conditions() const;  ///< in the order in which they come up
};

/// Task 1 of section 4.3.1: every drawing against the circle fitted to the same subject's drawing without
/// feedback.
struct CircleTask {
  std::string task = "1";
  std::string without_feedback = "NO";  ///< the condition that the circle is fitted to
  statistics::CircleFit fit = statistics::CircleFit::geometric;
  double time_limit = 75.0;  ///< [s]; a longer trial was to be repeated: it is scored, with a warning
};

/// Throws StatisticsError, with the trial in front, for a subject without that drawing, for what fit_circle
/// refuses, and where there are no trials of the task.
PathErrors circle_errors(const std::vector<Trial>& trials, const CircleTask& task = {});

/// Task 2 of section 4.3.2: equations 17 to 25.
struct ReturnTask {
  std::string task = "2";
  statistics::Resampling resampling{};
  double time_limit = 20.0;  ///< [s], as in task 1
};

/// Throws StatisticsError, with the trial in front, for what return_error refuses, and where there are no
/// trials of the task.
PathErrors return_errors(const std::vector<Trial>& trials, const statistics::WayBack& way_back,
                         const ReturnTask& task = {});

/// The table that is written: subject, condition, error, normalised, raw, deviation, length [mm],
/// duration [s], points. `words` takes the names of subjects and conditions.
table::Table error_table(const PathErrors& errors, table::ColumnWords& words);

/// Of task 1: the circle that a trial is held against.
inline constexpr std::array circle_columns{"circle.x", "circle.y", "circle.radius"};

/// The same in SI as figures and claims read it: one row for each trial, `time` counting the trials; in task
/// 1 with the circle.
record::Recording error_recording(const PathErrors& errors);

/// What feedback a condition gives.
struct FeedbackCondition {
  std::string name;
  bool haptic = false, visual = false, guiding_path = false;
};

/// NO, H, V, HV, V_gp and HV_gp.
const std::vector<FeedbackCondition>& thesis_conditions();

/// The normalised errors with the factors haptic, visual, guiding path (where it varies; all "absent" or
/// "present"), condition and subject. Throws StatisticsError for a condition that is not among these.
statistics::Observations observations(const PathErrors& errors,
                                      const std::vector<FeedbackCondition>& conditions = thesis_conditions());

}  // namespace stepwire::study
