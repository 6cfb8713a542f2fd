#include "engine/simulate/devices/wiring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/math/elementary.hpp"
#include "engine/base/subprocess/process.hpp"

namespace stepwire::devices {

namespace {

using unit::Dimension;

constexpr double least_scale = 1e-18;  // magnitude, SI

std::int64_t nanoseconds(double seconds) {
  return std::llround(seconds * 1e9);
}

template <class All>
std::vector<std::string> names_in(const All& all) {
  std::vector<std::string> names;
  for (const auto& one : all) names.emplace_back(one.name);
  return names;
}

/// Channel of a device, with its place among those of all devices.
struct Place {
  const guard::SurveyedChannel* channel = nullptr;
  std::size_t device = 0, index = 0;
};

/// Places of the first channels of a device among those of all devices.
struct First {
  std::size_t input = 0, output = 0;
};

/// Returns the SI unit of a number, "" without one.
std::string unit_name(const Dimension& dimension) {
  const std::string name = unit::si_name(dimension);
  if (name != "1") return name;
  return dimension.angle == 1.0 ? "rad" : "";
}

/// Returns the unit of a channel as it follows a number.
std::string behind_number(const guard::SurveyedChannel& channel) {
  return channel.unit.empty() ? "" : " " + channel.unit;
}

/// Affine map from a channel to a port, or back: to = scale * from + offset.
struct Line {
  double scale = 1.0, offset = 0.0;
};

/// Connects the ports one by one, and collects all faults.
class Wirer {
 public:
  Wirer(const IoRequest& request, const Ports& ports, const KnownDevices& devices, double period)
      : request_(request), devices_(devices), period_(period), in_(ports.inputs), out_(ports.outputs) {}

  Wiring wiring() {
    all_.devices = devices_.settings;
    prepare_limits();
    for (const InputRequest& one : request_.inputs) add_input(one);
    for (const OutputRequest& one : request_.outputs) add_output(one);
    if (request_.dead_man) add_dead_man(*request_.dead_man);
    for (const EnergyRequest& one : request_.energies) add_energy(one);
    find_clock();
    choose_guard();
    note_unwired();
    faults_.throw_if_any();
    if (!devices_.failures.empty()) throw io::EnvironmentError(devices_.failures);
    return std::move(all_);
  }

 private:
  void fault(const yaml::Mark& mark, const std::string& subject, const yaml::Message& message) {
    faults_.add({{request_.file, mark}, subject, message, {}});
  }

  /// Sets the limits of all channels to those of the devices. An output that is not wired keeps its safe
  /// value.
  void prepare_limits() {
    all_.limits.period = nanoseconds(period_);
    all_.limits.late = nanoseconds(request_.late.value_or(1.5 * period_));
    all_.limits.ramp = nanoseconds(request_.ramp);
    all_.wait = nanoseconds(request_.wait);
    all_.uses.assign(devices_.answers.size(), guard::InputUse::unused);
    for (std::size_t i = 0; i < devices_.answers.size(); ++i) {
      const guard::SurveyedDevice& device = devices_.answers[i];
      first_.push_back({all_.limits.inputs.size(), all_.limits.outputs.size()});
      all_.limits.devices.push_back(request_.devices[i].name);
      all_.devices[i].outputs = device.outputs.size();
      for (const guard::SurveyedChannel& one : device.inputs)
        all_.limits.inputs.push_back({.name = channel_name(i, one), .unit = one.unit});
      for (const guard::SurveyedChannel& one : device.outputs) {
        const double rest = std::clamp(0.0, one.least, one.most);
        all_.limits.outputs.push_back({channel_name(i, one), rest, rest, rest, guard::no_limit, one.unit});
      }
    }
  }
  /// A device has the strictest use of its inputs.
  void use(std::size_t device, guard::InputUse how) { all_.uses[device] = std::max(all_.uses[device], how); }
  /// Returns a channel's name in messages of a run: "inputs.force (rig.yaml:4, channel card.force)".
  std::string told(const std::string& subject, const yaml::Mark& mark, const std::string& channel) const {
    return fmt::format("{} ({}:{}, channel {})", subject, request_.file, mark.line, channel);
  }
  std::string channel_name(std::size_t device, const guard::SurveyedChannel& channel) const {
    return request_.devices[device].name + "." + channel.name;
  }

  /// True where a device has not opened, or may not have since another one ended the process of the survey.
  bool is_unknown(const guard::SurveyedDevice& device) const {
    return !devices_.failures.empty() && device.inputs.empty() && device.outputs.empty();
  }

  std::optional<std::size_t> device_of(const std::string& name, const yaml::Mark& mark,
                                       const std::string& subject) {
    const auto found = std::ranges::find(request_.devices, name, &DeviceRequest::name);
    if (found != request_.devices.end()) return static_cast<std::size_t>(found - request_.devices.begin());
    fault(mark, subject,
          fmt::format("there is no device '{}'", name) +
              yaml::nearest_or_all(name, names_in(request_.devices), "devices are"));
    return std::nullopt;
  }

  std::optional<Place> place_of(const std::string& device, const std::string& channel, int direction,
                                const yaml::Mark& mark, const std::string& subject) {
    const auto index = device_of(device, mark, subject);
    if (!index) return std::nullopt;
    const bool is_input = direction == STEPWIRE_INPUT;
    const guard::SurveyedDevice& answers = devices_.answers[*index];
    if (is_unknown(answers)) return std::nullopt;
    const auto& table = is_input ? answers.inputs : answers.outputs;
    const std::size_t first = is_input ? first_[*index].input : first_[*index].output;
    for (std::size_t k = 0; k < table.size(); ++k)
      if (channel == table[k].name) return Place{&table[k], *index, first + k};
    fault(mark, subject,
          fmt::format("the device '{}' has no {} '{}'", device, is_input ? "input" : "output", channel) +
              yaml::nearest_or_all(channel, names_in(table), "channels are"));
    return std::nullopt;
  }

  template <class Request>
  std::optional<std::size_t> port_of(const Request& request, const std::vector<Port>& ports,
                                     const char* kind) {
    const auto found = std::ranges::find(ports, request.port, &Port::name);
    if (found != ports.end()) return static_cast<std::size_t>(found - ports.begin());
    fault(request.mark, request.port,
          fmt::format("the diagram has no {} '{}'", kind, request.port) +
              yaml::nearest_or_all(request.port, names_in(ports), fmt::format("{}s are", kind)));
    return std::nullopt;
  }

  std::optional<unit::Unit> unit_of(const std::string& own, const guard::SurveyedChannel& channel,
                                    const yaml::Mark& mark, const std::string& subject) {
    const std::string text = own.empty() ? channel.unit : own;
    const auto parsed = unit::parse_unit(text);
    if (!parsed) fault(mark, subject, yaml::fault_text("'{}' is no unit", text));
    return parsed;
  }

  /// Returns a number in SI. A bare number other than 0 is refused where `wanted` has a unit.
  double si(const std::optional<PlacedNumber>& number, double otherwise,
            const std::optional<Dimension>& wanted, const std::string& subject) {
    if (number) check_unit(*number, wanted, subject);
    return number ? number->quantity.value : otherwise;
  }
  /// Adds a fault for a number in another unit, and returns false.
  bool check_unit(const PlacedNumber& number, const std::optional<Dimension>& wanted,
                  const std::string& subject) {
    const Dimension given = number.quantity.dimension.value_or(Dimension{});
    const bool is_zero = number.quantity.value == 0.0 && !number.quantity.dimension;
    if (!wanted || is_zero || given == *wanted) return true;
    fault(
        number.mark, subject,
        yaml::fault_text("has the unit {}; it must be in {}", unit::si_name(given), unit::si_name(*wanted)));
    return false;
  }

  /// Checks that the scale leads from one dimension to the other. A port of unknown dimension takes any.
  double scale_of(const std::optional<PlacedNumber>& scale, const std::optional<Dimension>& to,
                  const Dimension& from, const yaml::Mark& mark, const std::string& subject) {
    if (scale) check_scale(*scale, subject);
    if (!to) return scale ? scale->quantity.value : 1.0;
    if (scale) return scale_in(*scale, *to, from, subject + ".scale");
    if (!(*to == from))
      fault(mark, subject,
            yaml::fault_text("is in {}, and its channel in {}; 'scale' leads from one to the other, in {}",
                             unit::si_name(*to), unit::si_name(from), per(*to, from)));
    return 1.0;
  }

  /// Returns a scale that leads from one dimension to the other.
  double scale_in(const PlacedNumber& scale, const Dimension& to, const Dimension& from,
                  const std::string& subject) {
    const Dimension given = scale.quantity.dimension.value_or(Dimension{});
    if (!(given == to / from))
      fault(scale.mark, subject,
            yaml::fault_text("has the unit {}; it must be in {}", unit::si_name(given), per(to, from)));
    return scale.quantity.value;
  }

  /// Returns the unit of a quotient as a file writes it: "N/V".
  static std::string per(const Dimension& to, const Dimension& from) {
    const std::string name = unit::si_name(from);
    if (name == "1") return unit::si_name(to);
    return unit::si_name(to) + "/" +
           (name.find_first_of(" /") == std::string::npos ? name : "(" + name + ")");
  }

  bool check_scale(const PlacedNumber& scale, const std::string& subject) {
    if (std::abs(scale.quantity.value) >= least_scale) return true;
    fault(scale.mark, subject + ".scale",
          fmt::format("is {}; its magnitude must be {} or more in SI", scale.quantity.value, least_scale));
    return false;
  }

  void add_input(const InputRequest& one) {
    const std::string subject = "inputs." + one.port;
    const auto port = port_of(one, in_, "input");
    const auto place = place_of(one.device, one.channel, STEPWIRE_INPUT, one.mark, subject);
    if (port && !place) check_alone(subject, one.range, ".range", one.rate, one.scale, in_[*port].dimension);
    if (!port || !place) return;
    const auto unit = unit_of(one.unit, *place->channel, one.mark, subject);
    if (!unit) return;
    const auto& dimension = in_[*port].dimension;
    const double sign = one.direction == Direction::reverse ? -1.0 : 1.0;
    const double scale = sign * scale_of(one.scale, dimension, unit->dimension, one.mark, subject);
    const Line line{
        scale * static_cast<double>(unit->scale),
        scale * static_cast<double>(unit->offset) + si(one.offset, 0.0, dimension, subject + ".offset")};
    const double filter =
        one.filter > 0.0 ? 1.0 - fn::exp(-2.0 * std::numbers::pi * one.filter * period_) : 1.0;
    const auto of_scale = one.scale ? one.scale->quantity.dimension : std::nullopt;
    const Dimension shown = dimension.value_or(of_scale.value_or(Dimension{}) * unit->dimension);
    all_.inputs.push_back({*port, place->index, line.scale, line.offset, filter, unit_name(shown)});
    shown_.push_back(shown);
    note_filter(one);
    guard::InputLimits& limits = all_.limits.inputs[place->index];
    limits.name = told(subject, one.mark, limits.name);
    if (!one.unit.empty()) limits.unit = one.unit;
    use(place->device, one.stale == Stale::stop ? guard::InputUse::live : guard::InputUse::held);
    limit_input(one, line, dimension, *place->channel, limits);
  }

  void note_filter(const InputRequest& one) {
    if (one.filter > 0.5 / period_)
      all_.notes.push_back(fmt::format(
          "the filter of input {} has no effect: {:.6g} Hz is above half the rate of the loop, {:.6g} Hz",
          one.port, one.filter, 0.5 / period_));
  }

  /// Checks the numbers of a port whose device has not opened.
  void check_alone(const std::string& subject, const std::optional<PlacedRange>& range, const char* key,
                   const std::optional<PlacedNumber>& rate, const std::optional<PlacedNumber>& scale,
                   const std::optional<Dimension>& dimension) {
    double least = 0.0, most = 0.0;
    if (range) set_range(*range, {}, dimension, subject + key, least, most);
    rate_of(rate, dimension, subject);
    if (scale) check_scale(*scale, subject);
  }

  /// Of two inputs of one channel the stricter limits hold, and those of the channel always: beyond them a
  /// device has no values.
  void limit_input(const InputRequest& one, const Line& line, const std::optional<Dimension>& dimension,
                   const guard::SurveyedChannel& channel, guard::InputLimits& limits) {
    const std::string subject = "inputs." + one.port;
    double least = -guard::no_limit, most = guard::no_limit;
    const bool is_set = one.range && set_range(*one.range, line, dimension, subject + ".range", least, most);
    if (is_set && (most < channel.least || least > channel.most))
      fault(one.range->least.mark, subject + ".range",
            yaml::fault_text("leads to {:.6g} to {:.6g}{}; the channel gives {:.6g} to {:.6g}", least, most,
                             behind_number(channel), channel.least, channel.most));
    limits.least = std::max({limits.least, least, channel.least});
    limits.most = std::min({limits.most, most, channel.most});
    limits.rate = std::min(limits.rate, rate_of(one.rate, dimension, subject) / std::abs(line.scale));
    const std::int64_t stuck = nanoseconds(one.stuck);
    if (stuck > 0) limits.stuck = limits.stuck > 0 ? std::min(limits.stuck, stuck) : stuck;
  }

  /// Sets the limits of a channel from a range of its port. Returns false for a faulty one.
  bool set_range(const PlacedRange& range, const Line& line, const std::optional<Dimension>& dimension,
                 const std::string& subject, double& least, double& most) {
    if (!check_unit(range.least, dimension, subject) || !check_unit(range.most, dimension, subject))
      return false;
    const double low = range.least.quantity.value, high = range.most.quantity.value;
    if (!(low < high)) {
      fault(range.least.mark, subject, "does not rise; the least value is the first");
      return false;
    }
    const double a = (low - line.offset) / line.scale, b = (high - line.offset) / line.scale;
    least = std::min(a, b);
    most = std::max(a, b);
    return true;
  }

  double rate_of(const std::optional<PlacedNumber>& rate, const std::optional<Dimension>& dimension,
                 const std::string& subject) {
    if (!rate) return guard::no_limit;
    std::optional<Dimension> wanted;
    if (dimension) wanted = *dimension / unit::parse_unit("s")->dimension;
    const double value = si(rate, 0.0, wanted, subject + ".rate");
    if (!(value > 0.0)) fault(rate->mark, subject + ".rate", "must be above 0");
    return value;
  }

  void add_output(const OutputRequest& one) {
    const std::string subject = "outputs." + one.port;
    const auto port = port_of(one, out_, "output");
    const auto place = place_of(one.device, one.channel, STEPWIRE_OUTPUT, one.mark, subject);
    if (port && !place)
      check_alone(subject, one.limits, ".limits", one.rate, one.scale, out_[*port].dimension);
    if (!port || !place || !one.limits) return;
    const auto unit = unit_of(one.unit, *place->channel, one.mark, subject);
    if (!unit) return;
    if (!taken_.insert(place->index).second)
      fault(one.mark, subject, yaml::fault_text("the channel '{}' has another output already", one.channel));
    const auto& dimension = out_[*port].dimension;
    if (one.scale && dimension) scale_in(*one.scale, unit->dimension, *dimension, subject + ".scale");
    const double scale =
        one.scale ? one.scale->quantity.value : scale_of({}, dimension, unit->dimension, one.mark, subject);
    if (one.scale && !check_scale(*one.scale, subject)) return;
    const double sign = one.direction == Direction::reverse ? -1.0 : 1.0,
                 of_unit = static_cast<double>(unit->scale);
    const Line line{sign * scale / of_unit, (si(one.offset, 0.0, unit->dimension, subject + ".offset") -
                                             static_cast<double>(unit->offset)) /
                                                of_unit};
    limit_output(one, *port, *place, line);
  }

  void limit_output(const OutputRequest& one, std::size_t port, const Place& place, const Line& line) {
    const std::string subject = "outputs." + one.port;
    const auto& dimension = out_[port].dimension;
    guard::OutputLimits& limits = all_.limits.outputs[place.index];
    limits.name = told(subject, one.mark, limits.name);
    if (!one.unit.empty()) limits.unit = one.unit;
    const Line back{1.0 / line.scale, -line.offset / line.scale};  // from the channel to the port
    const bool is_set =
        set_range(*one.limits, back, dimension, subject + ".limits", limits.least, limits.most);
    const double low = one.limits->least.quantity.value, high = one.limits->most.quantity.value;
    const double rate = rate_of(one.rate, dimension, subject);
    if (!one.safe && !out_[port].safe)
      fault(one.mark, subject, "has no safe value, neither here nor in the diagram; safe: 0");
    const double safe = one.safe ? one.safe->quantity.value : out_[port].safe.value_or(0.0);
    const bool has_unit = !one.safe || check_unit(*one.safe, dimension, subject + ".safe");
    if (is_set && has_unit && (safe < low || safe > high))
      fault(one.safe ? one.safe->mark : one.mark, subject, "has a safe value out of its limits");
    limits.safe = line.scale * safe + line.offset;
    limits.rate = rate * std::abs(line.scale);
    const guard::SurveyedChannel& channel = *place.channel;
    if (is_set && (limits.least < channel.least || limits.most > channel.most))
      fault(one.limits->least.mark, subject + ".limits",
            yaml::fault_text("lead to {:.6g} to {:.6g}{}; the channel takes {:.6g} to {:.6g}", limits.least,
                             limits.most, behind_number(channel), channel.least, channel.most));
    all_.outputs.push_back({one.port, port, place.index, line.scale, line.offset, low, high, rate * period_});
  }

  /// Returns the threshold in the unit of the channel, which a bare number has.
  double above_of(const DeadManRequest& one, const guard::SurveyedChannel& channel) {
    constexpr double half = 0.5;
    if (!one.above || !one.above->quantity.dimension) return one.above ? one.above->quantity.value : half;
    const auto unit = unit_of("", channel, one.mark, "dead_man");
    if (!unit) return half;
    return (si(one.above, half, unit->dimension, "dead_man.above") - static_cast<double>(unit->offset)) /
           static_cast<double>(unit->scale);
  }

  void add_dead_man(const DeadManRequest& one) {
    const auto place = place_of(one.device, one.channel, STEPWIRE_INPUT, one.mark, "dead_man");
    if (!place) return;
    const double above = above_of(one, *place->channel);
    const guard::SurveyedChannel& channel = *place->channel;
    if (above < channel.least || above >= channel.most)
      fault(one.above ? one.above->mark : one.mark, "dead_man.above",
            yaml::fault_text(
                "is {:.6g}{}; it must be {:.6g} or more and below {:.6g}, or the input is always or "
                "never held",
                above, behind_number(channel), channel.least, channel.most));
    all_.limits.dead_man = guard::DeadMan{place->index, above};
    use(place->device, guard::InputUse::live);
  }

  void add_energy(const EnergyRequest& one) {
    const bool is_position = one.speed.empty();
    const InputWire* const force = wired(one.force, one);
    const InputWire* const motion = wired(is_position ? one.position : one.speed, one);
    if (!force || !motion) return;
    check_energy(one, *force, *motion, is_position);
    const auto scaled = [](const InputWire& of) {
      return guard::ScaledInput{of.channel, of.scale, of.offset};
    };
    all_.limits.powers.push_back({one.name, scaled(*force), scaled(*motion), is_position, one.most});
  }
  /// An angle counts as a pure number: a torque times an angle is an energy.
  void check_energy(const EnergyRequest& one, const InputWire& force, const InputWire& motion,
                    bool is_position) {
    const Dimension &of_force = shown_of(force), &of_motion = shown_of(motion);
    const char* const unit = is_position ? "J" : "W";
    Dimension product = of_force * of_motion, wanted = unit::parse_unit(unit)->dimension;
    product.angle = wanted.angle = 0.0;
    if (product == wanted) return;
    fault(one.mark, "energy." + one.name,
          yaml::fault_text("{} times {} is in {}; it must be in {}", in_[force.port].name,
                           in_[motion.port].name, unit::si_name(product), unit));
  }
  /// Returns the dimension in which an input is shown, which is that of its channel and scale where the
  /// diagram has none.
  const Dimension& shown_of(const InputWire& wire) const {
    return shown_[static_cast<std::size_t>(&wire - all_.inputs.data())];
  }
  const InputWire* wired(const std::string& port, const EnergyRequest& one) {
    for (const InputWire& wire : all_.inputs)
      if (in_[wire.port].name == port) return &wire;
    fault(one.mark, "energy." + one.name, yaml::fault_text("'{}' is no wired input", port));
    return nullptr;
  }

  void find_clock() {
    if (request_.clock.empty()) return;
    all_.clock = device_of(request_.clock, request_.clock_mark, "clock");
    if (all_.clock && !is_unknown(devices_.answers[*all_.clock]) && !devices_.answers[*all_.clock].is_clock)
      fault(request_.clock_mark, "clock",
            yaml::fault_text("the driver of '{}' has no clock; leave 'clock' out", request_.clock));
  }

  void choose_guard() {
    all_.guarded = request_.guard.value_or(!all_.outputs.empty() && !all_.clock);
    if (all_.guarded && all_.clock)
      fault(request_.clock_mark, "clock",
            "a guard has the devices, and none of them can be the clock; guard: false");
    if (request_.late && *request_.late < period_)
      fault(request_.late_mark, "late",
            fmt::format("is {:.6g} s; it must be the period of the loop or more, {:.6g} s", *request_.late,
                        period_));
  }

  void note_unwired() {
    for (std::size_t i = 0; i < in_.size(); ++i)
      if (std::ranges::find(all_.inputs, i, &InputWire::port) == all_.inputs.end())
        all_.notes.push_back(fmt::format("input {} is not wired and keeps its default", in_[i].name));
    for (std::size_t i = 0; i < out_.size(); ++i)
      if (std::ranges::find(all_.outputs, i, &OutputWire::port) == all_.outputs.end())
        all_.notes.push_back(fmt::format("output {} is not wired", out_[i].name));
    std::set<std::size_t> ports;
    for (const InputRequest& one : request_.inputs)
      for (std::size_t i = 0; i < in_.size(); ++i)
        if (in_[i].name == one.port && !ports.insert(i).second) fault(one.mark, one.port, "is wired twice");
  }

  const IoRequest& request_;
  const KnownDevices& devices_;
  double period_;
  std::vector<First> first_;  ///< of each device
  std::vector<Port> in_, out_;
  std::set<std::size_t> taken_;
  std::vector<Dimension> shown_;  ///< of each wired input
  yaml::Faults faults_;
  Wiring all_;
};

/// Checks the settings of a device against those that its driver knows.
void check_settings(const IoRequest& request, const DeviceRequest& device,
                    const guard::SurveyedDevice& driver, yaml::Faults& faults) {
  const std::string subject = "devices." + device.name;
  std::vector<std::string> known;
  for (const guard::KnownSetting& one : driver.settings) {
    known.push_back(one.key);
    const bool is_given =
        std::ranges::find(device.settings, one.key, &DeviceRequest::Setting::key) != device.settings.end();
    if (!one.otherwise && !is_given)
      faults.add({{request.file, device.mark},
                  subject,
                  fmt::format("the driver {} needs the setting '{}' ({})", driver.driver, one.key, one.doc),
                  {}});
  }
  for (const DeviceRequest::Setting& one : device.settings)
    if (std::ranges::find(known, one.key) == known.end())
      faults.add({{request.file, one.mark},
                  subject,
                  yaml::unknown_key(one.key, known, fmt::format("the driver {}", driver.driver)),
                  {}});
}

/// Returns the place of the setting whose value a driver refuses; std::nullopt for another failure. See open
/// in driver.h.
std::optional<yaml::Mark> mark_of_refused(const DeviceRequest& device, const std::string& failure) {
  constexpr std::string_view words = "the setting '";
  const std::size_t at = failure.find(words);
  if (at == std::string::npos) return std::nullopt;
  const std::size_t first = at + words.size();
  const std::string key = failure.substr(first, failure.find('\'', first) - first);
  const auto given = std::ranges::find(device.settings, key, &DeviceRequest::Setting::key);
  return given == device.settings.end() ? device.mark : given->mark;
}

/// Returns the devices with the files of their drivers; a driver without a file is a fault.
std::vector<guard::DeviceSettings> devices_with_files(const IoRequest& request, yaml::Faults& faults) {
  std::vector<guard::DeviceSettings> all;
  for (const DeviceRequest& device : request.devices) try {
      guard::DeviceSettings& one =
          all.emplace_back(guard::DeviceSettings{device.name, device.driver, {}, {}});
      for (const DeviceRequest::Setting& setting : device.settings)
        one.settings.emplace_back(setting.key, setting.value);
      one.file = driver::driver_file(device.driver);
    } catch (const io::EnvironmentError& error) {
      faults.add({{request.file, device.mark}, "devices." + device.name, std::string(error.what()), {}});
    }
  return all;
}

/// Returns the answers of drivers. Throws ProcessStopped once `interrupt` is true.
std::vector<guard::SurveyedDevice> answers_of(const std::vector<guard::DeviceSettings>& devices,
                                              guard::SurveyDepth depth, std::int64_t limit,
                                              const std::atomic<bool>* interrupt) {
  auto answers = guard::survey(devices, depth, limit, interrupt);
  if (!answers) throw subprocess::ProcessStopped("the survey of the drivers was interrupted");
  return std::move(*answers);
}

}  // namespace

std::vector<guard::DeviceSettings> device_settings(const IoRequest& request,
                                                   const std::atomic<bool>* interrupt) {
  yaml::Faults faults;
  std::vector<guard::DeviceSettings> all = devices_with_files(request, faults), with_file;
  std::vector<const DeviceRequest*> of;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!all[i].file.empty()) {
      with_file.push_back(all[i]);
      of.push_back(&request.devices[i]);
    }
  const auto answers = answers_of(with_file, guard::SurveyDepth::load, guard::longest_survey, interrupt);
  for (std::size_t i = 0; i < answers.size(); ++i)
    if (answers[i].failure.empty() && !answers[i].driver.empty())
      check_settings(request, *of[i], answers[i], faults);
    else if (!answers[i].failure.empty())
      faults.add({{request.file, of[i]->mark}, "devices." + of[i]->name, answers[i].failure, {}});
  faults.throw_if_any();
  return all;
}

KnownDevices known_devices(const IoRequest& request, const std::atomic<bool>* interrupt) {
  KnownDevices known{device_settings(request, interrupt), {}};
  known.answers = answers_of(known.settings, guard::SurveyDepth::open,
                             guard::longest_survey + nanoseconds(request.wait), interrupt);
  yaml::Faults faults;
  for (std::size_t i = 0; i < known.answers.size(); ++i) {
    const std::string& failure = known.answers[i].failure;
    if (failure.empty()) continue;
    if (const auto mark = mark_of_refused(request.devices[i], failure))
      faults.add({{request.file, *mark}, "devices." + request.devices[i].name, failure, {}});
    else
      known.failures += (known.failures.empty() ? "" : "\n") + known.settings[i].name + ": " + failure;
  }
  faults.throw_if_any();
  return known;
}

Ports Ports::of(const plan::Plan& plan) {
  return {input_ports(plan), output_ports(plan)};
}

Ports Ports::of(const IoRequest& request) {
  Ports ports;
  for (const InputRequest& one : request.inputs) ports.inputs.push_back({one.port, {}, {}});
  for (const OutputRequest& one : request.outputs) {
    Dimension dimension;
    if (one.limits)
      for (const PlacedNumber& limit : {one.limits->least, one.limits->most})
        if (limit.quantity.dimension) dimension = *limit.quantity.dimension;
    ports.outputs.push_back({one.port, dimension, 0.0});
  }
  return ports;
}

Wiring wire(const IoRequest& request, const Ports& ports, const KnownDevices& devices, double period) {
  return Wirer(request, ports, devices, period).wiring();
}

}  // namespace stepwire::devices
