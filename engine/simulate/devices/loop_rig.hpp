#pragma once

#include <string>
#include <vector>

#include "engine/simulate/realtime/device.hpp"
#include "engine/simulate/realtime/loop_clock.hpp"

namespace stepwire::devices {

/// Devices of a loop, opened and checked.
class LoopRig {
 public:
  virtual ~LoopRig() = default;
  virtual realtime::Device& device() = 0;
  /// Returns the clock of the loop; nullptr for the timer.
  virtual realtime::LoopClock* clock() { return nullptr; }
  /// Returns lines about what is not wired.
  virtual std::vector<std::string> notes() const { return {}; }
  /// Returns why the devices ended the loop; "" if they did not.
  virtual std::string trouble() const { return ""; }
  /// Ends the use of the devices. Returns lines of counts.
  virtual std::vector<std::string> finish() = 0;
};

}  // namespace stepwire::devices
