// Injects faults into a guarded loop, and measures at the device how long its output is not safe. Prints a
// table.
#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/driver/open_device.hpp"

namespace {

using namespace stepwire;

constexpr double wanted = 0.5, safe = 0.125;  // [A]
constexpr double longest = 20.0;              // [s]

double now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

const char* const diagram = R"(stepwire: 1
title: A coil that follows a force
step: {} s
stop: 1 s
inputs: {{force: {{unit: N, default: 1 N}}}}
outputs: {{current: {{signal: coil, unit: A, safe: 0.125 A}}}}
blocks: {{coil: {{block: Gain, u: force, gain: 0.5 A/N}}}}
record: [coil]
)";

const char* const rig = R"(devices: {{rig: {{driver: shared, stale: {} s, name: {}}}}}
inputs: {{force: {{device: rig, channel: force, range: [-4 N, 4 N], rate: 100 N/s}}}}
outputs: {{current: {{device: rig, channel: current, limits: [-1 A, 1 A]}}}}
)";

/// Device of a rig, in this process. It offers a force at each look.
class Host {
 public:
  explicit Host(const std::string& name)
      : device_(driver::load_driver(driver::driver_file("shared")), {{"name", name},
                                                                     {"role", "host"},
                                                                     {"inputs", "current in A"},
                                                                     {"outputs", "force in N"},
                                                                     {"stale", "100 s"}}) {
    device_.start(1'000'000, &force);
  }
  double look() {
    double current = 0.0;
    device_.read(&current);
    if (offers) device_.write(&force);
    return current;
  }
  /// Returns the time until the current has this value [s]; infinite if it has not in time.
  double until(double current) {
    const double begin = now();
    while (look() != current) {
      if (now() - begin > longest) return HUGE_VAL;
      ::usleep(50);
    }
    return now() - begin;
  }

  double force = 1.0;
  bool offers = true;

 private:
  driver::OpenDevice device_;
};

pid_t start(const std::string& program, const std::string& folder, const std::string& rate) {
  const pid_t process = ::fork();
  if (process != 0) return process;
  const int none = ::open("/dev/null", O_WRONLY);
  ::dup2(none, 1);
  ::dup2(none, 2);
  if (::chdir(folder.c_str()) != 0) ::_exit(99);
  ::execl(program.c_str(), "stepwire", "loop", "a.yaml", "--io", "rig.yaml", "--rate", rate.c_str(),
          "--duration", "60", nullptr);
  ::_exit(99);
}

/// Returns the guard of a loop: its child of that name.
pid_t guard_of(pid_t loop) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "stat");
    std::string number, name, state;
    pid_t parent = 0;
    if (file >> number >> name >> state >> parent && name == "(stepwire_guard)" && parent == loop)
      return std::stoi(number);
  }
  return 0;
}

struct Fault {
  const char* name;
  std::function<void(Host&, pid_t)> inject;
};

void print(const char* name, std::vector<double> times, double period) {
  std::ranges::sort(times);
  const auto within = std::ranges::count_if(times, [&](double time) { return time <= 2.0 * period; });
  const auto at = [&](double share) {
    return 1e3 * times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
  };
  fmt::print("| {} | {} | {} | {:.2f} | {:.2f} | {:.2f} |\n", name, times.size(), within, at(0.5), at(0.99),
             at(1.0));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return fmt::print("guard_faults PROGRAM RATE TRIES\n"), 2;
  const double period = 1.0 / std::atof(arguments[2]);
  const std::string name = "stepwire-bench-" + std::to_string(::getpid());
  const std::string folder = (std::filesystem::temp_directory_path() / name).string();
  std::filesystem::create_directory(folder);
  std::ofstream(folder + "/a.yaml") << fmt::format(fmt::runtime(diagram), period);
  std::ofstream(folder + "/rig.yaml") << fmt::format(fmt::runtime(rig), period, name);
  const std::vector<Fault> faults{
      {"loop killed", [](Host&, pid_t loop) { ::kill(loop, SIGKILL); }},
      {"loop stopped", [](Host&, pid_t loop) { ::kill(loop, SIGSTOP); }},
      {"guard killed", [](Host&, pid_t loop) { ::kill(guard_of(loop), SIGKILL); }},
      {"guard stopped", [](Host&, pid_t loop) { ::kill(guard_of(loop), SIGSTOP); }},
      {"sensor not finite", [](Host& host, pid_t) { host.force = std::nan(""); }},
      {"sensor jumps", [](Host& host, pid_t) { host.force = 3.0; }},
      {"sensor out of range", [](Host& host, pid_t) { host.force = 5.0; }},
      {"device silent", [](Host& host, pid_t) { host.offers = false; }}};
  fmt::print(
      "| fault | tries | safe within two periods | p50 in ms | p99 | longest |\n|---|---|---|---|---|---|\n");
  for (const Fault& fault : faults) {
    std::vector<double> times;
    for (int i = 0; i < std::atoi(arguments[3]); ++i) {
      Host host(name);
      const pid_t loop = start(std::filesystem::absolute(arguments[1]), folder, arguments[2]);
      if (std::isinf(host.until(wanted))) fmt::print(stderr, "{}: a loop has not begun\n", fault.name);
      fault.inject(host, loop);
      times.push_back(host.until(safe));
      const pid_t guard = guard_of(loop);
      ::kill(loop, SIGKILL);
      ::waitpid(loop, nullptr, 0);
      if (guard > 0) ::kill(guard, SIGCONT);
    }
    print(fault.name, times, period);
    std::fflush(stdout);
  }
  std::filesystem::remove_all(folder);
}
