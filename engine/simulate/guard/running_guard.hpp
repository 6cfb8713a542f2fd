#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>

#include "engine/simulate/guard/guard_call.hpp"
#include "engine/simulate/guard/link.hpp"

namespace stepwire::guard {

/// Guard of this process, as its loop uses it. command() and inputs() neither allocate nor wait.
class RunningGuard {
 public:
  /// Starts the guard and waits until its devices are started. Throws EnvironmentError with its reason.
  explicit RunningGuard(const GuardCall& call);
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
  /// True once the guard has ended or its turns have stopped; the devices are then without a guard.
  bool is_gone() const { return gone_; }
  pid_t process() const { return process_; }

 private:
  void spawn();
  bool is_well() noexcept;
  void await(GuardState worst, std::int64_t limit);

  Link link_;
  std::int64_t late_;
  io::Descriptor life_;
  pid_t process_ = -1;
  std::uint64_t turns_ = 0;
  std::int64_t turned_ = 0;  ///< time at which the last turn was seen [ns]
  bool gone_ = false;
};

}  // namespace stepwire::guard
