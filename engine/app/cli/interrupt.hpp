#pragma once

#include <atomic>

namespace stepwire::cli {

/// True after SIGINT (Ctrl-C), SIGTERM or SIGHUP, from catch_signals() on.
/// The signal terminates the child processes. Then it ends this process with exit code 130 and without its
/// temporary files, unless an EndDelay exists. A second signal ends the process by itself.
const std::atomic<bool>& interrupted();

/// Lets each of these signals end the process with exit code 130, for the time before catch_signals().
void end_at_signals();

/// Installs the handlers, and ignores SIGPIPE and SIGXFSZ, so that failed writes return errors instead.
void catch_signals();

/// Guard that delays the end of the process during its lifetime: signals only set interrupted(), which the
/// code in its scope polls.
/// The kind `first` delays only the first signal, so that results are kept; `all` delays every signal, so
/// that outputs are completed.
class EndDelay {
 public:
  enum class Signals { first, all };

  explicit EndDelay(Signals signals);
  ~EndDelay();
  EndDelay(const EndDelay&) = delete;
  EndDelay& operator=(const EndDelay&) = delete;

 private:
  std::atomic<int>& count_;  ///< number of existing delays of this kind
};

}  // namespace stepwire::cli
