#pragma once

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/session/ordered_points.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/simulate/journal/journal.hpp"

namespace stepwire::session {

/// Contiguous share of a sweep's points for one call: the `number`-th of `count` shares, whose sizes differ
/// by at most one.
struct Share {
  std::size_t number = 1, count = 1;

  /// Returns the first point of the share, of `points` points. The end of share k is the start of share k +
  /// 1.
  std::size_t first(std::size_t points) const { return points * (number - 1) / count; }
  std::size_t end(std::size_t points) const { return points * number / count; }
};

/// Returns the path of the journal of a sweep's points in a folder.
std::string points_path(const std::string& folder);
/// Returns the path of the journal of items that other processes did for a "study", a "fit" or a "tune".
std::string items_path(const std::string& folder, const std::string& of);

/// Returns the head of a journal, a line of JSON. It has the call by which the model is loaded again, and a
/// hash of everything that determines the results.
std::string points_head(const LoadedModel& model);

/// Loads the model of the journal in a folder. Throws Error if there is no journal or if the model has
/// changed since, and EnvironmentError.
LoadedModel load_kept(const Registry& registry, const std::string& folder);

/// Points of a share of a sweep, with a journal in the folder: each result is stored when its point ends. A
/// call continues after an interruption or a kill.
class KeptPoints : public run::PointExchange {
 public:
  /// Opens the journal and loads the points of an earlier call. The journal of another sweep is replaced.
  /// Throws EnvironmentError.
  KeptPoints(const LoadedModel& model, const std::string& folder, const Share& share = {});

  std::optional<std::size_t> next() override;
  void take(run::PointResult result) override;
  double done() const override;

  /// Returns the number of points of the share.
  std::size_t points() const { return end_ - first_; }
  /// Returns the number of points that next() has not returned yet.
  std::size_t left() const { return end_ - std::min<std::size_t>(next_, end_); }
  /// Returns the number of stored points of the share.
  std::size_t kept() const;
  /// Returns the number of points that an earlier call had stored.
  std::size_t found() const { return found_; }
  journal::Journal& journal() { return journal_; }
  /// Takes the result of an interrupted run, which the journal does not store; std::nullopt without one.
  std::optional<run::PointResult> half(std::size_t point);

 private:
  journal::Journal journal_;
  std::size_t first_, end_, found_ = 0;
  std::atomic<std::size_t> next_;
  std::mutex mutex_;
  std::vector<run::PointResult> halves_;
};

/// Merges journals of one job and judges the result like run_model().
/// A point without a record is taken from `halves`; the outcome is then that of an interrupted run. If runs
/// are judged one by one, files of signals are written as well. This may happen during the sweep, while a
/// journal is followed.
Outcome joined_points(const LoadedModel& model, const std::vector<journal::Journal*>& journals,
                      const RowUse& use, KeptPoints* halves = nullptr);

/// Returns the points without a record in any journal, "12, 40 to 99 and 7 more", numbered from 1; empty if
/// complete.
std::string missing_points(const LoadedModel& model, const std::vector<journal::Journal*>& journals);

}  // namespace stepwire::session
