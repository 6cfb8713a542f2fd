#pragma once

#include <string>
#include <vector>

#include "engine/simulate/run/run.hpp"

namespace stepwire::run {

/// Are the values of an axis words, which stand in its column as numbers? Else they are numbers or formulas.
bool has_words(const diagram::Sweep::Axis& axis);
/// The words of an axis in their order, each once: its column has their indices.
std::vector<std::string> words_of(const diagram::Sweep::Axis& axis);

/// "speed=3, mass=1 kg".
std::string settings_text(const std::vector<diagram::Setting>& settings);

/// The number of leading settings by whose values all points differ; as many as the shortest point has where
/// no fewer do: trials of a study have more or fewer settings by their condition.
std::size_t telling_settings(const std::vector<std::vector<diagram::Setting>>& points);

/// What tells apart the recordings of a job's points: its swept parameters, as columns behind the time. None
/// without a sweep.
class SweptColumns {
 public:
  /// The job must outlive it.
  explicit SweptColumns(const Job& job);

  /// Columns without rows.
  const std::vector<table::Column>& columns() const { return columns_; }
  /// Where columns hold the numbers of words.
  const std::vector<record::Categories>& categories() const { return categories_; }
  /// The numbers of one point, parallel to the columns.
  std::vector<double> numbers(std::size_t point) const;
  /// The same as columns of one row.
  std::vector<table::Column> of(std::size_t point) const;
  /// Adds them to what was recorded at a point.
  void add(record::Recording& recording, std::size_t point) const;

 private:
  double evaluated(std::size_t axis, std::size_t point) const;

  const Job& job_;
  std::vector<table::Column> columns_;
  std::vector<record::Categories> categories_;
  std::vector<std::vector<double>>
      numbers_;  ///< [axis][text]; empty where they hang on the point, and where the axis has numbers itself
};

/// Puts the runs of a recording behind those of another one, which has the same columns or none yet.
void append_runs(record::Recording& all, record::Recording&& more);

/// What all points of a sweep record, in their order. Each point writes its rows where they stay.
class PooledRecording {
 public:
  PooledRecording(const Job& job, const SweptColumns& swept, unsigned threads);

  /// Recorders of a point; from any thread.
  std::vector<record::Recorder> recorders(std::size_t point);
  /// Notes what they have recorded; from any thread.
  void done(std::size_t point, const std::vector<record::Recorder>& recorders);
  /// Takes what a point has recorded elsewhere.
  void put(std::size_t point, const std::vector<record::Recording>& recorded);
  /// Closes the gaps of points that ended early, and gives all recordings.
  std::vector<record::Recording> take();

 private:
  /// The recording of one request, with room for all rows.
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
