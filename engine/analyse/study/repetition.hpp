#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/analyse/study/study_columns.hpp"

namespace stepwire::study {

/// Results by the seed of an experiment and the point of the sweep, from 0.
using OutcomeRows = std::map<std::pair<std::uint64_t, std::size_t>, std::vector<double>>;

/// Rows of a file of experiments, of any study.
struct KeptRows {
  std::string head;  ///< First line; empty if the file was cut in it.
  OutcomeRows rows;
};

/// Reads a file of experiments. Each row ends with a hash of its text. A last line without a newline was cut
/// off and is left out. Throws TableError, with the line and the cure, for a row that was changed;
/// EnvironmentError.
KeptRows read_kept_rows(const std::string& path);

/// Results of many experiments of one study with different people and noise: a row for each seed and point of
/// the sweep. A CSV file stores them, so that an interrupted call can be continued.
class Repetition {
 public:
  /// Takes the columns of an outcome.
  explicit Repetition(std::vector<OutcomeColumn> columns) : columns_(std::move(columns)) {}

  /// Adds the rows of a file of an earlier call. Throws TableError for a file of another study, and as
  /// read_kept_rows() does.
  void read(const std::string& path);
  /// Returns the text of the file: columns seed, point (from 1), those of the outcome, check.
  std::string csv() const;

  /// True if the experiment is known at the first `points` points.
  bool has(std::uint64_t seed, std::size_t points = 1) const;
  void add(const ExperimentOutcome& outcome, std::size_t point = 0);
  /// Returns the results at a point, by rising seeds.
  std::vector<ExperimentOutcome> outcomes(std::size_t point = 0) const;
  std::size_t size() const { return rows_.size(); }

 private:
  std::string head() const;

  std::vector<OutcomeColumn> columns_;
  OutcomeRows rows_;
};

}  // namespace stepwire::study
