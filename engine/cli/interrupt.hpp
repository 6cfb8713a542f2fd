#pragma once

#include <atomic>

namespace stepwire {

/// Set by the first SIGINT (Ctrl-C), SIGTERM or SIGHUP after catch_signals(). It also ends the programs that
/// run for this one. The second one ends this process at once, without its temporary files and processes.
const std::atomic<bool>& interrupted();

/// Catches these signals, and has a broken pipe and a limit of file size show where something is written.
void catch_signals();

/// As long as it is there, further signals end nothing at once: there are outputs to be made safe.
class OrderlyEnd {
 public:
  OrderlyEnd();
  ~OrderlyEnd();
  OrderlyEnd(const OrderlyEnd&) = delete;
  OrderlyEnd& operator=(const OrderlyEnd&) = delete;
};

}  // namespace stepwire
