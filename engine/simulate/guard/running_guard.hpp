#pragma once

#include <sys/types.h>

#include <atomic>
#include <csignal>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "engine/simulate/guard/guard_call.hpp"
#include "engine/simulate/guard/link.hpp"

namespace stepwire::guard {

/// Guard of this process, as its loop uses it. command() and inputs() neither allocate nor wait.
///
/// A guard that has ended, is stopped or does not read the devices in time is killed, and a thread of this
/// process sets the outputs to their safe values. The first two are noticed at once. A driver that does not
/// return then keeps that thread, which finish() leaves after some seconds.
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
  /// Returns the last inputs, the ones before where the guard lost its processor while it wrote them. False
  /// once the guard has tripped or is gone.
  bool inputs(double* values) noexcept;
  bool command(const double* values) noexcept;
  void rest() noexcept { link_.beat(GuardRequest::rest); }
  /// Ends the guard and returns the counts of its devices.
  std::string finish();
  /// Returns why the guard ended the use of the devices; "" if it has not.
  std::string trouble() const;
  pid_t process() const { return process_; }

 private:
  /// Content that the thread needs longer than this object where a driver does not return.
  struct Shared {
    explicit Shared(GuardCall of);

    GuardCall call;
    Link link;
    pid_t process = -1;
    std::atomic<bool> gone{false}, late{false}, finishing{false};
    std::atomic<bool> watched{false};  ///< the thread has ended
    siginfo_t change{};  ///< end or stop of the process when it was gone; all 0 where it did not read in time
  };

  void spawn();
  /// Returns why the guard is not running.
  std::string why_not_started() const;
  /// Waits for the end or a stop of the guard, and then sets the safe values in its place.
  static void watch_process(Shared& shared) noexcept;
  static void rescue(Shared& shared, const siginfo_t& change) noexcept;
  /// Returns how a process of this one has ended; std::nullopt while it lives.
  static std::optional<siginfo_t> end_of(pid_t process) noexcept;
  bool is_well() noexcept;
  void end_watch();
  void end_process();
  /// Returns "the guard was ended by signal 11 (Segmentation fault)" or another end of its process.
  std::string end_text(const siginfo_t& change) const;
  std::string names_of_devices() const;
  std::string text_of_unfinished() const;
  void await_safe() const;
  void await(GuardState worst, std::int64_t limit, const std::atomic<bool>* interrupt = nullptr);

  std::shared_ptr<Shared> shared_;
  const GuardCall& call_;
  Link& link_;
  std::vector<double> inputs_, read_;  ///< the last whole ones; those of the present call
  io::Descriptor life_;
  pid_t process_ = -1;
  bool finished_ = false;      ///< whole
  bool overdue_ = false;       ///< killed at the end
  std::thread process_watch_;  ///< sleeps until the guard has ended or is stopped
};

}  // namespace stepwire::guard
