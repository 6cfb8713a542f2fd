#pragma once

#include <string>

#include "engine/base/fmi/foreign_call.hpp"

namespace stepwire::fmi {

/// Watchdog for the calls of a unit that runs in this process. It ends the process with a message that names
/// the unit and the call. The exit status is 3 where the unit calls exit() or quick_exit(), or exceeds the
/// time limit of helper programs. It is 130 where a call lasts a second after an interruption.
class CallWatch {
 public:
  /// `unit` begins the message: "wheel: the unit wheel.fmu".
  CallWatch(const CallNote& note, std::string unit);
  ~CallWatch();
  CallWatch(const CallWatch&) = delete;
  CallWatch& operator=(const CallWatch&) = delete;

 private:
  const CallNote& note_;
};

}  // namespace stepwire::fmi
