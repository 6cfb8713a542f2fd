#pragma once

#include <functional>
#include <span>
#include <vector>

#include "engine/simulate/record/recording.hpp"

namespace stepwire::run {

/// What is kept of a run in place of its rows.
struct RunNumbers {
  std::vector<table::Column> columns;  ///< names and units, without rows
  /// A number for each column from what one run recorded, its swept parameters as columns; nan where there is
  /// none. Called from any thread.
  std::function<std::vector<double>(std::span<const record::Recording> run)> of;
};

}  // namespace stepwire::run
