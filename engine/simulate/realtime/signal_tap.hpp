#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "engine/simulate/realtime/counter.hpp"
#include "engine/simulate/realtime/row_ring.hpp"

namespace stepwire::realtime {

/// Signals of a loop for somebody who looks on: another thread selects numbers of the workspace while the
/// loop runs, and gets them for each tick through a ring. The loop thread neither waits nor allocates; a tick
/// for which the ring has no room is lost, and counted.
class SignalTap {
 public:
  /// `room`: of numbers in the ring.
  explicit SignalTap(std::size_t room = std::size_t{1} << 20) : ring_(room) {}

  /// The loop thread: the numbers of a workspace at a tick.
  void push(std::int64_t tick, const double* values);
  /// Ticks that were lost.
  std::int64_t lost() const { return lost_; }

  /// The thread that looks on: from a tick on that has not been computed yet, these places of the workspace.
  void select(std::vector<std::size_t> places);
  /// What a tick had at the places that were selected then.
  using Take = std::function<void(std::int64_t tick, const std::vector<std::size_t>& places,
                                  std::span<const double> values)>;
  /// Hands on all ticks that have come, in their order.
  void take_all(const Take& take);

 private:
  struct Selection {
    std::int64_t number;
    std::vector<std::size_t> places;
    std::vector<double> row;  ///< of the loop thread: number, tick, values
  };
  static constexpr std::size_t before_values = 2;

  void forget_before(std::int64_t number);
  bool take_one(const Take& take, std::size_t& at);

  RowRing ring_;
  Counter lost_;
  std::atomic<Selection*> selected_ = nullptr;
  // Of the thread that looks on.
  std::deque<std::unique_ptr<Selection>> selections_;  ///< those of which ticks may still come
  std::vector<double> numbers_;
  std::size_t filled_ = 0;
};

}  // namespace stepwire::realtime
