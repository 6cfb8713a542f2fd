#include "engine/simulate/guard/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/driver/driver.h"

namespace stepwire::guard {

namespace {

constexpr double rounding = 1e-9;      // of a limit that was converted twice
constexpr double rate_margin = 1.001;  // of a change within its rate

double seconds_of(std::int64_t time) {
  return static_cast<double>(time) * 1e-9;
}

bool is_within(double value, double least, double most) {
  const double slack = rounding * std::max(std::isfinite(least) ? std::abs(least) : 0.0,
                                           std::isfinite(most) ? std::abs(most) : 0.0);
  return value >= least - slack && value <= most + slack;
}

/// Returns a channel's value with its unit.
std::string in_unit(double value, const std::string& unit) {
  return fmt::format("{:.6g}{}", value, unit.empty() || unit == "1" ? "" : " " + unit);
}

}  // namespace

Watch::Watch(WatchLimits limits) : limits_(std::move(limits)) {
  for (const OutputLimits& one : limits_.outputs) safe_.push_back(one.safe);
  outputs_ = commands_ = safe_;
  inputs_.assign(limits_.inputs.size(), 0.0);
  changed_.assign(limits_.inputs.size(), 0);
  for (const PowerLimit& one : limits_.powers) energies_.emplace_back(one.most);
  held_ = !limits_.dead_man;
}

void Watch::trip(Cause cause, std::size_t place, double value, double from, double allowed) noexcept {
  if (!tripped()) {
    cause_ = cause;
    place_ = place;
    value_ = value;
    from_ = from;
    allowed_ = allowed;
  }
  hold_safe();
}

void Watch::accept(int result, std::size_t device) noexcept {
  if (result == STEPWIRE_STALE || result == STEPWIRE_ENDED) trip(Cause::stale, device);
  if (result == STEPWIRE_FAILED) trip(Cause::device, device);
}

void Watch::hold_safe() noexcept {
  std::ranges::copy(safe_, outputs_.begin());
}

void Watch::sensed(std::int64_t now, const double* inputs) noexcept {
  for (std::size_t i = 0; i < inputs_.size(); ++i) check_input(i, inputs[i], now);
  if (sensed_) check_powers(now, inputs);
  if (limits_.dead_man) {
    const DeadMan& man = *limits_.dead_man;
    const bool holds = inputs[man.input] > man.above;
    if (held_ && !holds) trip(Cause::released, man.input, inputs[man.input]);
    if (!held_ && holds) ramp_begin_ = now;
    held_ = held_ || holds;
  }
  std::copy_n(inputs, inputs_.size(), inputs_.begin());
  last_sensed_ = now;
  sensed_ = true;
}

/// A jump is a change since the last look that the rate does not allow within a period, or within the time
/// that has passed where that is longer.
void Watch::check_input(std::size_t i, double value, std::int64_t now) noexcept {
  const InputLimits& limit = limits_.inputs[i];
  if (!std::isfinite(value)) return trip(Cause::input_bad, i, value);
  if (!is_within(value, limit.least, limit.most)) return trip(Cause::input_range, i, value);
  if (!sensed_ || value != inputs_[i]) changed_[i] = now;
  if (limit.stuck > 0 && now - changed_[i] > limit.stuck) return trip(Cause::input_stuck, i, value);
  if (!sensed_) return;
  const double seconds = seconds_of(std::max(limits_.period, now - last_sensed_));
  if (std::abs(value - inputs_[i]) > rate_margin * limit.rate * seconds)
    trip(Cause::input_jump, i, value, inputs_[i], limit.rate * seconds);
}

/// Of a time longer than a second the share of the last second counts.
void Watch::check_powers(std::int64_t now, const double* inputs) noexcept {
  const double seconds = seconds_of(now - last_sensed_);
  for (std::size_t i = 0; i < energies_.size(); ++i) {
    const PowerLimit& limit = limits_.powers[i];
    const double flow = limit.flow.of(inputs);
    const double moved = limit.flow_is_position ? flow - limit.flow.of(inputs_.data()) : seconds * flow;
    const double energy = limit.effort.of(inputs) * moved / std::max(1.0, seconds);
    if (!std::isfinite(energy)) return trip(Cause::power, i, energy);
    energies_[i].add(now, energy);
    const double last = energies_[i].energy();
    if (!is_within(last, -limit.most, limit.most)) trip(Cause::power, i, last);
  }
}

bool Watch::accepts(std::size_t i, double value, double seconds) noexcept {
  const OutputLimits& limit = limits_.outputs[i];
  Cause cause = Cause::none;
  if (!std::isfinite(value))
    cause = Cause::not_finite;
  else if (!is_within(value, limit.least, limit.most))
    cause = Cause::beyond;
  else if (std::abs(value - commands_[i]) > rate_margin * limit.rate * seconds + rounding * std::abs(value))
    cause = Cause::too_fast;
  if (cause != Cause::none) trip(cause, i, value, commands_[i], limit.rate * seconds);
  return cause == Cause::none;
}

void Watch::commanded(std::int64_t now, const double* values) noexcept {
  if (tripped()) return;
  const double seconds =
      seconds_of(commanded_ ? std::max(limits_.period, now - last_command_) : limits_.period);
  for (std::size_t i = 0; i < commands_.size(); ++i)
    if (!accepts(i, values[i], seconds)) return;
  if (!commanded_ && !limits_.dead_man) ramp_begin_ = now;
  commanded_ = true;
  last_command_ = now;
  std::copy_n(values, commands_.size(), commands_.begin());
  const double share = ramp_share(now);
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    const double wanted = share >= 1.0 ? commands_[i] : safe_[i] + share * (commands_[i] - safe_[i]);
    const double most = limits_.outputs[i].rate * seconds;  // also from the safe value on, when a hand closes
    outputs_[i] = std::isfinite(most) ? std::clamp(wanted, outputs_[i] - most, outputs_[i] + most) : wanted;
  }
}

/// Returns the share of the commands in the outputs: 0 before the dead-man input is held, then rising to 1.
double Watch::ramp_share(std::int64_t now) const noexcept {
  if (!held_) return 0.0;
  if (limits_.ramp <= 0) return 1.0;
  return std::clamp(static_cast<double>(now - ramp_begin_) / static_cast<double>(limits_.ramp), 0.0, 1.0);
}

void Watch::waited(std::int64_t now) noexcept {
  if (commanded_ && now > last_command_ + limits_.late) trip(Cause::late, 0, seconds_of(now - last_command_));
}

void Watch::rest() noexcept {
  commanded_ = false;
  std::ranges::copy(safe_, commands_.begin());
  hold_safe();
}

/// Returns the reason of a trip by an output; "" for another cause.
std::string Watch::text_of_output() const {
  if (place_ >= limits_.outputs.size()) return "";
  const OutputLimits& one = limits_.outputs[place_];
  const std::string value = fmt::format("output {} was to become {}", one.name, in_unit(value_, one.unit));
  switch (cause_) {
    case Cause::not_finite:
      return value + "; a command must be finite";
    case Cause::beyond:
      return value + fmt::format("; its limits are {:.6g} and {}", one.least, in_unit(one.most, one.unit));
    case Cause::too_fast:
      return value + text_of_change(one.unit);
    default:
      return "";
  }
}

/// Returns the end of a sentence on a change that is too large.
std::string Watch::text_of_change(const std::string& unit) const {
  return fmt::format(" from {}; its rate allows a change of {}", in_unit(from_, unit),
                     in_unit(allowed_, unit));
}

/// Returns the reason of a trip by an input; "" for another cause.
std::string Watch::text_of_input() const {
  if (place_ >= limits_.inputs.size()) return "";
  const InputLimits& one = limits_.inputs[place_];
  const std::string value = in_unit(value_, one.unit);
  constexpr const char* look = "look at the sensor and its wire";
  switch (cause_) {
    case Cause::input_bad:
      return fmt::format("input {} became {}; {}", one.name, value, look);
    case Cause::input_range:
      return fmt::format("input {} is {}; its range is {:.6g} to {}", one.name, value, one.least,
                         in_unit(one.most, one.unit));
    case Cause::input_jump:
      return fmt::format("input {} jumped to {}", one.name, value) + text_of_change(one.unit);
    case Cause::input_stuck:
      return fmt::format("input {} has been {} for more than {:.4g} s; {}", one.name, value,
                         seconds_of(one.stuck), look);
    case Cause::released:
      return fmt::format("the dead-man input {} was released", one.name);
    default:
      return "";
  }
}

std::string Watch::text_of_device() const {
  return place_ < limits_.devices.size() ? "the device " + limits_.devices[place_] : "the device";
}

std::string Watch::text() const {
  switch (cause_) {
    case Cause::late:
      return fmt::format("the loop has written nothing for {:.4g} ms; it may for {:.4g} ms", 1e3 * value_,
                         1e3 * seconds_of(limits_.late));
    case Cause::power:
      return fmt::format("the power {} was {:.4g} J in a second; its limit is {:.4g} J",
                         limits_.powers[place_].name, value_, limits_.powers[place_].most);
    case Cause::stale:
      return text_of_device() + " has no new values";
    case Cause::device:
      return text_of_device() + " does not answer";
    case Cause::keeper:
      return "the process stepwire_keeper has ended or is stopped; without it outputs would keep their "
             "values "
             "where loop and guard are killed together";
    default:
      return text_of_output() + text_of_input();
  }
}

}  // namespace stepwire::guard
