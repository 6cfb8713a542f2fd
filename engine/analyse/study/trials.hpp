#pragma once

#include <string>
#include <vector>

#include "engine/analyse/statistics/circle.hpp"
#include "engine/base/table/table.hpp"

namespace stepwire::study {

/// One drawing of one person under one condition, simulated or recorded.
struct Trial {
  std::string subject, task, condition;
  std::vector<double> time;        ///< [s], rising
  statistics::PlanePoints points;  ///< of the end-effector [m], one for each time
};

/// Trials from a CSV file with the columns subject, task and condition (words), time, x and y in any units of
/// time and length: "time [s],x [mm],y [mm]". The rows of one trial follow each other. Throws TableError with
/// file and line for what read_csv refuses, for a column that is missing or has no fitting unit, an empty
/// word, a number that is not finite, a time that does not rise within its trial, a trial of fewer than two
/// rows, and a second trial of the same subject, task and condition.
std::vector<Trial> read_trials(const std::string& path);

/// The same file again: time [s], x [mm], y [mm], and columns of one value for each trial behind these.
std::string trials_csv(const std::vector<Trial>& trials, const std::vector<table::Column>& of_trials = {});

}  // namespace stepwire::study
