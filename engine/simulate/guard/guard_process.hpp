#pragma once

#include <sys/types.h>

#include <cstdint>
#include <thread>

#include "engine/simulate/guard/guard_call.hpp"
#include "engine/simulate/guard/link.hpp"

namespace stepwire::guard {

/// Process that has the devices of a loop, and outlives it.
///
/// A turn begins when the loop has written or has ended, and at the latest when inputs are to be read or the
/// loop is late. It checks, writes and reads; after a trip it writes the safe values. The process ends with
/// the loop, by a request or because the loop's end of `life` is closed.
class GuardProcess {
 public:
  /// Opens the devices. `keeper` is a child of this process. Throws EnvironmentError.
  GuardProcess(Link& link, int life, pid_t keeper);
  ~GuardProcess();
  /// Starts the devices at the request of the loop, and serves it until its end. Throws EnvironmentError.
  void serve();

 private:
  void start();
  /// After a trip no command counts, and no time is a deadline.
  bool expects_command() const { return active_ && !watch_.tripped(); }
  void await_turn();
  void turn(std::int64_t now);
  void take_command(std::int64_t now);
  void set_safe() noexcept;
  void read_devices(std::int64_t now);
  void announce_trip();
  void watch_life() noexcept;
  void finish();
  std::int64_t next_turn() const;

  Link& link_;
  int life_;
  pid_t keeper_;
  GuardCall call_;
  Watch watch_;
  Bank bank_;
  std::vector<double> inputs_, commands_;
  std::int64_t last_read_ = 0, next_read_ = 0;
  std::uint32_t seen_ = 0;
  bool announced_ = false, active_ = false, finished_ = false;
  std::thread life_watch_;  ///< sleeps until the loop has ended
};

/// Runs the guard of a link, whose memory and end of life are descriptors of this process. Returns its exit
/// status.
int run_guard(int memory, int life);

}  // namespace stepwire::guard
