#include "engine/simulate/guard/bank.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "engine/base/io/environment_error.hpp"
#include "engine/simulate/guard/link.hpp"

namespace stepwire::guard {

namespace {

std::unique_ptr<driver::OpenDevice> opened(const DeviceSettings& one) {
  try {
    return std::make_unique<driver::OpenDevice>(driver::load_driver(one.file), one.settings);
  } catch (const io::EnvironmentError& error) {
    throw io::EnvironmentError(fmt::format("{}: {}", one.name, error.what()));
  }
}

}  // namespace

Bank::Bank(const std::vector<DeviceSettings>& devices) {
  for (const DeviceSettings& one : devices) {
    auto open = opened(one);
    const std::size_t inputs = open->inputs().size(), outputs = open->outputs().size();
    devices_.push_back({one.name, std::move(open), inputs_, outputs_});
    inputs_ += inputs;
    outputs_ += outputs;
  }
}

void Bank::start(std::int64_t period, const double* safe) {
  for (One& one : devices_) one.open->start(period, safe + one.first_output);
}

void Bank::use(const std::vector<InputUse>& uses) {
  for (std::size_t i = 0; i < devices_.size(); ++i) devices_[i].use = uses[i];
}

std::vector<std::string> Bank::silent() {
  std::vector<std::string> names;
  for (One& one : devices_)
    if (one.use != InputUse::unused && !one.open->is_ready()) names.push_back(one.name);
  return names;
}

void Bank::await_values(std::int64_t limit, const std::function<bool()>& goes_on) {
  constexpr useconds_t pause = 1000;
  const std::int64_t end = monotonic() + limit;
  while (goes_on()) {
    const std::vector<std::string> names = silent();
    if (names.empty()) return;
    if (monotonic() >= end)
      throw io::EnvironmentError(
          fmt::format("{}: no value has come within {:.3g} s; the other side must run (key wait)",
                      fmt::join(names, ", "), static_cast<double>(limit) * 1e-9));
    safe();
    ::usleep(pause);
  }
}

int Bank::worse(int worst, int result, std::size_t device) noexcept {
  if (result > worst) culprit_ = device;
  return std::max(worst, result);
}

int Bank::read(double* inputs) noexcept {
  int worst = STEPWIRE_OK;
  for (std::size_t i = 0; i < devices_.size(); ++i) {
    const int result = devices_[i].open->read(inputs + devices_[i].first_input);
    if (result != STEPWIRE_STALE || devices_[i].use == InputUse::live) worst = worse(worst, result, i);
  }
  return worst;
}

int Bank::write(const double* outputs) noexcept {
  int worst = STEPWIRE_OK;
  for (std::size_t i = 0; i < devices_.size(); ++i)
    if (One& one = devices_[i]; !one.open->outputs().empty())
      worst = worse(worst, one.open->write(outputs + one.first_output), i);
  return worst;
}

int Bank::safe() noexcept {
  int worst = STEPWIRE_OK;
  for (std::size_t i = 0; i < devices_.size(); ++i)
    if (!devices_[i].open->outputs().empty()) worst = worse(worst, devices_[i].open->safe(), i);
  return worst;
}

void Bank::stop() noexcept {
  for (One& one : devices_) one.open->stop();
}

std::vector<std::string> Bank::reports() const {
  std::vector<std::string> all;
  for (const One& one : devices_) {
    std::istringstream report(one.open->report());
    for (std::string line; std::getline(report, line);)
      if (!line.empty()) all.push_back(one.name + ": " + line);
  }
  return all;
}

}  // namespace stepwire::guard
