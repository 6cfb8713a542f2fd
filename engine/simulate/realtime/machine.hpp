#pragma once

#include <string>

namespace stepwire::realtime {

/// Properties of a machine that affect its timing; unknown texts are empty.
struct Machine {
  std::string processor;
  int processors = 0;
  bool virtual_machine = false;
  std::string kernel;       ///< release and version: "6.1.0 #1 SMP PREEMPT_RT"
  std::string kernel_line;  ///< words of the boot command line that matter for timing
  std::string governor;     ///< frequency governor of the processors
  std::string clock_source;
  std::string isolated;  ///< processors that the scheduler does not use: "2-3"

  static Machine here();
};

/// Returns the words of a kernel's command line that matter for timing, separated by blanks.
std::string timing_words(const std::string& line);

}  // namespace stepwire::realtime
