#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/analyse/study/experiment.hpp"

namespace stepwire {

/// What the thesis prints of a task, by the names of an outcome's values: mean.CONDITION, p.EFFECT.
std::vector<NamedValue> published_outcome(const StudyRequest& request);

/// What came out of many experiments of one study, which differ in the people and the noise: a row for each,
/// by its seed. Kept in a CSV file, so that a repetition that was interrupted goes on.
class Repetition {
 public:
  /// `columns` are the names of an outcome's values.
  explicit Repetition(std::vector<std::string> columns) : columns_(std::move(columns)) {}

  /// Takes the rows of a file that an earlier call wrote. Throws TableError where it is another study's.
  void read(const std::string& path);
  /// The file that read() takes: columns seed and those of the outcome.
  std::string csv() const;

  bool has(std::uint64_t seed) const { return rows_.contains(seed); }
  void add(std::uint64_t seed, const std::vector<NamedValue>& outcome);
  /// A value of all experiments, nan where one has it not.
  std::vector<double> column(const std::string& name) const;
  const std::vector<std::string>& columns() const { return columns_; }
  std::size_t size() const { return rows_.size(); }

  /// For each value that the thesis prints: the thesis', our median, the range in which 90 % of the
  /// experiments lie, and the part of them that lies below the thesis' value.
  TextTable table(const StudyRequest& request) const;

 private:
  std::vector<std::string> columns_;
  std::map<std::uint64_t, std::vector<double>> rows_;
};

}  // namespace stepwire
