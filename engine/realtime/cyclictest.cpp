#include "engine/realtime/cyclictest.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "engine/table/surroundings.hpp"

namespace stepwire {

namespace {

constexpr int most_us = 20'000;  // that its histogram tells apart

/// What a shell gives where it finds no such program.
constexpr int not_found = 127;

/// Calls `each` with the lines that a command prints; returns its exit code.
template <class Each>
int read_lines(const std::string& command, const Each& each) {
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (!pipe) return -1;
  std::array<char, 4096> line{};
  while (std::fgets(line.data(), line.size(), pipe)) each(std::string(line.data()));
  const int status = ::pclose(pipe);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

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
    : command_(fmt::format("cyclictest -q -m -t1 -p{} --policy={} -i{} -h{}{}", policy.fifo.value_or(0),
                           policy.fifo ? "fifo" : "other", std::llround(1e6 / rate), most_us,
                           cpu ? fmt::format(" -a{}", *cpu) : "")) {
  if (read_lines("command -v cyclictest", [](const std::string&) {}) == not_found)
    throw SurroundingsError("cyclictest is not installed; on Debian it is in the package rt-tests");
}

void Cyclictest::run(std::int64_t wake_ups) {
  const std::int64_t before = histogram_.count();
  const int code = read_lines(fmt::format("{} -l{} 2>/dev/null", command_, wake_ups),
                              [&](const std::string& line) { histogram_.add_line(line); });
  if (code != 0 || histogram_.count() == before)
    throw SurroundingsError(
        fmt::format("cyclictest fails (exit code {}); to see why: {} -l1", code, command_));
}

}  // namespace stepwire
