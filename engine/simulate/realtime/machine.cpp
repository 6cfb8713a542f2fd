#include "engine/simulate/realtime/machine.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string_view>

namespace stepwire::realtime {

namespace {

using namespace std::string_view_literals;
/// Options of the kernel that change when a thread runs.
constexpr std::array timing_keys{"isolcpus"sv,
                                 "nohz"sv,
                                 "nohz_full"sv,
                                 "rcu_nocbs"sv,
                                 "rcu_nocb_poll"sv,
                                 "mitigations"sv,
                                 "preempt"sv,
                                 "threadirqs"sv,
                                 "irqaffinity"sv,
                                 "idle"sv,
                                 "intel_idle.max_cstate"sv,
                                 "processor.max_cstate"sv,
                                 "intel_pstate"sv,
                                 "cpuidle.off"sv,
                                 "nosmt"sv,
                                 "clocksource"sv,
                                 "tsc"sv,
                                 "nowatchdog"sv,
                                 "skew_tick"sv,
                                 "kthread_cpus"sv};

std::string first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

/// Returns the first value of a key in /proc/cpuinfo.
std::string of_processor(const std::string& key) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(':');
    if (!line.starts_with(key) || colon == std::string::npos) continue;
    return line.substr(std::min(line.size(), colon + 2));
  }
  return {};
}

}  // namespace

std::string timing_words(const std::string& line) {
  std::istringstream words(line);
  std::string found;
  for (std::string word; words >> word;)
    if (std::ranges::find(timing_keys, std::string_view(word).substr(0, word.find('='))) != timing_keys.end())
      found += (found.empty() ? "" : " ") + word;
  return found;
}

Machine Machine::here() {
  const std::string system = "/sys/devices/system/";
  Machine machine;
  machine.processor = of_processor("model name");
  machine.processors = static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN));
  machine.virtual_machine = (of_processor("flags") + " ").find(" hypervisor ") != std::string::npos;
  utsname names{};
  if (::uname(&names) == 0) machine.kernel = std::string(names.release) + " " + names.version;
  machine.kernel_line = timing_words(first_line("/proc/cmdline"));
  machine.governor = first_line(system + "cpu/cpu0/cpufreq/scaling_governor");
  machine.clock_source = first_line(system + "clocksource/clocksource0/current_clocksource");
  machine.isolated = first_line(system + "cpu/isolated");
  return machine;
}

}  // namespace stepwire::realtime
