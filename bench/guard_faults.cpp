// Injects faults into a guarded loop, and measures at the device how long its output is neither safe nor
// renewed. Prints a table.
#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "engine/base/driver/open_device.hpp"

namespace {

using namespace stepwire;

constexpr double safe = 0.125;    // [A]
constexpr double longest = 60.0;  // [s]
constexpr double run_in = 0.1;    // before a fault [s]
constexpr double watched = 0.3;   // after a fault that lets the loop go on [s]

double now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Triggers of the block Trap.
enum Trap { no_trap = 0, not_a_number = 1, endless = 2 };

const char* const block = R"(#pragma once
#include <stepwire/block.hpp>
struct Trap {
  stepwire::Input<1> u{}, trigger{};
  stepwire::Output<1> y{};
  void outputs() {
    for (volatile bool on = trigger > 1.5; on;) {}
    y = trigger > 0.5 ? 0.0 / 0.0 : 0.5 * u;
  }
  static void declare(stepwire::Declare<Trap>& is);
};
)";
const char* const declaration = R"(#include "trap.hpp"
#include <stepwire/declare.hpp>
#include <stepwire/registry.hpp>
void Trap::declare(stepwire::Declare<Trap>& is) {
  is.block("Trap", {.doc = "Half of its input, no number, or a step without end."});
  is.input<&Trap::u>({.unit = "1", .doc = "signal"});
  is.input<&Trap::trigger>({.unit = "1", .doc = "1: no number, 2: no end"});
  is.output<&Trap::y>({.unit = "1", .doc = "half of the signal"});
}
void register_blocks(stepwire::Registry& registry) { registry.add<Trap>("traps"); }
)";
const char* const diagram = R"(stepwire: 1
title: A coil that follows a force
step: {} s
stop: 1 s
inputs: {{force: {{unit: N, default: 1 N}}, trigger: {{unit: "1", default: 0}}}}
outputs: {{current: {{signal: coil, unit: A, safe: 0.125 A}}}}
blocks:
  share: {{block: Gain, u: force, gain: 1 1/N}}
  trap: {{block: Trap, u: share, trigger: trigger}}
  coil: {{block: Gain, u: trap, gain: 1 A}}
record: [coil]
)";
const char* const rig = R"(devices: {{rig: {{{}, stale: {} s}}}}
inputs:
  force: {{device: rig, channel: force, range: [-4 N, 4 N], rate: 100 N/s, stuck: {} s}}
  trigger: {{device: rig, channel: trigger}}
outputs: {{current: {{device: rig, channel: current, limits: [-1 A, 1 A]}}}}
)";

/// How a loop reaches the device: its driver, and the settings of both sides.
struct Way {
  const char* driver;
  std::string of_loop;
  driver::Settings of_host;
};

/// Device of a rig, in this process. It offers a force that changes at each look.
class Host {
 public:
  explicit Host(const Way& way)
      : device_(driver::load_driver(driver::driver_file(way.driver)), settings(way)) {
    device_.start(1'000'000, values);
  }
  double look() {
    double current = 0.0;
    device_.read(&current);
    if (moves) values[0] = 1.0 + 0.2 * std::sin(6.0 * now());
    if (offers) device_.write(values);
    return current;
  }
  /// Returns the time until the current is safe, or is that of a loop [s]; infinite if it is not in time.
  double until(bool is_safe) {
    const double begin = now();
    for (double current = look(); is_safe ? current != safe : current == safe || current == 0.0;
         current = look()) {
      if (now() - begin > longest) return HUGE_VAL;
      ::usleep(50);
    }
    return now() - begin;
  }
  /// Returns the longest time within a duration in which the current was neither safe nor another [s].
  double longest_hold(double duration) {
    const double begin = now();
    double last = look(), changed = begin, hold = 0.0;
    while (now() - begin < duration) {
      const double current = look();
      if (current != last) changed = now();
      last = current;
      if (current != safe) hold = std::max(hold, now() - changed);
      ::usleep(50);
    }
    return hold;
  }

  double values[2] = {1.0, no_trap};
  bool offers = true, moves = true;

 private:
  static driver::Settings settings(const Way& way) {
    driver::Settings all{{"inputs", "current in A"}, {"outputs", "force in N, trigger"}, {"stale", "100 s"}};
    all.insert(all.end(), way.of_host.begin(), way.of_host.end());
    return all;
  }

  driver::OpenDevice device_;
};

struct Place {
  std::string program, folder, rate;
};

/// File with what the loop prints.
std::string report_file(const Place& place) {
  return place.folder + "/report.txt";
}

pid_t start(const Place& place) {
  const pid_t process = ::fork();
  if (process != 0) return process;
  const int report = ::open(report_file(place).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::dup2(report, 1);
  ::dup2(report, 2);
  std::signal(SIGXFSZ, SIG_IGN);
  const sched_param normal{};
  ::sched_setscheduler(0, SCHED_OTHER, &normal);
  if (::chdir(place.folder.c_str()) != 0) ::_exit(99);
  ::execl(place.program.c_str(), "stepwire", "loop", "a.yaml", "--blocks", "traps", "--io", "rig.yaml",
          "--rate", place.rate.c_str(), "--duration", "60", "--out", "out", nullptr);
  ::_exit(99);
}

/// Lets the measurement run before the loop and its guard.
void become_first() {
  sched_param parameter{};
  parameter.sched_priority = 95;
  if (::sched_setscheduler(0, SCHED_FIFO, &parameter) != 0)
    fmt::print(stderr, "the measurement has no real-time priority; its times are too long under load\n");
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

/// Two threads for each processor that never wait, as long as it lives.
class Load {
 public:
  Load() {
    for (unsigned i = 0; i < 2 * std::thread::hardware_concurrency(); ++i)
      threads_.emplace_back([this] {
        const sched_param normal{};
        ::sched_setscheduler(0, SCHED_OTHER, &normal);
        while (!ended_) {
        }
      });
  }
  ~Load() {
    ended_ = true;
    for (std::thread& one : threads_) one.join();
  }

 private:
  std::atomic<bool> ended_{false};
  std::vector<std::thread> threads_;
};

/// Files can no longer grow.
void fill_disk(pid_t loop) {
  const rlimit none{0, 0};
  ::prlimit(loop, RLIMIT_FSIZE, &none, nullptr);
}

/// Fault, and the time that it takes at the device [s].
struct Fault {
  const char* name;
  std::function<double(Host&, pid_t)> time;
  bool by_udp = false;
};

/// Fault after which the output must become safe.
Fault ends(const char* name, std::function<void(Host&, pid_t)> inject, bool by_udp = false) {
  return {name,
          [inject](Host& host, pid_t loop) {
            inject(host, loop);
            return host.until(true);
          },
          by_udp};
}

std::vector<Fault> all_faults() {
  return {ends("loop killed", [](Host&, pid_t loop) { ::kill(loop, SIGKILL); }),
          ends("loop stopped", [](Host&, pid_t loop) { ::kill(loop, SIGSTOP); }),
          ends("endless step", [](Host& host, pid_t) { host.values[1] = endless; }),
          ends("output not finite", [](Host& host, pid_t) { host.values[1] = not_a_number; }),
          ends("guard killed", [](Host&, pid_t loop) { ::kill(guard_of(loop), SIGKILL); }),
          ends("loop and guard killed",
               [](Host&, pid_t loop) {
                 ::kill(guard_of(loop), SIGKILL);
                 ::kill(loop, SIGKILL);
               }),
          ends("guard stopped", [](Host&, pid_t loop) { ::kill(guard_of(loop), SIGSTOP); }),
          ends("sensor not finite",
               [](Host& host, pid_t) {
                 host.moves = false;
                 host.values[0] = std::nan("");
               }),
          ends("sensor jumps",
               [](Host& host, pid_t) {
                 host.moves = false;
                 host.values[0] = 3.0;
               }),
          ends("sensor out of range",
               [](Host& host, pid_t) {
                 host.moves = false;
                 host.values[0] = 5.0;
               }),
          ends("sensor stuck", [](Host& host, pid_t) { host.moves = false; }),
          ends("device silent", [](Host& host, pid_t) { host.offers = false; }),
          ends(
              "packets end", [](Host& host, pid_t) { host.offers = false; }, true),
          {"full disk",
           [](Host& host, pid_t loop) {
             fill_disk(loop);
             return host.longest_hold(watched);
           }},
          {"load of 100 %", [](Host& host, pid_t) {
             const Load load;
             return host.longest_hold(watched);
           }}};
}

void print(const char* name, std::vector<double> times, double period) {
  std::ranges::sort(times);
  const auto within = std::ranges::count_if(times, [&](double time) { return time <= 2.0 * period; });
  const auto at = [&](double share) {
    return 1e3 * times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
  };
  fmt::print("| {} | {} | {} | {:.2f} | {:.2f} | {:.2f} |\n", name, times.size(), within, at(0.5), at(0.99),
             at(1.0));
  std::fflush(stdout);
}

/// Ends a loop and its guard, which is this process' child then, so that an exclusive device is free.
void end(pid_t loop) {
  const pid_t guard = guard_of(loop);
  ::kill(loop, SIGKILL);
  ::waitpid(loop, nullptr, 0);
  if (guard <= 0) return;
  ::kill(guard, SIGCONT);
  ::waitpid(guard, nullptr, 0);
  while (::waitpid(-1, nullptr, WNOHANG) > 0) {
  }
}

/// Returns the time of a fault; std::nullopt where the loop has ended before it.
std::optional<double> time_of_try(const Fault& fault, const Way& way, const Place& place) {
  Host host(way);
  const pid_t loop = start(place);
  if (std::isinf(host.until(false))) fmt::print(stderr, "{}: a loop has not begun\n", fault.name);
  host.longest_hold(run_in);
  std::optional<double> time;
  if (guard_of(loop) > 0) time = fault.time(host, loop);
  end(loop);
  return time;
}

/// Returns the time of a fault. A loop that has ended before its fault is replaced by another one, and its
/// report is printed.
double time_of(const Fault& fault, const Way& way, const Place& place) {
  for (;;) {
    if (const auto time = time_of_try(fault, way, place)) return *time;
    std::ifstream report(report_file(place));
    const std::string text(std::istreambuf_iterator<char>(report), {});
    fmt::print(stderr, "{}: a loop has ended before its fault\n{}\n", fault.name, text);
  }
}

void write_files(const std::string& folder, double period) {
  std::filesystem::create_directories(folder + "/traps");
  std::ofstream(folder + "/traps/trap.hpp") << block;
  std::ofstream(folder + "/traps/register.cpp") << declaration;
  std::ofstream(folder + "/a.yaml") << fmt::format(fmt::runtime(diagram), period);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) return fmt::print("guard_faults PROGRAM RATE TRIES [FAULT ...]\n"), 2;
  const double period = 1.0 / std::atof(arguments[2]);
  const std::string name = "stepwire-bench-" + std::to_string(::getpid());
  const Place place{std::filesystem::absolute(arguments[1]), std::filesystem::temp_directory_path() / name,
                    arguments[2]};
  write_files(place.folder, period);
  become_first();
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  const int port = 20'000 + ::getpid() % 20'000;
  const Way shared{"shared", "driver: shared, name: " + name, {{"name", name}, {"role", "host"}}};
  const Way udp{
      "udp",
      fmt::format("driver: udp, listen: \"127.0.0.1:{}\", to: \"127.0.0.1:{}\", inputs: \"force in N, "
                  "trigger\", outputs: current in A",
                  port, port + 1),
      {{"listen", fmt::format("127.0.0.1:{}", port + 1)}, {"to", fmt::format("127.0.0.1:{}", port)}}};
  fmt::print(
      "| fault | tries | safe within two periods | p50 in ms | p99 | longest |\n|---|---|---|---|---|---|\n");
  for (const Fault& fault : all_faults()) {
    const auto is_named = [&](const char* one) { return std::string(one) == fault.name; };
    if (count > 4 && std::none_of(arguments + 4, arguments + count, is_named)) continue;
    const Way& way = fault.by_udp ? udp : shared;
    std::ofstream(place.folder + "/rig.yaml")
        << fmt::format(fmt::runtime(rig), way.of_loop, period, 0.9 * period);
    std::vector<double> times;
    for (int i = 0; i < std::atoi(arguments[3]); ++i) times.push_back(time_of(fault, way, place));
    print(fault.name, times, period);
  }
  std::filesystem::remove_all(place.folder);
}
