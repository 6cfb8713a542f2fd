#pragma once

#include <mutex>
#include <string>

#include "engine/app/session/monitor.hpp"

namespace stepwire::cli {

/// Progress bar on the standard error; silent unless that is a terminal.
class Progress {
 public:
  explicit Progress(const std::string& label);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Sets the finished fraction, 0 to 1. Thread-safe.
  void show(double fraction, const std::string& what = "");

 private:
  std::string label_;
  bool on_terminal_;
  int last_permille_ = -1;
  std::mutex mutex_;
};

/// Returns the monitor of the command line. It shows a progress bar on the terminal and diagnostics on the
/// standard error, and signals interrupt its operation. Without `progress` there is no bar.
session::Monitor terminal_monitor(Progress* progress);

}  // namespace stepwire::cli
