#include "engine/simulate/guard/bank.hpp"

#include <algorithm>

namespace stepwire::guard {

Bank::Bank(const std::vector<DeviceSettings>& devices) {
  for (const DeviceSettings& one : devices) {
    auto open = std::make_unique<driver::OpenDevice>(driver::load_driver(one.file), one.settings);
    const std::size_t inputs = open->inputs().size(), outputs = open->outputs().size();
    devices_.push_back({one.name, std::move(open), inputs_, outputs_});
    inputs_ += inputs;
    outputs_ += outputs;
  }
}

void Bank::start(std::int64_t period, const double* safe) {
  for (One& one : devices_) one.open->start(period, safe + one.first_output);
}

int Bank::read(double* inputs) noexcept {
  int worst = STEPWIRE_OK;
  for (One& one : devices_) {
    const int result = one.open->read(inputs + one.first_input);
    if (result == STEPWIRE_STALE && one.holds_stale) continue;
    worst = std::max(worst, result);
  }
  return worst;
}

int Bank::write(const double* outputs) noexcept {
  int worst = STEPWIRE_OK;
  for (One& one : devices_)
    if (!one.open->outputs().empty()) worst = std::max(worst, one.open->write(outputs + one.first_output));
  return worst;
}

int Bank::safe() noexcept {
  int worst = STEPWIRE_OK;
  for (One& one : devices_)
    if (!one.open->outputs().empty()) worst = std::max(worst, one.open->safe());
  return worst;
}

void Bank::stop() noexcept {
  for (One& one : devices_) one.open->stop();
}

std::vector<std::string> Bank::reports() const {
  std::vector<std::string> all;
  for (const One& one : devices_)
    if (const std::string text = one.open->report(); !text.empty()) all.push_back(one.name + ": " + text);
  return all;
}

}  // namespace stepwire::guard
