#pragma once

#include <vector>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/realtime/device.hpp"
#include "engine/simulate/realtime/latest_values.hpp"
#include "engine/simulate/realtime/loop_clock.hpp"

namespace stepwire::live {

/// Pages as the outside world of a loop: its inputs are what a page wrote last, for as long as that page is
/// known to be there, and their defaults otherwise. The loop thread itself sees that the time is over, so a
/// page that is lost, a hub that is stuck, or anything between holds an input for no longer. Nobody takes the
/// outputs.
class PageDevice : public realtime::Device {
 public:
  /// Plan and clock must outlive it.
  PageDevice(const plan::Plan& plan, realtime::LoopClock& clock);

  void read(double* inputs) noexcept override;
  void write(const double*) noexcept override {}

  /// Of one other thread: the values of an input, which hold until a time of the clock [ns]; in force with
  /// give().
  void put(std::size_t input, const std::vector<double>& values, std::int64_t until);
  /// They hold until another time.
  void extend(std::size_t input, std::int64_t until) {
    row_[inputs_[input].first] = static_cast<double>(until);
  }
  void give() { latest_.give(row_); }

 private:
  struct Input {
    std::size_t first;  ///< in a row: until when, then the values
    std::vector<double> defaults;
  };

  realtime::LoopClock& clock_;
  std::vector<Input> inputs_;
  std::vector<double> row_;
  realtime::LatestValues latest_;
};

}  // namespace stepwire::live
