#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/analyse/study/outcome_columns.hpp"

namespace stepwire::study {

/// By the seed of an experiment and the point of the sweep, from 0.
using OutcomeRows = std::map<std::pair<std::uint64_t, std::size_t>, std::vector<double>>;

/// The rows of a file of experiments, whatever study they are of.
struct KeptRows {
  std::string head;  ///< its first line; empty where the file was cut in it
  OutcomeRows rows;
};

/// Each row ends with a hash of its text. A last line without its end was cut, and is left out. Throws
/// TableError, with the line and the cure, where a row is not as it was written; EnvironmentError.
KeptRows read_kept_rows(const std::string& path);

/// What came out of many experiments of one study, which differ in the people and the noise: a row for each,
/// by its seed and the point of the sweep. Kept in a CSV file, so that experiments that were interrupted go
/// on.
class Repetition {
 public:
  /// The columns of an outcome.
  explicit Repetition(std::vector<OutcomeColumn> columns) : columns_(std::move(columns)) {}

  /// Takes the rows of a file that an earlier call wrote. Throws TableError where it is another study's, and
  /// as read_kept_rows() does.
  void read(const std::string& path);
  /// The file that read() takes: columns seed, point (from 1), those of the outcome, check.
  std::string csv() const;

  /// Is the experiment there at so many points?
  bool has(std::uint64_t seed, std::size_t points = 1) const;
  void add(const ExperimentOutcome& outcome, std::size_t point = 0);
  /// What there is of a point, by rising seeds.
  std::vector<ExperimentOutcome> outcomes(std::size_t point = 0) const;
  std::size_t size() const { return rows_.size(); }

 private:
  std::string head() const;

  std::vector<OutcomeColumn> columns_;
  OutcomeRows rows_;
};

}  // namespace stepwire::study
