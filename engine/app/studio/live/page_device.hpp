#pragma once

#include <vector>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/realtime/device.hpp"
#include "engine/simulate/realtime/latest_values.hpp"
#include "engine/simulate/realtime/loop_clock.hpp"

namespace stepwire::live {

/// Device of a real-time loop whose inputs are written by pages. An input has the value of the last page that
/// wrote it, until that value expires; then it has its default. The loop thread checks the expiry itself, so
/// a lost page or a blocked hub cannot hold an input for longer. Outputs are ignored.
class PageDevice : public realtime::Device {
 public:
  /// Plan and clock must outlive it.
  PageDevice(const plan::Plan& plan, realtime::LoopClock& clock);

  void read(double* inputs) noexcept override;
  void write(const double*) noexcept override {}

  /// Sets the values of an input, valid until a time of the clock [ns]; give() passes them to the loop. For
  /// one other thread.
  void put(std::size_t input, const std::vector<double>& values, std::int64_t until);
  /// Extends the validity of the values of an input.
  void extend(std::size_t input, std::int64_t until) {
    row_[inputs_[input].first] = static_cast<double>(until);
  }
  void give() { latest_.give(row_); }

 private:
  struct Input {
    std::size_t first;  ///< index in a row of the expiry time, before the values
    std::vector<double> defaults;
  };

  realtime::LoopClock& clock_;
  std::vector<Input> inputs_;
  std::vector<double> row_;
  realtime::LatestValues latest_;
};

}  // namespace stepwire::live
