#pragma once

#include <stop_token>
#include <string>
#include <vector>

namespace stepwire {

/// What became of a program that was run.
struct ProcessResult {
  int status = -1;     ///< its exit status; -1 if it could not be started, was killed or stopped
  std::string output;  ///< what it wrote
};

/// Runs a program, looked for on the PATH, and waits for it; a stop kills it.
ProcessResult run_process(const std::vector<std::string>& command, const std::stop_token& stop = {});

}  // namespace stepwire
