#pragma once

#include <atomic>

namespace stepwire {

/// Set by SIGINT (Ctrl-C), SIGTERM and SIGHUP after catch_signals(). They end the programs that run for this
/// one, and this process, without its temporary files, at once: but for the first one while there is a
/// GracefulEnd, and for all while there is an OrderlyEnd.
const std::atomic<bool>& interrupted();

/// Catches these signals, and has a broken pipe and a limit of file size show where something is written.
void catch_signals();

/// As long as it is there, the first signal ends nothing: whoever made it looks at interrupted() now and
/// then, and keeps what is worth it.
class GracefulEnd {
 public:
  GracefulEnd();
  ~GracefulEnd();
  GracefulEnd(const GracefulEnd&) = delete;
  GracefulEnd& operator=(const GracefulEnd&) = delete;
};

/// As long as it is there, no signal ends the process: there are outputs to be made safe.
class OrderlyEnd {
 public:
  OrderlyEnd();
  ~OrderlyEnd();
  OrderlyEnd(const OrderlyEnd&) = delete;
  OrderlyEnd& operator=(const OrderlyEnd&) = delete;
};

}  // namespace stepwire
