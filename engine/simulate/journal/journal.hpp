#pragma once

#include <optional>
#include <string>

#include "engine/simulate/journal/byte_journal.hpp"
#include "engine/simulate/run/point_exchange.hpp"

namespace stepwire::journal {

/// The points of a sweep in such a file.
class Journal : public ByteJournal {
 public:
  /// Of a job whose sweep keeps these numbers (null: rows), which must outlive it. Throws EnvironmentError.
  Journal(std::string path, const std::string& head, const run::Job& job, const run::RunNumbers* numbers,
          Use use)
      : ByteJournal(std::move(path), head, job.points.size(), use), job_(job), numbers_(numbers) {}

  /// Adds a point. From any thread. Throws EnvironmentError.
  void add(const run::PointResult& result);
  /// What it has of a point, as bytes(). Throws EnvironmentError where the file was damaged since it was
  /// opened.
  std::optional<run::PointResult> point(std::size_t point);

 private:
  const run::Job& job_;
  const run::RunNumbers* numbers_;
};

}  // namespace stepwire::journal
