#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/figure/plot_spec.hpp"
#include "engine/study/experiment.hpp"

namespace stepwire {

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
  std::size_t size() const { return rows_.size(); }

  /// For each value that the thesis prints: the thesis', our median, the range in which 90 % of the
  /// experiments lie, and the part of them that lies below the thesis' value.
  TextTable table(const StudyRequest& request) const;
  /// Histograms of these values, with a line at the thesis' value. P is drawn by its logarithm.
  FigureSpec figure(const StudyRequest& request) const;

 private:
  std::vector<double> column(const std::string& name) const;

  std::vector<std::string> columns_;
  std::map<std::uint64_t, std::vector<double>> rows_;
};

}  // namespace stepwire
