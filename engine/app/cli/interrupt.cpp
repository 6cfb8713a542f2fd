#include "engine/app/cli/interrupt.hpp"

#include <unistd.h>

#include <csignal>

#include "engine/base/io/leftovers.hpp"
#include "engine/base/subprocess/process.hpp"

namespace stepwire::cli {

namespace {

constexpr int code_of_interrupted = 130;

// Globals, because a signal handler gets no context.
std::atomic<bool> flag = false;
std::atomic<int> delays_of_first = 0, delays_of_all = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void handle(int signal) {
  subprocess::processes_stop() = true;
  const bool is_first = !flag.exchange(true);
  if ((is_first && delays_of_first > 0) || delays_of_all > 0) return;
  io::remove_leftovers();
  if (is_first) ::_exit(code_of_interrupted);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void catch_signal(int signal) {
  struct sigaction action {};
  action.sa_handler = handle;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int other : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&action.sa_mask, other);
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

void end_at_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    if (signal == SIGHUP && action.sa_handler == SIG_IGN) continue;  // under nohup
    action.sa_handler = [](int) { ::_exit(code_of_interrupted); };
    ::sigaction(signal, &action, nullptr);
  }
}

const std::atomic<bool>& interrupted() {
  return flag;
}

void catch_signals() {
  subprocess::processes_stop() = false;  // constructs the static object before a handler uses it
  for (const int signal : {SIGINT, SIGTERM}) catch_signal(signal);
  struct sigaction known {};
  ::sigaction(SIGHUP, nullptr, &known);
  if (known.sa_handler != SIG_IGN) catch_signal(SIGHUP);  // SIGHUP stays ignored under nohup
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

EndDelay::EndDelay(Signals signals) : count_(signals == Signals::first ? delays_of_first : delays_of_all) {
  ++count_;
}

EndDelay::~EndDelay() {
  --count_;
}

}  // namespace stepwire::cli
