#include "engine/simulate/devices/channel_io.hpp"

#include <sstream>

namespace stepwire::devices {

DirectIo::DirectIo(const Wiring& wiring, guard::Bank& bank)
    : bank_(bank), wait_(wiring.wait), watch_(wiring.limits) {
  bank_.use(wiring.uses);
}

void DirectIo::start(const std::atomic<bool>* interrupt) {
  bank_.start(watch_.limits().period, watch_.safe());
  bank_.safe();
  bank_.await_values(wait_, [&] { return !(interrupt && *interrupt); });
}

DirectIo::~DirectIo() {
  bank_.safe();
  bank_.stop();
}

bool DirectIo::accept(int result) noexcept {
  watch_.accept(result, bank_.culprit());
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
  accept(bank_.safe());
}

std::vector<std::string> DirectIo::finish() {
  accept(bank_.safe());
  bank_.stop();
  return bank_.reports();
}

GuardedIo::GuardedIo(const Wiring& wiring, int priority)
    : guard_({wiring.devices, wiring.uses, wiring.wait, wiring.limits, priority}) {}

std::vector<std::string> GuardedIo::finish() {
  std::vector<std::string> lines;
  std::istringstream reports(guard_.finish());
  for (std::string line; std::getline(reports, line);) lines.push_back(line);
  return lines;
}

}  // namespace stepwire::devices
