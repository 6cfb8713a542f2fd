#pragma once

#include <functional>
#include <span>
#include <vector>

#include "engine/simulate/record/recording.hpp"

namespace stepwire::run {

/// Numbers that a sweep keeps of a run in place of its rows.
struct RunNumbers {
  std::vector<table::Column> columns;  ///< names and units, without rows
  /// Computes one number for each column from the recording of one run, with its swept parameters as columns;
  /// NaN for a missing one. Thread-safe.
  std::function<std::vector<double>(std::span<const record::Recording> run)> of;
};

}  // namespace stepwire::run
