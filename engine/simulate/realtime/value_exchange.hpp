#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "engine/simulate/run/executor.hpp"

namespace stepwire::realtime {

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

}  // namespace stepwire::realtime
