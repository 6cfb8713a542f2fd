#pragma once

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

namespace stepwire::subprocess {

/// A program to be run, and what bounds it.
struct ProcessCall {
  std::vector<std::string> command;    ///< the program, looked for on the PATH, and its arguments
  std::string input{};                 ///< what it reads from its standard input
  std::stop_token stop{};              ///< ends it
  std::chrono::milliseconds limit{0};  ///< after which it is ended; 0: usual_limit()
  std::size_t max_output = 1u << 30u;  ///< [bytes] beyond which it is ended
};

/// What became of a program.
struct ProcessResult {
  enum class End { exited, killed, stopped, overdue, too_much, not_started };

  End end = End::not_started;
  int status = -1;             ///< its exit status, where it ended by itself
  std::string output, errors;  ///< what it wrote; of its standard error the first 64 kB

  bool succeeded() const { return end == End::exited && status == 0; }
  /// In one sentence why it did not succeed; what it complained of comes first.
  std::string problem(const std::string& name) const;
};

/// An interruption has ended a program that somebody waited for.
class ProcessStopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The full path of a program on the PATH, or empty.
std::string find_program(const std::string& name);

/// How long a program may take that draws: a minute, or $STEPWIRE_HELPER_LIMIT [s].
std::chrono::milliseconds usual_limit();
/// The same for a compiler: five minutes, or that.
std::chrono::milliseconds compiler_limit();

/// While this is true every program that runs is ended and none is begun; an interruption sets it.
std::atomic<bool>& processes_stop();

/// Runs a program and waits for it. It has a process group and a folder for temporary files of its own: when
/// it ends, by itself or not, the processes that it began end as well, and its files go.
ProcessResult run_process(const ProcessCall& call);

/// The same, which has to succeed: throws ProcessStopped where it is stopped, and EnvironmentError with the
/// problem otherwise. `name` is what users call it.
ProcessResult run_helper(const std::string& name, const ProcessCall& call);

}  // namespace stepwire::subprocess
