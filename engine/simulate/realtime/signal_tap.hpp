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

}  // namespace stepwire::realtime
