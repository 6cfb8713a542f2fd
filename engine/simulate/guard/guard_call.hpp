#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/simulate/guard/bank.hpp"
#include "engine/simulate/guard/watch.hpp"

namespace stepwire::guard {

/// Content of the call of a guard.
struct GuardCall {
  std::vector<DeviceSettings> devices;
  std::vector<InputUse> uses;  ///< of the inputs of each device
  std::int64_t wait = 0;       ///< largest time to the first values [ns]
  WatchLimits limits;
  int priority = 0;  ///< of SCHED_FIFO; 0: the default policy
};

/// Return a call as bytes, and read it back. Bytes that are not whole throw EnvironmentError.
std::string bytes_of(GuardCall call);
GuardCall guard_call(std::string_view bytes);

/// Function that is called before each call of a driver, with the device and the function of driver.h.
using BeforeCall = std::function<void(const std::string& device, const char* function)>;

/// Opens each device of a call, sets its outputs to their safe values and closes it. Returns the reasons of
/// those that fail; "" for none.
std::string set_safe(const GuardCall& call, const BeforeCall& before = {}) noexcept;

/// Sets real-time scheduling of this process, and locks its memory, as far as the system allows it.
void become_prompt(int priority);

}  // namespace stepwire::guard
