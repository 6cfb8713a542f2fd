#pragma once

#include <optional>
#include <string>

#include "engine/simulate/journal/byte_journal.hpp"
#include "engine/simulate/run/point_exchange.hpp"

namespace stepwire::journal {

/// Journal of the points of a sweep.
class Journal : public ByteJournal {
 public:
  /// Opens the journal of a job whose sweep keeps these numbers (nullptr: rows). The job and the numbers must
  /// outlive it. Throws EnvironmentError.
  Journal(std::string path, const std::string& head, const run::Job& job, const run::RunNumbers* numbers,
          Use use)
      : ByteJournal(std::move(path), head, job.points.size(), use), job_(job), numbers_(numbers) {}

  /// Adds a point. Thread-safe. Throws EnvironmentError.
  void add(const run::PointResult& result);
  /// Returns the result of a point, as bytes() does. Throws EnvironmentError if the file was damaged after it
  /// was opened.
  std::optional<run::PointResult> point(std::size_t point);

 private:
  const run::Job& job_;
  const run::RunNumbers* numbers_;
};

}  // namespace stepwire::journal
