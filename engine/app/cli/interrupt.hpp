#pragma once

#include <atomic>

namespace stepwire::cli {

/// Set by SIGINT (Ctrl-C), SIGTERM and SIGHUP after catch_signals(). Each of them ends the programs that run
/// for this one, and then this process without its temporary files, unless an EndDelay exists.
const std::atomic<bool>& interrupted();

/// Catches these signals, and has a broken pipe and a limit of file size show where something is written.
void catch_signals();

/// As long as one exists, signals set interrupted(), which the code in its scope polls, and do not end the
/// process: the first signal only, so that results are kept, or all of them, so that outputs are made safe.
class EndDelay {
 public:
  enum class Signals { first, all };

  explicit EndDelay(Signals signals);
  ~EndDelay();
  EndDelay(const EndDelay&) = delete;
  EndDelay& operator=(const EndDelay&) = delete;

 private:
  std::atomic<int>& count_;  ///< of those that exist for these signals
};

}  // namespace stepwire::cli
