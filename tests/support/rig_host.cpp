#include "tests/support/rig_host.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

namespace stepwire {

namespace {

constexpr std::chrono::milliseconds period{10};

void redirect(int stream, const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(file, stream);
  ::close(file);
}

/// True for a process of this name whose parent is that one.
bool is_child(const std::filesystem::path& process, const std::string& name, int parent) {
  std::ifstream file(process / "stat");
  std::string number, in_brackets, state;
  int of = 0;
  return file >> number >> in_brackets >> state >> of && in_brackets == "(" + name + ")" && of == parent;
}

}  // namespace

RigHost::RigHost(const std::string& name, const std::string& stale)
    : device_(std::in_place, driver::load_driver(driver::driver_file("shared")),
              driver::Settings{{"name", name},
                               {"role", "host"},
                               {"inputs", "current in A"},
                               {"outputs", "force in N"},
                               {"stale", stale}}),
      current_(std::nan("")) {
  const double force = 0.0;
  device_->start(10'000'000, &force);
}

/// The amplifiers keep a stale value. Before the first command the memory has a zero, which is no current.
double RigHost::look() {
  std::this_thread::sleep_for(period);
  double current = 0.0;
  if (device_->read(&current) != STEPWIRE_FAILED && (current != 0.0 || !std::isnan(current_)))
    current_ = current;
  return current_;
}

double RigHost::step(double force) {
  look();
  device_->write(&force);
  return current_;
}

int RigHost::steps_until(double current, int most) {
  int steps = 0;
  while (steps <= most && step(1.0) != current) ++steps;
  return steps;
}

int RigHost::silent_until(double current, int most) {
  int steps = 0;
  while (steps <= most && look() != current) ++steps;
  return steps;
}

Beside::Beside(const std::string& program, const std::vector<std::string>& arguments,
               const std::string& folder) {
  process_ = ::fork();
  if (process_ != 0) return;
  if (::chdir(folder.c_str()) != 0) ::_exit(99);
  redirect(STDOUT_FILENO, ".out");
  redirect(STDERR_FILENO, ".err");
  std::vector<char*> all{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) all.push_back(const_cast<char*>(argument.c_str()));
  all.push_back(nullptr);
  ::execv(program.c_str(), all.data());
  ::_exit(99);
}

Beside::~Beside() {
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void Beside::send(int signal) const {
  ::kill(process_, signal);
}

int Beside::end() {
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int Beside::child(const std::string& name, int parent) const {
  for (int look = 0; look < 1000; ++look) {
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", none))
      if (is_child(entry.path(), name, parent > 0 ? parent : process_))
        return std::stoi(entry.path().filename().string());
    std::this_thread::sleep_for(period);
  }
  return 0;
}

}  // namespace stepwire
