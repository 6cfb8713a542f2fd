#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/simulate/realtime/counter.hpp"
#include "engine/simulate/realtime/row_ring.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::realtime {

/// Passes signals of a running loop to another thread.
///
/// That thread selects numbers of the workspace and receives them for each tick through a ring. The loop
/// thread neither waits nor allocates. A tick for which the ring has no space is lost and counted.
class SignalTap {
 public:
  /// `room` is the capacity of the ring in numbers.
  explicit SignalTap(std::size_t room = std::size_t{1} << 20) : ring_(room) {}

  /// Writes the selected numbers of a workspace at a tick. For the loop thread.
  void push(std::int64_t tick, const double* values);
  /// Returns the count of lost ticks.
  std::int64_t lost() const { return lost_; }

  /// Selects these places of the workspace, from a tick that has not been computed yet. For the receiving
  /// thread.
  void select(std::vector<std::size_t> places);
  /// Receiver of a tick, with the places that were selected at it and their values.
  using Take = std::function<void(std::int64_t tick, const std::vector<std::size_t>& places,
                                  std::span<const double> values)>;
  /// Passes on all ticks that have arrived, in order.
  void take_all(const Take& take);

 private:
  struct Selection {
    std::int64_t number;
    std::vector<std::size_t> places;
    std::vector<double> row;  ///< row of the loop thread: number, tick, values
  };
  static constexpr std::size_t before_values = 2;

  void forget_before(std::int64_t number);
  bool take_one(const Take& take, std::size_t& at);

  RowRing ring_;
  Counter lost_;
  std::atomic<Selection*> selected_ = nullptr;
  // Members of the receiving thread.
  std::deque<std::unique_ptr<Selection>> selections_;  ///< selections of which ticks may still arrive
  std::vector<double> numbers_;
  std::size_t filled_ = 0;
};

/// Lets another thread set values of a running loop without a delay of the loop.
///
/// Setting a value allocates and takes time, so there are two runs of one plan. The loop steps one of them,
/// and the other thread sets the value in the other one. Between two ticks the loop copies its state into
/// that run and continues with it. The results have the bits of a run in which the value was set there.
class ValueExchange {
 public:
  using Change = std::function<void(run::Executor&)>;

  /// The plan must outlive it.
  explicit ValueExchange(const plan::Plan& plan) : runs_{run::Executor(plan), run::Executor(plan)} {}

  /// Returns the run to step from now on, at most once in a period. Neither waits nor allocates. For the loop
  /// thread.
  run::Executor& at_tick() noexcept;
  /// Returns the run that the loop steps.
  run::Executor& active() { return runs_[active_]; }

  /// Changes the inactive run and offers it to the loop. Throws the exceptions of `change`, without an offer.
  /// No other offer may be pending. For the other thread.
  void offer(const Change& change);
  /// Returns the first tick with the last offer; std::nullopt while it is pending.
  std::optional<std::int64_t> taken() const;
  /// Applies the same change to the run that the loop has left. Call it after taken() and before the next
  /// offer.
  void follow(const Change& change) { change(runs_[1 - active_]); }
  /// Changes both runs while no loop runs.
  void change_both(const Change& change);

 private:
  run::Executor runs_[2];
  std::size_t active_ = 0;  ///< written by the loop thread before taken_
  std::atomic<bool> offered_ = false;
  std::atomic<std::int64_t> taken_ = none;
  static constexpr std::int64_t none = -1;
};

/// Wait-free triple buffer for the newest row of numbers from one thread to another. Each thread owns one of
/// three rows; the third one was passed last. No row is read while it is written.
class LatestValues {
 public:
  explicit LatestValues(const std::vector<double>& first) { rows_.fill(first); }

  /// Passes a row with as many numbers as the first one. For the writing thread.
  void give(std::span<const double> values) {
    std::ranges::copy(values, rows_[given_].begin());
    given_ = handed_.exchange(given_ | fresh, std::memory_order_acq_rel) & ~fresh;
  }
  /// Returns the newest row, valid until the next call. For the reading thread.
  std::span<const double> take() {
    if (handed_.load(std::memory_order_relaxed) & fresh)
      taken_ = handed_.exchange(taken_, std::memory_order_acq_rel) & ~fresh;
    return rows_[taken_];
  }

 private:
  static constexpr std::uint32_t fresh = 4;  // flag beside the index of a row

  std::array<std::vector<double>, 3> rows_;
  std::uint32_t given_ = 0, taken_ = 1;  ///< index of each thread's own row
  std::atomic<std::uint32_t> handed_ = 2;
};

}  // namespace stepwire::realtime
