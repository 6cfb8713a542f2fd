#include "tests/engine/app/cli/program.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <thread>

namespace {

using Clock = std::chrono::steady_clock;
constexpr double longest = 60.0;  // [s]; a program that hangs is a failed test, not a test that hangs

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void redirect(int stream, const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(file, stream);
  ::close(file);
}

void close_output() {
  int ends[2];
  if (::pipe(ends) != 0) ::_exit(99);
  ::close(ends[0]);
  ::dup2(ends[1], STDOUT_FILENO);
  ::close(ends[1]);
}

[[noreturn]] void become(const Scratch& folder, const Call& call) {
  for (const auto& [name, value] : call.environment)
    value ? ::setenv(name.c_str(), value->c_str(), 1) : ::unsetenv(name.c_str());
  if (::chdir(folder.path("").c_str()) != 0) ::_exit(99);
  if (call.max_bytes_of_file) {
    const rlimit limit{*call.max_bytes_of_file, *call.max_bytes_of_file};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  redirect(STDOUT_FILENO, call.out_to.empty() ? folder.path(".out") : call.out_to);
  redirect(STDERR_FILENO, call.err_to.empty() ? folder.path(".err") : call.err_to);
  for (const int stream : call.closed) ::close(stream);
  if (call.no_threads) {  // a thread's stack is as large as this allows, and no memory is
    const rlimit huge{rlim_t{1} << 46, RLIM_INFINITY};
    ::setrlimit(RLIMIT_STACK, &huge);
  }
  if (call.closed_pipe) close_output();
  std::vector<char*> arguments{const_cast<char*>("stepwire")};
  for (const std::string& argument : call.arguments) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  ::execv(STEPWIRE_PROGRAM, arguments.data());
  ::_exit(99);
}

bool is_time(const Call& call, double waited) {
  if (!call.interrupt_when.empty()) return std::filesystem::exists(call.interrupt_when);
  return call.interrupt_after && waited > *call.interrupt_after;
}

int await(pid_t child, const Call& call, rusage& usage) {
  const auto start = Clock::now();
  bool interrupted = false;
  int status = 0;
  while (::wait4(child, &status, WNOHANG, &usage) == 0) {
    const double waited = seconds_since(start);
    if (!interrupted && is_time(call, waited)) {
      interrupted = true;
      for (const int signal : call.signals) ::kill(child, signal);
    }
    if (waited > longest) ::kill(child, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return status;
}

}  // namespace

Done run_program(const Scratch& folder, const Call& call) {
  const auto start = Clock::now();
  const pid_t child = ::fork();
  if (child == 0) become(folder, call);
  rusage usage{};
  const int status = await(child, call, usage);
  Done done;
  done.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  done.seconds = seconds_since(start);
  done.megabytes = static_cast<double>(usage.ru_maxrss) / 1024.0;
  done.out = content_of(folder.path(".out"));
  done.err = content_of(folder.path(".err"));
  return done;
}

Done run_program(const Scratch& folder, const std::vector<std::string>& arguments) {
  Call call;
  call.arguments = arguments;
  return run_program(folder, call);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string content_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

const std::string lag_yaml = R"(stepwire: 1
title: A lag follows a constant
step: 1 ms
stop: 0.5 s
solver: rk4
parameters:
  tau: {value: 0.1 s, doc: time constant}
blocks:
  reference: {block: Constant, value: 1.0}
  lag: {block: Lag, u: reference, tau: $tau}
record: [reference, lag]
figure: {plot: lines, x: time, y: lag}
claims:
  - {that: the lag gets there, final: lag, at_least: 0.9}
)";

const std::string endless_yaml = R"(stepwire: 1
title: A lag without end
step: 1 ms
stop: 10000000 s
solver: rk4
blocks:
  wave: {block: Sine, amplitude: 1, frequency: 1 Hz}
  lag: {block: Lag, u: wave, tau: 0.1 s}
record: {every: 100 s, signals: [lag]}
)";
