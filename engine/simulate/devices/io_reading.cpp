#include <fmt/format.h>

#include <cmath>

#include "engine/base/unit/meaning.hpp"
#include "engine/base/yaml/section.hpp"
#include "engine/simulate/devices/io_request.hpp"

namespace stepwire::devices {

namespace {

using yaml::form;
using yaml::Node;

constexpr double largest = 1e18;  // magnitude of a number, SI
constexpr double hour = 3600.0, day = 24.0 * hour;
constexpr double largest_filter = 1e6;                      // [Hz]
constexpr double least_energy = 1e-12, most_energy = 1e12;  // [J]

/// Returns the form of a number above 0 and at most `most`.
yaml::Key positive(const char* unit, double most) {
  yaml::Key key = form::above_zero(form::number(unit));
  key.most = most;
  return key;
}

yaml::Key energy_form() {
  yaml::Key key = form::number("J");
  key.least = least_energy;
  key.most = most_energy;
  return key;
}

/// Reading of a rig file, whose numbers have units.
class IoReading : public yaml::SectionReading {
 public:
  IoReading(const std::string& file, yaml::Faults& faults)
      : SectionReading("", [file, &faults](const yaml::Mark& mark, const std::string& subject,
                                           const yaml::Message& message) {
          faults.add({{file, mark}, subject, message, {}});
        }) {}

  using SectionReading::take;
  void take(const Node& node, const yaml::Key&, std::optional<bool>& truth) const {
    if (const auto index = word(node, form::truth())) truth = *index == 1;
  }
  void take(const Node& node, const yaml::Key&, std::optional<PlacedNumber>& number) const {
    number = placed(node);
  }
  void take(const Node& node, const yaml::Key& key, std::optional<double>& value) const {
    value = number(node, key);
  }
  void take(const Node& node, const yaml::Key& key, std::optional<PlacedRange>& range) const {
    const auto* const both = pair(node, key);
    if (!both) return;
    const auto least = placed((*both)[0]), most = placed((*both)[1]);
    if (least && most) range = PlacedRange{*least, *most};
  }

 protected:
  std::optional<double> read_number(const Node& node, const yaml::Key& key) const override {
    const auto number = any_number(node);
    if (!number) return std::nullopt;
    const unit::Dimension wanted =
        key.unit.empty() ? unit::Dimension{} : unit::parse_unit(key.unit)->dimension;
    const bool needs_unit = !key.unit.empty() && !number->quantity.dimension && number->quantity.value != 0.0;
    const unit::Dimension given = number->quantity.dimension.value_or(wanted);
    if (const std::string other = unit::other_meaning_of_number(given, wanted); !other.empty()) {
      fault(node.mark, other);
      return std::nullopt;
    }
    if (!needs_unit && given == wanted) return number->quantity.value;
    fault(node.mark,
          yaml::fault_text("'{}' is no number in {}", node.text, key.unit.empty() ? "1" : key.unit));
    return std::nullopt;
  }

 private:
  std::optional<PlacedNumber> any_number(const Node& node) const {
    const auto quantity = node.is_scalar() ? unit::parse_quantity(node.text) : std::nullopt;
    if (quantity) return PlacedNumber{*quantity, node.mark};
    fault(node.mark, yaml::fault_text("'{}' is no number with a unit", node.text));
    return std::nullopt;
  }
  std::optional<PlacedNumber> placed(const Node& node) const {
    auto number = any_number(node);
    if (!number || std::abs(number->quantity.value) <= largest) return number;
    fault(node.mark,
          yaml::fault_text("{} is not allowed; a number of a rig is at most {} in SI", node.text, largest));
    return std::nullopt;
  }
};

template <class Target>
using Table = yaml::KeyTable<Target, IoReading>;

yaml::Key quantity_form() {
  return yaml::like("20 N/V", form::text());
}

yaml::Key range_form() {
  return yaml::like("[0 A, 0.35 A]", form::pair(form::text()));
}

const Table<InputRequest>& input_table() {
  using Request = InputRequest;
  static const Table<Request> table(
      "an input", "{device: card, channel: adc0, scale: 20 N/V}",
      {yaml::needed(
           Table<Request>::Row("device", "name of a device of this file", form::text(), &Request::device)),
       yaml::needed(Table<Request>::Row("channel", "channel of the device", form::text(), &Request::channel)),
       {"unit", "unit of the channel, in place of the one that the driver states", form::unit(),
        &Request::unit},
       {"scale", "factor of the channel's value", quantity_form(), &Request::scale},
       {"offset", "added after the factor, in the unit of the port", quantity_form(), &Request::offset},
       {"range", "values beyond are a fault, such as a broken cable", range_form(), &Request::range},
       {"rate",
        "largest change in a second between two looks at the device; a faster one is a fault, such as an "
        "encoder that jumps",
        quantity_form(), &Request::rate},
       {"stuck", "time after which a value that does not change is a fault", positive("s", day),
        &Request::stuck},
       {"filter", "cutoff of a filter of first order", positive("Hz", largest_filter), &Request::filter},
       {"direction", "sign of the channel's value", form::word({"forward", "reverse"}), &Request::direction},
       {"stale", "effect of a value that is too old: the loop ends, or the last one counts on",
        form::word({"stop", "hold"}), &Request::stale}});
  return table;
}

const Table<OutputRequest>& output_table() {
  using Request = OutputRequest;
  static const Table<Request> table(
      "an output", "{device: card, channel: dac0, scale: 2 V/A, limits: [0 A, 0.35 A]}",
      {yaml::needed(
           Table<Request>::Row("device", "name of a device of this file", form::text(), &Request::device)),
       yaml::needed(Table<Request>::Row("channel", "channel of the device", form::text(), &Request::channel)),
       {"unit", "unit of the channel, in place of the one that the driver states", form::unit(),
        &Request::unit},
       {"scale", "factor of the port's value", quantity_form(), &Request::scale},
       {"offset", "added after the factor, in the unit of the channel", quantity_form(), &Request::offset},
       yaml::needed(Table<Request>::Row("limits", "least and largest value, in the unit of the port",
                                        range_form(), &Request::limits)),
       {"rate", "largest change in a second", quantity_form(), &Request::rate},
       {"safe", "value after the end and after a fault, in place of the diagram's", quantity_form(),
        &Request::safe},
       {"direction", "sign of the port's value", form::word({"forward", "reverse"}), &Request::direction}});
  return table;
}

const Table<DeadManRequest>& dead_man_table() {
  using Request = DeadManRequest;
  static const Table<Request> table(
      "the dead-man input", "{device: card, channel: di0, above: 0.5}",
      {yaml::needed(
           Table<Request>::Row("device", "name of a device of this file", form::text(), &Request::device)),
       yaml::needed(Table<Request>::Row("channel", "channel of the device", form::text(), &Request::channel)),
       {"above", "outputs follow the loop while the channel is above; a bare number is in the channel's unit",
        quantity_form(), &Request::above}});
  return table;
}

const Table<EnergyRequest>& energy_table() {
  using Request = EnergyRequest;
  static const Table<Request> table(
      "a limit of energy", "{force: f, speed: v, most: 5 J}",
      {yaml::needed(Table<Request>::Row("force", "a wired input: force, torque, voltage", form::text(),
                                        &Request::force)),
       yaml::one_of("motion", Table<Request>::Row("speed", "a wired input: speed, current", form::text(),
                                                  &Request::speed)),
       yaml::one_of("motion", Table<Request>::Row("position", "a wired input, whose change counts",
                                                  form::text(), &Request::position)),
       yaml::needed(
           Table<Request>::Row("most", "largest energy in a second", energy_form(), &Request::most))});
  return table;
}

/// Returns the text of a setting; a list is joined by commas.
std::string setting_text(const Node& node, const IoReading& read) {
  std::string text;
  for (const Node& item : node.as_list()) {
    if (!item.is_scalar() && item.kind != Node::Kind::empty)
      read.fault(item.mark, "a setting is a text or a list of texts");
    text += (text.empty() ? "" : ", ") + item.text;
  }
  return text;
}

/// Reads each value of a map of names.
template <class Target, class ReadOne>
void read_names(const Node& map, const IoReading& read, std::vector<Target>& all, const ReadOne& read_one) {
  if (!map.is_map()) return read.fault(map.mark, "is a map of names");
  for (const yaml::Entry& entry : map.entries) {
    Target& one = all.emplace_back();
    one.mark = entry.mark;
    read_one(entry, one, yaml::below(read, entry.key));
  }
}

void read_device(const yaml::Entry& entry, DeviceRequest& device, const IoReading& read) {
  device.name = entry.key;
  if (!entry.value.is_map() || !entry.value.find("driver"))
    return read.fault(entry.mark, "'driver' is missing; {driver: udp, ...}");
  for (const yaml::Entry& one : entry.value.entries)
    if (one.key == "driver")
      device.driver = read.text(one.value);
    else
      device.settings.push_back({one.key, setting_text(one.value, read), one.mark});
}

/// Returns a row whose value is a map of names, each read by a table.
template <class One>
Table<IoRequest>::Row names_row(const char* name, const char* doc, const Table<One>& table,
                                std::vector<One> IoRequest::*all, std::string One::*own) {
  return {name, doc, form::names(table.form),
          [&table, all, own](IoRequest& request, const Node& node, const IoReading& read) {
            read_names(node, read, request.*all,
                       [&](const yaml::Entry& entry, One& one, const IoReading& inner) {
                         one.*own = entry.key;
                         table.read(entry.value, one, inner);
                       });
          }};
}

Table<IoRequest>::Row devices_row() {
  return {"devices", "names of devices, each with its driver and the settings of that",
          yaml::like("{card: {driver: comedi, device: /dev/comedi0}}", form::tree()),
          [](IoRequest& request, const Node& node, const IoReading& read) {
            read_names(node, read, request.devices, read_device);
          }};
}

Table<IoRequest>::Row dead_man_row() {
  return {"dead_man", "input that a hand holds while outputs may move", dead_man_table().form,
          [](IoRequest& request, const Node& node, const IoReading& read) {
            request.dead_man.emplace();
            request.dead_man->mark = node.mark;
            dead_man_table().read(node, *request.dead_man, read);
          }};
}

Table<IoRequest>::Row clock_row() {
  return {"clock", "device whose samples are the deadlines, in place of the timer", form::text(),
          [](IoRequest& request, const Node& node, const IoReading& read) {
            request.clock = read.text(node);
            request.clock_mark = node.mark;
          }};
}

Table<IoRequest>::Row late_row() {
  return {"late", "largest time between two commands, by default one and a half periods", positive("s", hour),
          [](IoRequest& request, const Node& node, const IoReading& read) {
            read.take(node, positive("s", hour), request.late);
            request.late_mark = node.mark;
          }};
}

const Table<IoRequest>& io_table() {
  static const Table<IoRequest> table(
      "a rig", "{devices: {..}, inputs: {..}, outputs: {..}}",
      {yaml::needed(devices_row()),
       names_row("inputs", "inputs of the diagram by name, or elements such as force.1", input_table(),
                 &IoRequest::inputs, &InputRequest::port),
       names_row("outputs", "outputs of the diagram by name, or elements", output_table(),
                 &IoRequest::outputs, &OutputRequest::port),
       dead_man_row(),
       names_row("energy", "limits of the energy in a second, by name", energy_table(), &IoRequest::energies,
                 &EnergyRequest::name),
       {"guard", "true: a process of its own has the devices; by default where there are outputs",
        form::truth(),
        [](IoRequest& request, const Node& node, const IoReading& read) {
          read.take(node, form::truth(), request.guard);
        }},
       late_row(),
       {"wait", "largest time to the first value of each device with wired inputs, 5 s by default",
        positive("s", hour), &IoRequest::wait},
       {"ramp", "time in which outputs go from safe values to the loop's", positive("s", hour),
        &IoRequest::ramp},
       clock_row()});
  return table;
}

}  // namespace

const yaml::Key& io_form() {
  return io_table().form;
}

IoRequest read_io(const std::string& file) {
  const yaml::Document document = yaml::read_document(file);
  IoRequest request;
  request.file = file;
  yaml::Faults faults;
  const IoReading read(file, faults);
  io_table().read(document.root, request, read);
  faults.throw_if_any();
  return request;
}

}  // namespace stepwire::devices
