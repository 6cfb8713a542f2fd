#pragma once

#include <string>

#include "engine/base/fmi/foreign_call.hpp"

namespace stepwire::fmi {

/// Watches the calls of a unit in this process for as long as it lives. A sentence on the standard error
/// names the unit and the call, and the process ends. Its status is 3 where the unit calls exit() or
/// quick_exit(), or where a call takes longer than a helper program may. It is 130 where a call lasts for a
/// second behind an interruption.
class CallWatch {
 public:
  /// `unit` begins the sentence: "wheel: the unit wheel.fmu".
  CallWatch(const CallNote& note, std::string unit);
  ~CallWatch();
  CallWatch(const CallWatch&) = delete;
  CallWatch& operator=(const CallWatch&) = delete;

 private:
  const CallNote& note_;
};

}  // namespace stepwire::fmi
