#include "engine/simulate/guard/guard_process.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

#include "engine/base/io/environment_error.hpp"
#include "engine/simulate/guard/keeper.hpp"

namespace stepwire::guard {

namespace {

constexpr std::int64_t longest_look = 100'000;         // before and after the expected time of a command [ns]
constexpr std::int64_t longest_sleep = 1'000'000'000;  // [ns]

std::string joined(const std::vector<std::string>& lines) {
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace

GuardProcess::GuardProcess(Link& link, int life, pid_t keeper)
    : link_(link),
      life_(life),
      keeper_(keeper),
      call_(guard_call(link.call())),
      watch_(call_.limits),
      bank_(call_.devices) {
  if (bank_.inputs() != call_.limits.inputs.size() || bank_.outputs() != call_.limits.outputs.size())
    throw io::EnvironmentError("the devices have other channels than before");
  inputs_.assign(bank_.inputs(), 0.0);
  commands_.assign(bank_.outputs(), 0.0);
  bank_.use(call_.uses);
}

GuardProcess::~GuardProcess() {
  if (!life_watch_.joinable()) return;
  ::shutdown(life_, SHUT_RD);
  life_watch_.join();
}

void GuardProcess::serve() {
  become_prompt(call_.priority);
  life_watch_ = std::thread([this] { watch_life(); });
  while (link_.beats() == seen_) link_.await_beat(seen_, monotonic() + longest_sleep);
  if (link_.request() == GuardRequest::start) start();
  while (!finished_) {
    await_turn();
    turn(monotonic());
  }
  finish();
}

/// Each further request ends the wait for the first values.
void GuardProcess::start() {
  seen_ = link_.beats();
  bank_.start(call_.limits.period, watch_.safe());
  bank_.safe();
  bank_.await_values(call_.wait, [this] { return link_.beats() == seen_; });
  if (link_.beats() != seen_) return;
  read_devices(monotonic());
  link_.tell(GuardState::running, "");
}

/// Looks without sleep around the expected time of a command: to wake a process takes the loop longer than
/// its step.
void GuardProcess::await_turn() {
  const std::int64_t period = call_.limits.period, until = next_turn();
  const std::int64_t expected = watch_.next_check() - call_.limits.late + period;
  const std::int64_t margin = std::min(longest_look, period / 4);
  if (expects_command() && until > expected - margin) {
    if (monotonic() < expected - margin) link_.await_beat(seen_, expected - margin);
    link_.look_for_beat(seen_, std::min(until, expected + margin));
  }
  link_.await_beat(seen_, until);
}

/// Inputs are read three quarters of a period after a command, so that they are new when the loop wakes.
/// Where the wake-ups for that come too late, commands do not put a read off for more than two periods.
std::int64_t GuardProcess::next_turn() const {
  return expects_command() ? std::min(next_read_, watch_.next_check() + 1) : next_read_;
}

void GuardProcess::turn(std::int64_t now) {
  const std::uint32_t beats = link_.beats();
  if (beats != seen_) {
    seen_ = beats;
    take_command(now);
  } else if (active_) {
    watch_.waited(now);
  } else {
    set_safe();  // the other side may wait for the next values
  }
  if (now >= next_read_) read_devices(now);
  if (watch_.tripped()) announce_trip();
}

void GuardProcess::take_command(std::int64_t now) {
  const GuardRequest request = link_.request();
  finished_ = request == GuardRequest::finish || request == GuardRequest::gone;
  active_ = request == GuardRequest::command;
  next_read_ = std::min(now + 3 * call_.limits.period / 4, last_read_ + 3 * call_.limits.period / 2);
  if (!active_) {
    watch_.rest();
    set_safe();
  } else if (!watch_.tripped() && link_.commands().get(commands_.data())) {
    watch_.commanded(now, commands_.data());
    if (watch_.tripped()) return;
    link_.note_outputs(Outputs::live);
    watch_.accept(bank_.write(watch_.outputs()), bank_.culprit());
  }
}

void GuardProcess::set_safe() noexcept {
  if (link_.outputs() == Outputs::live) link_.note_outputs(Outputs::becoming);
  const int result = bank_.safe();
  watch_.accept(result, bank_.culprit());
  if (result != STEPWIRE_FAILED) link_.note_outputs(Outputs::safe);
}

void GuardProcess::read_devices(std::int64_t now) {
  watch_.accept(bank_.read(inputs_.data()), bank_.culprit());
  watch_.sensed(now, inputs_.data());
  link_.inputs().put(inputs_.data());
  link_.note_read(now);
  if (is_lost(keeper_)) watch_.lost_keeper();
  last_read_ = now;
  next_read_ = now + call_.limits.period / 2;
}

/// Writes the safe values, also in each later turn, and then states the reason.
void GuardProcess::announce_trip() {
  set_safe();
  if (announced_) return;
  announced_ = true;
  link_.tell(GuardState::tripped, watch_.text());
}

void GuardProcess::watch_life() noexcept {
  pollfd look{life_, POLLRDHUP, 0};
  while (::poll(&look, 1, -1) < 0) {
  }
  link_.beat(GuardRequest::gone);
}

/// The safe values are noted before the calls of drivers that may hang.
void GuardProcess::finish() {
  set_safe();
  link_.note_safe();
  bank_.stop();
  link_.put_reports(joined(bank_.reports()));
  const bool was_asked = link_.request() == GuardRequest::finish;
  if (!was_asked)
    std::fprintf(
        stderr,
        "the loop has ended without finishing; its guard has set all outputs to their safe values%s%s\n",
        watch_.tripped() ? ": " : "", watch_.text().c_str());
  link_.tell(GuardState::ended, watch_.text());
}

int run_guard(int memory, int life) {
  for (const int signal : {SIGINT, SIGHUP, SIGQUIT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_IGN);
  try {
    Link link{io::Descriptor(memory)};
    try {
      const pid_t keeper = start_keeper(link);
      GuardProcess(link, life, keeper).serve();
      return 0;
    } catch (const std::exception& error) {
      link.note_safe();  // no command has come
      link.tell(GuardState::failed, error.what());
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  return 3;
}

}  // namespace stepwire::guard
