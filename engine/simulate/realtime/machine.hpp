#pragma once

#include <string>

namespace stepwire::realtime {

/// What of a machine decides how well it keeps time; each text is "" where the machine does not tell.
struct Machine {
  std::string processor;
  int processors = 0;
  bool virtual_machine = false;
  std::string kernel;       ///< release and version: "6.1.0 #1 SMP PREEMPT_RT"
  std::string kernel_line;  ///< the command line it was started with
  std::string governor;     ///< of the processors' frequency
  std::string clock_source;
  std::string isolated;  ///< processors that the scheduler leaves alone: "2-3"

  static Machine here();
};

}  // namespace stepwire::realtime
