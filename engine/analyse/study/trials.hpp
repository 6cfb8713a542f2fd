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

/// Reads trials from a CSV file with the columns subject, task and condition (words), time, x and y in any
/// units of time and length: "time [s],x [mm],y [mm]". The rows of one trial are consecutive. Throws
/// TableError with file and line for the faults of read_csv, for a missing column or unsuitable unit, and for
/// an empty word or a non-finite number. It also throws for a time that does not rise within its trial, for a
/// trial of fewer than two rows, and for a second trial of the same subject, task and condition.
std::vector<Trial> read_trials(const std::string& path);

/// Returns the text of such a file: time [s], x [mm], y [mm], then columns with one value per trial.
std::string trials_csv(const std::vector<Trial>& trials, const std::vector<table::Column>& of_trials = {});

}  // namespace stepwire::study
