#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "engine/simulate/guard/guard_call.hpp"
#include "engine/simulate/guard/link.hpp"

namespace stepwire::guard {

/// Guard of this process, as its loop uses it. command() and inputs() neither allocate nor wait.
///
/// A guard that has ended, is stopped or does not read the devices in time is killed, and this process sets
/// the outputs to their safe values. The first two are noticed at once.
class RunningGuard {
 public:
  /// Starts the guard and waits until its devices are started. Throws EnvironmentError with its reason.
  /// Once `interrupt` is true it waits no longer for the first values.
  explicit RunningGuard(GuardCall call, const std::atomic<bool>* interrupt = nullptr);
  /// Ends it; the devices are at their safe values.
  ~RunningGuard();
  RunningGuard(const RunningGuard&) = delete;
  RunningGuard& operator=(const RunningGuard&) = delete;

  /// Returns the last inputs. False once the guard has tripped or is gone.
  bool inputs(double* values) noexcept;
  bool command(const double* values) noexcept;
  void rest() noexcept { link_.beat(GuardRequest::rest); }
  /// Ends the guard and returns the counts of its devices.
  std::string finish();
  /// Returns why the guard ended the use of the devices; "" if it has not.
  std::string trouble() const;
  pid_t process() const { return process_; }

 private:
  void spawn();
  void watch_process() noexcept;
  bool is_well() noexcept;
  void rescue() noexcept;
  void set_safe() noexcept;
  void await(GuardState worst, std::int64_t limit, const std::atomic<bool>* interrupt = nullptr);

  GuardCall call_;
  Link link_;
  io::Descriptor life_;
  pid_t process_ = -1;
  std::atomic<bool> gone_{false}, finishing_{false};
  std::thread process_watch_;  ///< sleeps until the guard has ended or is stopped
};

}  // namespace stepwire::guard
