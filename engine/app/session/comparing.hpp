#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/comparison/compare.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire::session {

/// Comparison of two recorded runs: folders of `run --out` or data files.
struct CompareCall {
  std::string a, b;
  std::string within;  ///< File of accepted differences; empty: none.
  /// Tolerances as words of the call, "SIGNAL=VALUE" or "VALUE" for all signals. They win over the file.
  std::vector<std::string> absolute, relative, jitter;
  std::vector<std::string> hold;  ///< Signals that keep each value up to the next row.
  std::vector<std::string> only;  ///< Patterns of the compared signals; empty: all.
};

/// Both recordings of a comparison, with the tolerances and the result.
struct ComparedRuns {
  std::vector<table::RecordTable> a, b;
  comparison::Tolerances tolerances;
  comparison::RecordingDifference difference;
};

/// Compares two recorded runs. Without `b` the file of accepted differences names the baseline, which becomes
/// A. Throws Error for a wrong call or units that do not fit, and TableError for unreadable files.
ComparedRuns compare_runs(const CompareCall& call);

/// Returns pointers to tables, as comparison::compare() takes them.
std::vector<const table::Table*> tables_of(const std::vector<table::RecordTable>& tables);

}  // namespace stepwire::session
