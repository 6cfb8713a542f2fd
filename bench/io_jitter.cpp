// Measures the jitter from input to output of a loop at its device: this process is the device, and answers
// each command with a new sensor value, which the loop writes back. Without jitter that takes one period.
// Prints a row of a table, or a histogram.
#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/base/driver/open_device.hpp"

namespace {

using namespace stepwire;

double now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

const char* const diagram = R"(stepwire: 1
title: What is read is written
step: {} s
stop: 1 s
inputs: {{count: {{default: 0}}}}
outputs: {{echo: {{signal: echo, safe: 0}}}}
blocks: {{echo: {{block: Gain, u: count, gain: 1}}}}
record: [echo]
)";

const char* const rig = R"(devices: {{rig: {{driver: shared, stale: 100 s, name: {}}}}}
inputs: {{count: {{device: rig, channel: count}}}}
outputs: {{echo: {{device: rig, channel: echo, limits: [0, 1e9]}}}}
late: 1 s
guard: {}
)";

struct Call {
  std::string program, rate, seconds;
  bool guard = true, baseline = true, histogram = false;
};

std::vector<std::string> words_of(const Call& call) {
  std::vector<std::string> words{"stepwire", "loop",       "a.yaml",     "--io",  "rig.yaml", "--rate",
                                 call.rate,  "--duration", call.seconds, "--out", "out"};
  if (call.baseline) words.emplace_back("--baseline");
  return words;
}

pid_t start(const Call& call, const std::string& folder) {
  std::vector<std::string> words = words_of(call);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t process = ::fork();
  if (process != 0) return process;
  if (::chdir(folder.c_str()) != 0) ::_exit(99);
  ::dup2(::open("/dev/null", O_WRONLY), 1);
  ::execv(call.program.c_str(), pointers.data());
  ::_exit(99);
}

void sleep_until(double time) {
  const double whole = std::floor(time);
  const timespec until{static_cast<std::time_t>(whole), static_cast<long>(1e9 * (time - whole))};
  ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
}

/// Answers commands until the loop has ended, and leaves the processor to others where none can come. Returns
/// the times from answers to their echoes. Where the loop rests in between, its command is 0, and the time is
/// left out.
std::vector<double> echoes(driver::OpenDevice& device, pid_t loop, double period) {
  std::vector<double> times;
  double count = 1.0, echo = 0.0, answered = now();
  bool rested = true;
  device.write(&count);
  while (true) {
    device.read(&echo);
    const double time = now();
    rested = rested || echo == 0.0;
    if (echo == count) {
      if (!rested) times.push_back(time - answered);
      rested = false;
      ++count;
      device.write(&count);
      answered = now();
      sleep_until(answered + 0.7 * period);
    } else if (time - answered > 5.0 * period) {
      if (::waitpid(loop, nullptr, WNOHANG) != 0) return times;
      sleep_until(time + 1e-4);
    }
  }
}

/// Makes this process prompt, where the system allows that, below the loop and its guard.
void become_prompt() {
  sched_param parameter{};
  parameter.sched_priority = 60;
  ::sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &parameter);
  ::prctl(PR_SET_TIMERSLACK, 1);
}

double at(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

void print_histogram(const std::vector<double>& sorted, double period) {
  constexpr double width = 0.1;  // of a period
  for (double begin = 0.0; begin < 4.0; begin += width) {
    const auto inside = std::ranges::count_if(
        sorted, [&](double time) { return time >= begin * period && time < (begin + width) * period; });
    if (inside > 0) fmt::print("{:.1f} to {:.1f} periods: {}\n", begin, begin + width, inside);
  }
  fmt::print("more: {}\n", sorted.end() - std::ranges::lower_bound(sorted, 4.0 * period));
}

/// Prints a row: times from input to output less a period, and the wake-ups of cyclictest, in us.
void print_row(const Call& call, std::vector<double> times, const nlohmann::json& loop) {
  const double period = 1.0 / std::stod(call.rate);
  std::ranges::sort(times);
  const auto late = std::ranges::count_if(times, [&](double time) { return time > 1.5 * period; });
  fmt::print("| {} | {} | {} | {:.0f} | {:.0f} | {:.0f} | {} | {} |", call.rate, call.guard ? "yes" : "no",
             times.size(), 1e6 * (at(times, 0.5) - period), 1e6 * (at(times, 0.99) - period),
             1e6 * (at(times, 0.999) - period), late, loop["deadlines"]["missed"].get<int>());
  const nlohmann::json& baseline = loop["cyclictest"];
  if (baseline.is_object())
    fmt::print(" {} | {} | {} |\n", baseline["p50_us"].get<int>(), baseline["p99_us"].get<int>(),
               baseline["p99.9_us"].get<int>());
  else
    fmt::print(" - | - | - |\n");
  if (call.histogram) print_histogram(times, period);
  std::fflush(stdout);
}

void measure(const Call& call) {
  const std::string name = "stepwire-jitter-" + std::to_string(::getpid());
  const std::string folder = (std::filesystem::temp_directory_path() / name).string();
  std::filesystem::create_directory(folder);
  std::ofstream(folder + "/a.yaml") << fmt::format(fmt::runtime(diagram), 1.0 / std::stod(call.rate));
  std::ofstream(folder + "/rig.yaml") << fmt::format(fmt::runtime(rig), name, call.guard);
  driver::OpenDevice device(
      driver::load_driver(driver::driver_file("shared")),
      {{"name", name}, {"role", "host"}, {"inputs", "echo"}, {"outputs", "count"}, {"stale", "100 s"}});
  const double begin = 0.0;
  device.start(1'000'000, &begin);
  const std::vector<double> times = echoes(device, start(call, folder), 1.0 / std::stod(call.rate));
  std::ifstream file(folder + "/out/loop.json");
  if (!file || times.empty())
    fmt::print(stderr, "at {} Hz no loop has run to its end\n", call.rate);
  else
    print_row(call, times, nlohmann::json::parse(file));
  file.close();
  std::filesystem::remove_all(folder);
}

bool has_cyclictest() {
  return std::system("command -v cyclictest > /dev/null") == 0;
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments + 1, arguments + count);
  if (words.size() < 3) return fmt::print("io_jitter PROGRAM SECONDS RATE... [--histogram]\n"), 2;
  become_prompt();
  Call call{std::filesystem::absolute(words[0]), "", words[1]};
  call.histogram = words.back() == "--histogram";
  call.baseline = has_cyclictest();
  if (!call.baseline)
    fmt::print(stderr, "without cyclictest (Debian package rt-tests) there is no baseline\n");
  fmt::print(
      "| rate in Hz | guard | echoes | p50 in us | p99 | p99.9 | later than 1.5 periods | missed deadlines | "
      "cyclictest p50 | p99 | p99.9 |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const bool guard : {false, true})
    for (std::size_t i = 2; i < words.size() - (call.histogram ? 1 : 0); ++i) {
      call.guard = guard;
      call.rate = words[i];
      measure(call);
    }
}
