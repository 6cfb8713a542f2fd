#pragma once

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

namespace stepwire::subprocess {

/// A program to run, with its limits.
struct ProcessCall {
  std::vector<std::string> command;      ///< The program, searched on the PATH, and its arguments.
  std::string input{};                   ///< Standard input.
  std::string folder{};                  ///< Working folder; empty: that of this process.
  std::vector<std::string> variables{};  ///< Variables added to the environment: "NAME=value".
  std::stop_token stop{};                ///< Kills it on request.
  std::chrono::milliseconds limit{0};    ///< Time after which it is killed; 0: usual_limit().
  std::size_t max_output = 1u << 30u;    ///< Bytes of output beyond which it is killed.
};

/// Outcome of running a program.
struct ProcessResult {
  enum class End { exited, killed, stopped, overdue, too_much, not_started };

  End end = End::not_started;
  int status = -1;             ///< exit status after a normal exit
  std::string output, errors;  ///< its output; of standard error the first 64 kB

  bool succeeded() const { return end == End::exited && status == 0; }
  /// Returns one sentence why it failed, beginning with its own error message.
  std::string problem(const std::string& name) const;
};

/// Thrown where an interruption has ended a program that was waited for.
class ProcessStopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns the full path of a program on the PATH; empty if it is missing.
std::string find_program(const std::string& name);

/// Returns the time limit of helper programs such as gnuplot: a minute, or $STEPWIRE_HELPER_LIMIT [s].
std::chrono::milliseconds usual_limit();
/// Returns the time limit of compilers: five minutes, or $STEPWIRE_HELPER_LIMIT [s].
std::chrono::milliseconds compiler_limit();

/// Flag that kills every running program and prevents new ones; an interruption sets it.
std::atomic<bool>& processes_stop();

/// Runs a program and waits for it. It has its own process group and temporary folder. At its end, normal or
/// not, the processes that it started are killed and its temporary files removed.
ProcessResult run_process(const ProcessCall& call);

/// Runs a program that has to succeed. Throws ProcessStopped on an interruption, and EnvironmentError with
/// the problem otherwise. `name` is the program's name for users.
ProcessResult run_helper(const std::string& name, const ProcessCall& call);

}  // namespace stepwire::subprocess
