#pragma once

#include <string>

#include "engine/base/fmi/foreign_call.hpp"

namespace stepwire::fmi {

/// Watches the calls of a unit in this process for as long as it lives. The process ends with a sentence on
/// its standard error that names the unit and the call:
/// - with status 3 where the unit calls exit() or quick_exit(), or a call takes longer than a helper program
/// may;
/// - with status 130 where a call lasts for a second behind an interruption.
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
