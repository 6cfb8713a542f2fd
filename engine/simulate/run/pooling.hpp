#pragma once

#include <string>
#include <vector>

#include "engine/simulate/run/run.hpp"

namespace stepwire::run {

/// True if the values of an axis are words; its column then has their numbers. Otherwise the values are
/// numbers or formulas.
bool has_words(const diagram::Sweep::Axis& axis);
/// Returns the distinct words of an axis in their order; its column has their indices.
std::vector<std::string> words_of(const diagram::Sweep::Axis& axis);

/// Returns "speed=3, mass=1 kg".
std::string settings_text(const std::vector<diagram::Setting>& settings);

/// Returns the smallest number of leading settings whose values differ between all points. Without one,
/// returns the number of settings of the shortest point: trials of a study have more or fewer settings by
/// condition.
std::size_t telling_settings(const std::vector<std::vector<diagram::Setting>>& points);

/// Swept parameters of a job's points, as columns after the time. The list of columns is empty without a
/// sweep.
class SweptColumns {
 public:
  /// The job must outlive it.
  explicit SweptColumns(const Job& job);

  /// Returns the columns, without rows.
  const std::vector<table::Column>& columns() const { return columns_; }
  /// Returns the words of columns that hold numbers of words.
  const std::vector<record::Categories>& categories() const { return categories_; }
  /// Returns the numbers of one point, parallel to the columns.
  std::vector<double> numbers(std::size_t point) const;
  /// Returns the columns with the one row of a point.
  std::vector<table::Column> of(std::size_t point) const;
  /// Adds the columns to the recording of a point.
  void add(record::Recording& recording, std::size_t point) const;

 private:
  double evaluated(std::size_t axis, std::size_t point) const;

  const Job& job_;
  std::vector<table::Column> columns_;
  std::vector<record::Categories> categories_;
  std::vector<std::vector<double>>
      numbers_;  ///< [axis][text]; empty list for formulas and for axes that have the numbers
};

/// Appends the runs of a recording to another one, which has the same columns or no columns yet.
void append_runs(record::Recording& all, record::Recording&& more);

/// Pooled recording of all points of a sweep, in their order. Each point writes its rows directly to their
/// final place.
class PooledRecording {
 public:
  PooledRecording(const Job& job, const SweptColumns& swept, unsigned threads);

  /// Returns the recorders of a point. Thread-safe.
  std::vector<record::Recorder> recorders(std::size_t point);
  /// Stores how many rows the recorders of a point have written, or copies recordings that were made
  /// elsewhere. Thread-safe.
  void put(std::size_t point, const std::vector<record::Recording>& recorded,
           const std::vector<std::size_t>& rows);
  /// Closes the gaps of points that ended early, and returns all recordings.
  std::vector<record::Recording> take();

 private:
  /// Recording of one request, with room for all rows.
  struct Rows {
    record::Recording recording;
    std::vector<std::size_t> first, count;  ///< rows of each point
  };

  void fill_swept(std::size_t point);
  void close_gaps(Rows& rows) const;

  const Job& job_;
  const SweptColumns& swept_;
  std::vector<Rows> all_;
};

}  // namespace stepwire::run
