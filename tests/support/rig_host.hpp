#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/driver/open_device.hpp"

namespace stepwire {

/// Rig in this process, behind shared memory, with a force to read and a current to write. Its steps count
/// its own time.
class RigHost {
 public:
  /// Creates the shared memory of this name. A current older than `stale` is not fresh.
  explicit RigHost(const std::string& name, const std::string& stale = "100 s");

  /// Waits for a period of 10 ms, offers the force, and returns the current that is written now; NaN before
  /// any.
  double step(double force);
  /// Returns the number of steps until the current is that value, at most `most` + 1.
  int steps_until(double current, int most);
  /// Returns the same, and offers no force meanwhile.
  int silent_until(double current, int most);
  /// Removes the shared memory. Nothing else may be called then.
  void leave() { device_.reset(); }
  bool is_fresh() { return device_->read(&current_) == STEPWIRE_OK; }

 private:
  double look();

  std::optional<driver::OpenDevice> device_;
  double current_;
};

/// Program that runs beside a test, killed at its end.
class Beside {
 public:
  /// Starts a program in a folder; its output goes to the files .out and .err there.
  Beside(const std::string& program, const std::vector<std::string>& arguments, const std::string& folder);
  ~Beside();
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  void send(int signal) const;
  /// Waits for its end. Returns its exit status, 128 + signal where one ended it.
  int end();
  /// Returns the process id of a child of this name, of this program or of `parent`; waits some seconds for
  /// it, 0 without any.
  int child(const std::string& name, int parent = 0) const;
  int process() const { return process_; }

 private:
  int process_ = -1;
};

}  // namespace stepwire
