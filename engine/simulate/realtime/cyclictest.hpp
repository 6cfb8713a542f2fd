#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulate/realtime/real_time_thread.hpp"

namespace stepwire::realtime {

/// Sum of the histograms that cyclictest of rt-tests prints (options -q -h): lines of a latency, truncated to
/// whole us, and its count.
class CyclictestHistogram {
 public:
  void add_line(const std::string& line);

  std::int64_t count() const { return count_; }
  /// Returns the smallest latency [us] that at least `fraction` of all do not exceed; max() if it is beyond
  /// the histogram.
  std::int64_t quantile(double fraction) const;
  std::int64_t max() const { return max_; }
  /// Returns the count of each latency, from 0 us.
  const std::vector<std::int64_t>& counts() const { return counts_; }

 private:
  std::vector<std::int64_t> counts_;
  std::int64_t count_ = 0, max_ = 0;
};

/// Runs cyclictest at the rate and policy of a loop, so that the two can be compared.
class Cyclictest {
 public:
  /// Throws EnvironmentError if the program is not installed.
  Cyclictest(double rate, const ThreadPolicy& policy, std::optional<int> cpu);

  /// Measures `wake_ups` more wake-ups. Throws EnvironmentError on failure.
  void run(std::int64_t wake_ups);
  const CyclictestHistogram& histogram() const { return histogram_; }
  /// Returns the command without the number of wake-ups.
  const std::string& command() const { return command_; }

 private:
  std::vector<std::string> words_;
  std::string command_;
  double period_;  ///< [s]
  CyclictestHistogram histogram_;
};

}  // namespace stepwire::realtime
