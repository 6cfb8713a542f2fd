#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "engine/simulate/run/executor.hpp"

namespace stepwire::realtime {

/// Lets another thread set values of a loop that runs. There are two runs of one plan: the loop steps one,
/// and a value is set in the other, which takes memory and time; between two ticks the loop copies where it
/// stands into that one and steps it from then on, to the bits of a run in which the value was set there.
class ValueExchange {
 public:
  using Change = std::function<void(run::Executor&)>;

  /// The plan must outlive it.
  explicit ValueExchange(const plan::Plan& plan) : runs_{run::Executor(plan), run::Executor(plan)} {}

  /// The loop thread, at most once in a period: the run to step from now on. Neither waits nor allocates.
  run::Executor& at_tick() noexcept;
  /// The run that the loop steps.
  run::Executor& active() { return runs_[active_]; }

  /// The other thread: offers the other run with a change. Throws what the change throws, and offers nothing
  /// then. Another offer must not wait.
  void offer(const Change& change);
  /// The tick from which on the loop has what was offered last; nothing before.
  std::optional<std::int64_t> taken() const;
  /// Changes what the loop has left in the same way; after taken(), before the next offer.
  void follow(const Change& change) { change(runs_[1 - active_]); }
  /// Changes both while no loop runs.
  void change_both(const Change& change);

 private:
  run::Executor runs_[2];
  std::size_t active_ = 0;  ///< written by the loop thread before taken_
  std::atomic<bool> offered_ = false;
  std::atomic<std::int64_t> taken_ = none;
  static constexpr std::int64_t none = -1;
};

}  // namespace stepwire::realtime
