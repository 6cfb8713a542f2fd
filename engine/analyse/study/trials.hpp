#pragma once

#include <string>
#include <vector>

#include "engine/analyse/statistics/circle.hpp"
#include "engine/base/table/table.hpp"

namespace stepwire::study {

/// One drawing of one person under one condition, simulated or recorded.
struct Trial {
  std::string subject, task, condition;
  std::vector<double> time;        ///< In s, rising.
  statistics::PlanePoints points;  ///< Positions of the end-effector [m], one per time.
};

/// Reads trials from a CSV file with the columns subject, task and condition (words), time, x and y. Time and
/// length have any units: "time [s],x [mm],y [mm]". The rows of one trial are consecutive. Throws TableError
/// with file and line for the faults of read_csv, a missing column or an unsuitable unit. The same holds for
/// an empty word, a non-finite number, or a time that does not rise within its trial. A trial needs two rows
/// or more, and may not occur twice.
std::vector<Trial> read_trials(const std::string& path);

/// Returns the text of such a file: time [s], x [mm], y [mm], then columns with one value per trial.
std::string trials_csv(const std::vector<Trial>& trials, const std::vector<table::Column>& of_trials = {});

}  // namespace stepwire::study
