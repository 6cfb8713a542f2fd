#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulate/realtime/real_time_thread.hpp"

namespace stepwire::realtime {

/// Adds up what cyclictest of rt-tests prints as its histogram (options -q -h): lines of a latency in us,
/// which is its number cut off at whole us, and how often it was seen.
class CyclictestHistogram {
 public:
  void add_line(const std::string& line);

  std::int64_t count() const { return count_; }
  /// The latency [us] that the share `fraction` of all does not exceed; max() where that is beyond the
  /// histogram.
  std::int64_t quantile(double fraction) const;
  std::int64_t max() const { return max_; }
  /// How often each latency was seen, from 0 us on.
  const std::vector<std::int64_t>& counts() const { return counts_; }

 private:
  std::vector<std::int64_t> counts_;
  std::int64_t count_ = 0, max_ = 0;
};

/// Runs cyclictest at the rate and policy of a loop, so that both can be set side by side.
class Cyclictest {
 public:
  /// Throws EnvironmentError where the program is not installed.
  Cyclictest(double rate, const ThreadPolicy& policy, std::optional<int> cpu);

  /// So many wake-ups, added to what was measured before. Throws EnvironmentError where it fails.
  void run(std::int64_t wake_ups);
  const CyclictestHistogram& histogram() const { return histogram_; }
  /// The command, but for the number of wake-ups.
  const std::string& command() const { return command_; }

 private:
  std::vector<std::string> words_;
  std::string command_;
  double period_;  ///< [s]
  CyclictestHistogram histogram_;
};

}  // namespace stepwire::realtime
