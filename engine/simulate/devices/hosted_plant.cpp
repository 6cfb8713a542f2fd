#include "engine/simulate/devices/hosted_plant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/base/math/normal_quantile.hpp"
#include "engine/base/math/random.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::devices {

namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& message) {
  throw yaml::Error(yaml::Fault{{text, {}}, "", message, {}});
}

std::vector<std::string> names_of(const std::vector<Port>& ports) {
  std::vector<std::string> names;
  for (const Port& port : ports) names.push_back(port.name);
  return names;
}

/// Returns the channels as a driver takes them: "force in N, angle in rad".
std::string channel_list(const std::vector<Port>& ports) {
  std::string list;
  for (const Port& port : ports) {
    const std::string unit = port.dimension ? unit::si_name(*port.dimension) : "";
    list += (list.empty() ? "" : ", ") + port.name + (unit.empty() || unit == "1" ? "" : " in " + unit);
  }
  return list;
}

double seconds_of(const std::string& text, const std::string& whole) {
  const auto quantity = unit::parse_quantity(text);
  const bool is_time =
      quantity && quantity->dimension && *quantity->dimension == unit::parse_unit("s")->dimension;
  if (!is_time) refuse(whole, fmt::format("'{}' is no time, such as '2 s'", text));
  return quantity->value;
}

}  // namespace

HostedPlant::HostedPlant(const PlantCall& call, const plan::Plan& plan, double period)
    : in_(input_ports(plan)), out_(output_ports(plan)), seed_(call.seed), period_(period) {
  for (const Port& port : out_) sensors_.push_back({port.name});
  set_each(call.quanta, &Sensor::quantum);
  set_each(call.noises, &Sensor::noise);
  for (const std::string& text : call.faults) faults_.push_back(fault_of(text));
  delay_ = static_cast<std::size_t>(std::llround(call.latency / period));
  delay_line_.assign((delay_ + 1) * out_.size(), 0.0);
  commands_.assign(in_.size(), 0.0);
  shown_.assign(out_.size(), 0.0);
  open(call, period);
}

void HostedPlant::open(const PlantCall& call, double period) {
  driver::Settings settings = call.settings;
  if (call.driver == "shared") settings.emplace_back("role", "host");
  if (!in_.empty()) settings.emplace_back("inputs", channel_list(in_));
  if (!out_.empty()) settings.emplace_back("outputs", channel_list(out_));
  settings.emplace_back("stale", fmt::format("{:.9f} s", call.inhibit));
  open_ =
      std::make_unique<driver::OpenDevice>(driver::load_driver(driver::driver_file(call.driver)), settings);
  const std::vector<double> zeros(out_.size(), 0.0);
  open_->start(std::llround(period * 1e9), zeros.data());
}

void HostedPlant::set_each(const std::vector<std::string>& texts, double Sensor::*member) {
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) refuse(text, "has no value; such as force=0.01N");
    const std::size_t index = sensor(text.substr(0, equals), text);
    sensors_[index].*member = number(text.substr(equals + 1), out_[index]);
    if (!(sensors_[index].*member > 0.0)) refuse(text, "must be above 0");
  }
}

std::size_t HostedPlant::sensor(const std::string& name, const std::string& text) const {
  const auto found = std::ranges::find(out_, name, &Port::name);
  if (found != out_.end()) return static_cast<std::size_t>(found - out_.begin());
  throw yaml::Error(yaml::Fault{{text, {}},
                                "",
                                fmt::format("the diagram has no output '{}'", name) +
                                    yaml::nearest_or_all(name, names_of(out_), "outputs are"),
                                {}});
}

double HostedPlant::number(const std::string& text, const Port& port) const {
  const auto quantity = unit::parse_quantity(text);
  if (!quantity || !std::isfinite(quantity->value)) refuse(text, "is no number with a unit");
  if (port.dimension && !(quantity->dimension.value_or(unit::Dimension{}) == *port.dimension))
    refuse(text, fmt::format("is not in {}, the unit of {}", unit::si_name(*port.dimension), port.name));
  return quantity->value;
}

PlantFault HostedPlant::fault_of(const std::string& text) const {
  const auto at = text.rfind('@');
  const std::string what = text.substr(0, at);
  const auto colon = what.find(':'), equals = what.find('=');
  const std::string kind = what.substr(0, colon);
  PlantFault fault;
  const std::vector<std::string> kinds{"stuck", "jump", "nan", "unplug"};
  const auto found = std::ranges::find(kinds, kind);
  const bool is_whole = at != std::string::npos && found != kinds.end() &&
                        (kind == "unplug") == (colon == std::string::npos) &&
                        (kind == "jump") == (equals != std::string::npos);
  if (!is_whole)
    refuse(text, "is no fault; such as stuck:force@2s, jump:angle=0.5rad@2s, nan:force@2s, unplug@2s");
  fault.kind = static_cast<PlantFault::Kind>(found - kinds.begin());
  const std::string times = text.substr(at + 1);
  const auto dots = times.find("..");
  fault.time = seconds_of(times.substr(0, dots), text);
  if (dots != std::string::npos) fault.end = seconds_of(times.substr(dots + 2), text);
  if (fault.time < 0.0) refuse(text, "begins before the rig does; its time is 0 s or more");
  if (!(fault.time < fault.end)) refuse(text, "ends before it begins");
  if (kind == "unplug") return fault;
  fault.output = what.substr(colon + 1, equals - colon - 1);
  const std::size_t index = sensor(fault.output, text);
  if (kind == "jump") fault.by = number(what.substr(equals + 1), out_[index]);
  return fault;
}

/// Without a command in time the amplifiers are inhibited: the inputs have their defaults.
void HostedPlant::read(double* inputs) noexcept {
  if (!began_) defaults_.assign(inputs, inputs + in_.size());
  began_ = true;
  ++steps_;
  commanded_ = commanded_ || open_->ready() > 0;
  const int state = open_->read(commands_.data());
  const bool is_new = commanded_ && state == STEPWIRE_OK &&
                      std::ranges::all_of(commands_, [](double x) { return std::isfinite(x); });
  inhibited_ += is_new ? 0 : 1;
  std::ranges::copy(is_new ? commands_ : defaults_, inputs);
}

void HostedPlant::apply_faults() noexcept {
  const double time = static_cast<double>(steps_ - 1) * period_;
  unplugged_ = false;
  for (const PlantFault& fault : faults_) {
    if (time < fault.time || time >= fault.end) continue;
    if (fault.kind == PlantFault::Kind::unplug) unplugged_ = true;
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      if (sensors_[i].name != fault.output) continue;
      if (fault.kind == PlantFault::Kind::stuck) shown_[i] = sensors_[i].held;
      if (fault.kind == PlantFault::Kind::jump) shown_[i] += fault.by;
      if (fault.kind == PlantFault::Kind::nan) shown_[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
}

/// Before the first step the sensors have shown its values.
void HostedPlant::begin(const double* outputs) noexcept {
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    sensors_[i].held = outputs[i];
    for (std::size_t row = 0; row <= delay_; ++row) delay_line_[row * sensors_.size() + i] = outputs[i];
  }
}

void HostedPlant::write(const double* outputs) noexcept {
  const std::size_t width = sensors_.size(), row = static_cast<std::size_t>(steps_) % (delay_ + 1);
  if (!std::exchange(has_shown_, true)) begin(outputs);
  std::copy_n(outputs, width, delay_line_.begin() + static_cast<std::ptrdiff_t>(row * width));
  const std::size_t seen = (row + 1) % (delay_ + 1);
  for (std::size_t i = 0; i < width; ++i) {
    const Sensor& one = sensors_[i];
    double value = delay_line_[seen * width + i];
    if (one.noise > 0.0)
      value += one.noise * normal_quantile(even_sample(seed_, static_cast<std::ptrdiff_t>(i),
                                                       static_cast<double>(steps_)));
    shown_[i] = one.quantum > 0.0 ? one.quantum * std::round(value / one.quantum) : value;
  }
  apply_faults();
  for (std::size_t i = 0; i < width; ++i) sensors_[i].held = shown_[i];
  if (!unplugged_) open_->write(shown_.data());
}

std::vector<std::string> HostedPlant::finish() {
  open_->stop();
  std::vector<std::string> lines{open_->report()};
  if (inhibited_ > 0)
    lines.push_back(fmt::format("the inputs had their defaults in {} of {} steps, without a command in time",
                                inhibited_, steps_));
  return lines;
}

}  // namespace stepwire::devices
