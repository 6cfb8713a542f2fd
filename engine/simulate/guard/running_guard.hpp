#pragma once

#include <sys/types.h>

#include <atomic>
#include <csignal>
#include <cstdint>
#include <optional>
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
  /// Starts the process of the guard, which opens the devices. Throws EnvironmentError.
  explicit RunningGuard(GuardCall call);
  /// Ends it; the devices are at their safe values.
  ~RunningGuard();
  RunningGuard(const RunningGuard&) = delete;
  RunningGuard& operator=(const RunningGuard&) = delete;

  /// Lets the guard start the devices, and waits for their first values, until `interrupt` is true. Throws
  /// EnvironmentError with the guard's reason.
  void start(const std::atomic<bool>* interrupt = nullptr);
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
  /// Returns why the guard is not running.
  std::string why_not_started() const;
  void watch_process() noexcept;
  /// Returns how the process of the guard has ended; std::nullopt while it lives.
  std::optional<siginfo_t> end_of_process() const noexcept;
  bool is_well() noexcept;
  void rescue(const siginfo_t& change) noexcept;
  /// Returns "the guard was ended by signal 11 (Segmentation fault)" or another end of its process.
  std::string end_text(const siginfo_t& change) const;
  std::string names_of_devices() const;
  void await(GuardState worst, std::int64_t limit, const std::atomic<bool>* interrupt = nullptr);

  GuardCall call_;
  Link link_;
  io::Descriptor life_;
  pid_t process_ = -1;
  std::atomic<bool> gone_{false}, finishing_{false};
  bool finished_ = false;  ///< whole
  siginfo_t change_{};  ///< end or stop of the process when it was gone; all 0 where it did not read in time
  std::thread process_watch_;  ///< sleeps until the guard has ended or is stopped
};

}  // namespace stepwire::guard
