#include "engine/simulate/devices/channel_io.hpp"

#include <sstream>

#include "engine/base/io/environment_error.hpp"

namespace stepwire::devices {

DirectIo::DirectIo(const Wiring& wiring, guard::Bank& bank, const std::atomic<bool>* interrupt)
    : bank_(bank), watch_(wiring.limits) {
  bank_.use(wiring.uses);
  bank_.start(wiring.limits.period, watch_.safe());
  bank_.safe();
  bank_.await_values(wiring.wait, [&] { return !(interrupt && *interrupt); });
  if (interrupt && *interrupt) throw io::EnvironmentError(guard::Bank::interrupted);
}

DirectIo::~DirectIo() {
  bank_.safe();
  bank_.stop();
}

bool DirectIo::accept(int result) noexcept {
  if (result == STEPWIRE_STALE || result == STEPWIRE_ENDED) watch_.trip(guard::Watch::Cause::stale);
  if (result == STEPWIRE_FAILED) watch_.trip(guard::Watch::Cause::device);
  return !watch_.tripped();
}

bool DirectIo::read(double* inputs) noexcept {
  if (!accept(bank_.read(inputs))) return false;
  watch_.sensed(guard::monotonic(), inputs);
  return !watch_.tripped();
}

bool DirectIo::write(const double* outputs) noexcept {
  watch_.commanded(guard::monotonic(), outputs);
  return accept(bank_.write(watch_.outputs()));
}

void DirectIo::rest() noexcept {
  watch_.rest();
  bank_.safe();
}

std::vector<std::string> DirectIo::finish() {
  bank_.safe();
  bank_.stop();
  return bank_.reports();
}

GuardedIo::GuardedIo(const Wiring& wiring, int priority, const std::atomic<bool>* interrupt)
    : guard_({wiring.devices, wiring.uses, wiring.wait, wiring.limits, priority}, interrupt) {}

std::vector<std::string> GuardedIo::finish() {
  std::vector<std::string> lines;
  std::istringstream reports(guard_.finish());
  for (std::string line; std::getline(reports, line);) lines.push_back(line);
  return lines;
}

}  // namespace stepwire::devices
