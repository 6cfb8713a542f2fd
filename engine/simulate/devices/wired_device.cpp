#include "engine/simulate/devices/wired_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "engine/base/io/environment_error.hpp"

namespace stepwire::devices {

WiredDevice::WiredDevice(const Wiring& wiring, ChannelIo& io, const std::atomic<bool>* interrupt)
    : io_(io),
      interrupt_(interrupt),
      inputs_(wiring.inputs),
      sensed_(wiring.limits.inputs.size(), 0.0),
      filtered_(wiring.inputs.size(), 0.0) {
  for (const guard::OutputLimits& one : wiring.limits.outputs) safe_.push_back(one.safe);
  commanded_ = safe_;
  for (const OutputWire& wire : wiring.outputs) outputs_.push_back({wire});
  forget();
}

/// The next command begins at the safe values, where the devices are.
void WiredDevice::forget() noexcept {
  for (Output& one : outputs_) one.last = (safe_[one.wire.channel] - one.wire.offset) / one.wire.scale;
}

void WiredDevice::read(double* inputs) noexcept {
  healthy_ = io_.read(sensed_.data()) && healthy_;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const InputWire& wire = inputs_[i];
    const double value = wire.scale * sensed_[wire.channel] + wire.offset;
    healthy_ = healthy_ && std::isfinite(value);  // the watch names the channel
    filtered_[i] = begun_ ? filtered_[i] + wire.filter * (value - filtered_[i]) : value;
    inputs[wire.port] = wire.filter < 1.0 ? filtered_[i] : value;
  }
  begun_ = true;
}

double WiredDevice::within(Output& output, double wanted) const noexcept {
  if (!std::isfinite(wanted)) return wanted;  // which the watch refuses
  const OutputWire& wire = output.wire;
  const double limited = std::clamp(wanted, wire.least, wire.most);
  output.at_limit += limited != wanted ? 1 : 0;
  if (!std::isfinite(wire.step)) return limited;
  const double slow = std::clamp(limited, output.last - wire.step, output.last + wire.step);
  output.at_rate += slow != limited ? 1 : 0;
  return slow;
}

void WiredDevice::write(const double* outputs) noexcept {
  for (Output& one : outputs_) {
    one.last = within(one, outputs[one.wire.port]);
    commanded_[one.wire.channel] = one.wire.scale * one.last + one.wire.offset;
  }
  ++steps_;
  healthy_ = io_.write(commanded_.data()) && healthy_;
}

void WiredDevice::rest(const double*) noexcept {
  io_.rest();
  forget();
}

std::vector<std::string> WiredDevice::limited() const {
  std::vector<std::string> lines;
  for (const Output& one : outputs_)
    if (one.at_limit > 0 || one.at_rate > 0)
      lines.push_back(fmt::format("output {} was held at its limits in {} and at its rate in {} of {} steps",
                                  one.wire.name, one.at_limit, one.at_rate, steps_));
  return lines;
}

/// Waits for the next sample. Samples that have passed before make the loop late by their number of periods.
/// Without a sample the loop goes on once the values of the device are stale, and its next read fails.
void DeviceClock::sleep_until(std::int64_t deadline) {
  constexpr std::int64_t limit = 1'000'000'000;
  const std::int64_t end = clock_.now() + std::max(limit, 2 * period_);
  int samples = 0;
  while ((samples = device_.wait(2 * period_)) == 0 && clock_.now() < end &&
         device_.read(values_.data()) == STEPWIRE_OK) {
  }
  last_ = clock_.now();
  if (first_ == 0)
    first_ = last_;
  else
    samples_ += samples;
  ahead_ = deadline - last_ + std::max(0, samples - 1) * period_;
}

std::string DeviceClock::other_period() const {
  constexpr std::int64_t fewest = 10;
  constexpr double part = 0.05;
  const double mean =
      static_cast<double>(last_ - first_) / static_cast<double>(std::max<std::int64_t>(1, samples_));
  const auto period = static_cast<double>(period_);
  if (samples_ < fewest || std::abs(mean - period) <= part * period) return "";
  return fmt::format(
      "samples of the clock came every {:.4g} ms, and a period of the loop is {:.4g} ms: the times of the "
      "diagram are not those of the clock; --rate {:.4g}",
      mean * 1e-6, period * 1e-6, 1e9 / mean);
}

namespace {

/// Returns the device and the reason of a line "card: failed: the record ..", see driver.h; std::nullopt for
/// counts.
std::optional<std::string> failure_in(const std::string& line) {
  constexpr std::string_view word = ": failed: ";
  const std::size_t at = line.find(word);
  if (at == std::string::npos || line.find(": ") != at) return std::nullopt;
  return line.substr(0, at) + ": " + line.substr(at + word.size());
}

/// Opens the devices in this process.
std::unique_ptr<guard::Bank> opened(const Wiring& wiring) {
  auto bank = std::make_unique<guard::Bank>(wiring.devices);
  if (bank->inputs() != wiring.limits.inputs.size() || bank->outputs() != wiring.limits.outputs.size())
    throw io::EnvironmentError("the devices have other channels than before");
  return bank;
}

}  // namespace

Rig::Rig(const IoRequest& request, const Ports& ports, double period, int priority,
         const std::atomic<bool>* interrupt) {
  wiring_ = wire(request, ports, known_devices(request, interrupt), period);
  if (wiring_.guarded) {
    io_ = std::make_unique<GuardedIo>(wiring_, priority);
  } else {
    bank_ = opened(wiring_);
    io_ = std::make_unique<DirectIo>(wiring_, *bank_);
  }
  device_ = std::make_unique<WiredDevice>(wiring_, *io_, interrupt);
  if (wiring_.clock)
    clock_ = std::make_unique<DeviceClock>(bank_->device(*wiring_.clock), wiring_.limits.period);
}

std::string Rig::trouble() const {
  std::string all = io_->trouble();
  for (const std::string& failure : failures_) all += (all.empty() ? "" : "\n") + failure;
  return all;
}

std::vector<std::string> Rig::finish() {
  std::vector<std::string> lines;
  for (std::string& line : io_->finish())
    if (const auto failure = failure_in(line))
      failures_.push_back(*failure);
    else
      lines.push_back(std::move(line));
  if (clock_)
    if (std::string line = clock_->other_period(); !line.empty()) lines.push_back(std::move(line));
  for (std::string& line : device_->limited()) lines.push_back(std::move(line));
  return lines;
}

}  // namespace stepwire::devices
