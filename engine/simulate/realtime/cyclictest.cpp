#include "engine/simulate/realtime/cyclictest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/subprocess/process.hpp"

namespace stepwire::realtime {

namespace {

constexpr int max_us = 20'000;  // largest latency that its histogram resolves

/// Time limit in addition to the time of the measurement.
constexpr std::chrono::seconds patience{30};

}  // namespace

void CyclictestHistogram::add_line(const std::string& line) {
  std::istringstream words(line);
  std::int64_t latency = 0, times = 0;
  long most = 0;
  if (std::sscanf(line.c_str(), "# Max Latencies: %ld", &most) == 1)
    max_ = std::max<std::int64_t>(max_, most);
  if (std::sscanf(line.c_str(), "# Histogram Overflows: %ld", &most) == 1) count_ += most;
  if (!(words >> latency >> times) || latency < 0) return;
  const auto index = static_cast<std::size_t>(latency);
  if (index >= counts_.size()) counts_.resize(index + 1);
  counts_[index] += times;
  count_ += times;
}

std::int64_t CyclictestHistogram::quantile(double fraction) const {
  const double wanted = std::max(1.0, std::ceil(fraction * static_cast<double>(count_)));
  std::int64_t seen = 0;
  for (std::size_t latency = 0; latency < counts_.size(); ++latency) {
    seen += counts_[latency];
    if (static_cast<double>(seen) >= wanted) return static_cast<std::int64_t>(latency);
  }
  return max_;
}

Cyclictest::Cyclictest(double rate, const ThreadPolicy& policy, std::optional<int> cpu)
    : words_{"cyclictest",
             "-q",
             "-m",
             "-t1",
             fmt::format("-p{}", policy.fifo.value_or(0)),
             fmt::format("--policy={}", policy.fifo ? "fifo" : "other"),
             fmt::format("-i{}", std::llround(1e6 / rate)),
             fmt::format("-h{}", max_us)},
      period_(1.0 / rate) {
  if (cpu) words_.push_back(fmt::format("-a{}", *cpu));
  command_ = fmt::format("{}", fmt::join(words_, " "));
  if (subprocess::find_program(words_.front()).empty())
    throw io::EnvironmentError("cyclictest is not installed; on Debian it is in the package rt-tests");
}

void Cyclictest::run(std::int64_t wake_ups) {
  const std::int64_t before = histogram_.count();
  subprocess::ProcessCall call{.command = words_};
  call.command.push_back(fmt::format("-l{}", wake_ups));
  call.limit =
      patience + std::chrono::milliseconds(std::llround(1e3 * period_ * static_cast<double>(wake_ups)));
  const subprocess::ProcessResult result = subprocess::run_process(call);
  if (result.end == subprocess::ProcessResult::End::stopped)
    return;  // an interruption, which ends the loop too
  std::istringstream lines(result.output);
  for (std::string line; std::getline(lines, line);) histogram_.add_line(line);
  if (!result.succeeded() || histogram_.count() == before)
    throw io::EnvironmentError(
        fmt::format("cyclictest fails ({}); to see why: {} -l1", result.problem("it"), command_));
}

}  // namespace stepwire::realtime
