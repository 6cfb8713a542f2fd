#pragma once

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/session/outcome.hpp"
#include "engine/app/session/row_use.hpp"
#include "engine/simulate/journal/journal.hpp"

namespace stepwire::session {

/// Which share of a sweep's points a call runs: the number-th of `count` runs of neighbours, which differ by
/// one point in their length at most.
struct Share {
  std::size_t number = 1, count = 1;

  /// The first of its points, of `points` in all; the end of share k is the start of share k + 1.
  std::size_t first(std::size_t points) const { return points * (number - 1) / count; }
  std::size_t end(std::size_t points) const { return points * number / count; }
};

/// Where the points of a model's sweep are kept in a folder.
std::string points_path(const std::string& folder);
/// Where what other processes did of a "study", a "fit" or a "tune" is kept.
std::string items_path(const std::string& folder, const std::string& of);

/// What the points of a model's sweep follow from: the diagram, its data, what each point sets, the program
/// and blocks from outside; and by which call the model is loaded again. A line of JSON.
std::string points_head(const LoadedModel& model);

/// Loads the model whose points a folder keeps. Throws Error where it keeps none, or where what they follow
/// from has changed since; EnvironmentError.
LoadedModel load_kept(const Registry& registry, const std::string& folder);

/// The points of a share of a model's sweep, kept in its folder as soon as each of them is done, so that a
/// call that was interrupted or killed goes on.
class KeptPoints : public run::PointExchange {
 public:
  /// Takes what an earlier call left; that of another sweep is replaced. Throws EnvironmentError.
  KeptPoints(const LoadedModel& model, const std::string& folder, const Share& share = {});

  std::optional<std::size_t> next() override;
  void take(run::PointResult result) override;
  double done() const override;

  /// Points of the share.
  std::size_t points() const { return end_ - first_; }
  /// Points that next() has not named yet.
  std::size_t left() const { return end_ - std::min<std::size_t>(next_, end_); }
  /// Points of the share that are kept by now.
  std::size_t kept() const;
  /// Of them, those that an earlier call has left.
  std::size_t found() const { return found_; }
  journal::Journal& journal() { return journal_; }
  /// What a run gave that was interrupted, which is not kept.
  std::optional<run::PointResult> half(std::size_t point);

 private:
  journal::Journal journal_;
  std::size_t first_, end_, found_ = 0;
  std::atomic<std::size_t> next_;
  std::mutex mutex_;
  std::vector<run::PointResult> halves_;
};

/// What journals of one job hold together, judged as by run_model(); a point that is in none has what `halves`
/// has of it, and then the result is that of an interrupted run. Where the runs go one by one, files of signals
/// are written; this may be while the points come, of a journal that is followed.
Outcome joined_points(const LoadedModel& model, const std::vector<journal::Journal*>& journals,
                      const RowUse& use, KeptPoints* halves = nullptr);

/// "12, 40 to 99 and 7 more": which points no journal has, numbered from 1; empty where there are none.
std::string missing_points(const LoadedModel& model, const std::vector<journal::Journal*>& journals);

}  // namespace stepwire::session
