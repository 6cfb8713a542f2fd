// The values that a file runs itself for.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "engine/base/yaml/message.hpp"
#include "engine/base/yaml/yaml_text.hpp"
#include "engine/model/diagram/head.hpp"
#include "engine/model/diagram/head_keys.hpp"
#include "engine/model/diagram/own_value.hpp"

namespace stepwire::diagram {

namespace {

constexpr std::size_t max_runs = 100'000;  // of a sweep; each is planned before the first one starts

std::string setting_text(const yaml::Node& node) {
  if (!node.is_scalar()) return yaml::yaml_line(node);
  return node.quoted ? fmt::format("\"{}\"", node.text) : node.text;
}

/// Value i of a range of n + 1: multiplied first, so that whole ends give whole values in between, and the
/// last is `to` itself.
double value_of_range(double from, double to, double i, double n) {
  if (i == n) return to;
  const double rise = i * (to - from);
  return std::isfinite(rise) ? from + rise / n : from * (1.0 - i / n) + to * (i / n);
}

/// A number as it is written, and its unit: "5 mm" is {5, "mm"}.
std::optional<std::pair<double, std::string>> number_and_unit(const yaml::Node& node) {
  if (!node.is_scalar() || !unit::parse_quantity(node.text)) return std::nullopt;
  const std::size_t sign = node.text.starts_with('+') ? 1 : 0;
  double number = 0.0;
  const char* const end = node.text.data() + node.text.size();
  const char* rest = std::from_chars(node.text.data() + sign, end, number).ptr;
  while (rest != end && *rest == ' ') ++rest;
  return std::pair(number, std::string(rest, end));
}

/// Reads {from: .., to: .., count: ..}; gives no values where there is a fault.
class RangeReading {
 public:
  RangeReading(const yaml::Node& map, const std::string& name, const Scope& scope, Report& report)
      : map_(map), subject_("sweep." + name), scope_(scope), report_(report) {}

  std::vector<std::string> values() {
    if (!has_form()) return {};
    const auto from = number("from");
    const auto to = from ? number("to") : std::nullopt;
    const auto count = to ? number("count") : std::nullopt;
    if (!count) return {};
    if (const std::string complaint = unit_complaint(to->dimension, from->dimension); !complaint.empty())
      return refuse(map_.find("to")->mark, fmt::format("'to' {}", complaint));
    if (count->value < 2 || count->value != std::floor(count->value) || count->value > max_runs)
      return refuse(map_.find("count")->mark,
                    fmt::format("'count' must be a whole number from 2 to {}", max_runs));
    const auto written_from = number_and_unit(*map_.find("from")),
               written_to = number_and_unit(*map_.find("to"));
    // 1 mm to 9 mm is whole in millimetres, not in metres.
    if (written_from && written_to && written_from->second == written_to->second)
      return texts(written_from->first, written_to->first, count->value, written_from->second);
    const auto& dimension = from->dimension ? from->dimension : to->dimension;
    return texts(from->value, to->value, count->value,
                 dimension && *dimension != unit::Dimension{} ? unit::si_name(*dimension) : "");
  }

 private:
  struct Number {
    double value;
    std::optional<unit::Dimension> dimension;
  };

  std::vector<std::string> refuse(const yaml::Mark& mark, yaml::Message message) {
    report_.add(scope_.at(mark), subject_, std::move(message));
    return {};
  }

  bool has_form() {
    const std::size_t before = report_.faults().size();
    if (map_.is_map())
      HeadReading(subject_, scope_, report_).check(map_, range_form());
    else
      refuse(map_.mark, "is written [.., ..] or {from: .., to: .., count: ..}");
    return report_.faults().size() == before;
  }

  std::optional<Number> number(const char* key) {
    const yaml::Node& node = *map_.find(key);
    const auto written = ValueReader(scope_.parameters, report_, scope_.index).read(node, subject_);
    if (!written) return std::nullopt;
    if (const double* number = std::get_if<double>(&written->value.content))
      return Number{*number, written->dimension};
    refuse(node.mark, yaml::fault_text("'{}' is no number; words are swept as a list", written->text));
    return std::nullopt;
  }

  static std::vector<std::string> texts(double from, double to, double count, const std::string& unit) {
    std::vector<std::string> texts;
    for (double i = 0; i < count; ++i)
      texts.push_back(
          fmt::format("{}{}{}", value_of_range(from, to, i, count - 1), unit.empty() ? "" : " ", unit));
    return texts;
  }

  const yaml::Node& map_;
  const std::string subject_;
  const Scope& scope_;
  Report& report_;
};

void read_axis(const yaml::Entry& entry, Sweep& sweep, const Scope& scope, Report& report) {
  const yaml::Node* list = entry.value.is_map() ? entry.value.find("values") : &entry.value;
  Sweep::Axis axis{entry.key, {}, {}, scope.at(entry.mark)};
  if (list && list->is_list()) {
    for (const yaml::Node& item : list->items) {
      axis.values.push_back(setting_text(item));
      axis.marks.push_back(item.mark);
    }
    if (axis.values.empty()) report.add(scope.at(list->mark), "sweep." + entry.key, "has no values");
  } else {
    axis.values = RangeReading(entry.value, entry.key, scope, report).values();
    axis.marks.assign(axis.values.size(), entry.value.mark);
  }
  sweep.axes.push_back(std::move(axis));
}

/// Runs of a grid, or of pairs; a double holds more of them than anybody could want.
double run_count(const Sweep& sweep) {
  double count = 1.0;
  for (const Sweep::Axis& axis : sweep.axes) {
    const auto values = static_cast<double>(axis.values.size());
    count = sweep.together ? std::max(count, values) : count * values;
  }
  return count;
}

/// The file's own value of what is swept, as a point sets it; a fault where there is none.
std::string base_value(const Sweep::Axis& axis, Report& report) {
  const auto refuse = [&](const yaml::Message& message) {
    report.add(axis.origin, "sweep.one_at_a_time." + axis.parameter, message);
    return std::string();
  };
  const Diagram& diagram = report.diagram();
  const auto name = find_name(diagram, axis.parameter);
  if (!name)
    return refuse("is no parameter of the file, of its parts or blocks" +
                  nearest_name(diagram, axis.parameter));
  const auto value = own_value(diagram, *name);
  if (!value)
    return refuse("has no value in the file, which each point but those that differ in it has; write one");
  return *value;
}

/// A column of words about the points of a sweep.
Sweep::Axis label(const char* name, std::vector<std::string> words, const Origin& origin) {
  Sweep::Axis axis{name, std::move(words), {}, origin, true};
  axis.marks.assign(axis.values.size(), origin.mark);
  return axis;
}

/// Pairs the values of the axes: at the first point all are the file's own, at each other one differs.
void set_apart(Sweep& sweep, const Origin& origin, Report& report) {
  std::vector<std::string> which{nothing_differs}, what{""};
  for (const Sweep::Axis& axis : sweep.axes)
    for (const std::string& value : axis.values) {
      which.push_back(axis.parameter);
      what.push_back(value);
    }
  for (Sweep::Axis& axis : sweep.axes) {
    std::vector<std::string> values(which.size(), base_value(axis, report));
    std::vector<yaml::Mark> marks(which.size(), axis.origin.mark);
    const auto first = std::ranges::find(which, axis.parameter) - which.begin();
    std::ranges::copy(axis.values, values.begin() + first);
    std::ranges::copy(axis.marks, marks.begin() + first);
    axis.values = std::move(values);
    axis.marks = std::move(marks);
  }
  sweep.together = true;
  sweep.axes.push_back(label(differs_label, std::move(which), origin));
  sweep.axes.push_back(label(differs_to_label, std::move(what), origin));
}

void read_one_at_a_time(const yaml::Node& section, const yaml::Node& axes, const Scope& scope,
                        Report& report) {
  const auto refuse = [&](const yaml::Mark& mark, const char* message) {
    report.add(scope.at(mark), "sweep.one_at_a_time", message);
  };
  if (section.entries.size() > 1)
    return refuse(axes.mark, "stands alone in its sweep; all that is varied is named in it");
  if (!axes.is_map() || axes.entries.empty())
    return refuse(axes.mark, "is a map of parameters and their values: {mass: [1 kg, 3 kg]}");
  Sweep sweep;
  const std::size_t before = report.faults().size();
  for (const yaml::Entry& entry : axes.entries) {
    if (entry.key == nothing_differs)
      refuse(entry.mark, "'base' is the word for the point at which no parameter differs; rename it");
    read_axis(entry, sweep, scope, report);
  }
  if (report.faults().size() == before) set_apart(sweep, scope.at(axes.mark), report);
  if (run_count(sweep) > max_runs) return refuse(axes.mark, "makes more than 100000 runs");
  report.diagram().sweep = std::move(sweep);
}

}  // namespace

void read_sweep(const Scope& scope, Report& report) {
  const yaml::Node* node = scope.document->root.find("sweep");
  if (!node) return;
  if (!node->is_map())
    return report.add(scope.at(node->mark), "sweep",
                      "must be a map of parameter: {from, to, count} or {values: [..]}");
  if (const yaml::Node* one = node->find("one_at_a_time"))
    return read_one_at_a_time(*node, *one, scope, report);
  Sweep sweep;
  if (const yaml::Node* together = node->find("together"))
    HeadReading("sweep.together", scope, report).take(*together, yaml::form::truth(), sweep.together);
  for (const yaml::Entry& entry : node->entries) {
    if (entry.key != "together") read_axis(entry, sweep, scope, report);
    if (run_count(sweep) > max_runs)
      return report.add(
          scope.at(node->mark), "sweep",
          fmt::format("makes {} runs or more; at most {} are made", run_count(sweep), max_runs));
  }
  for (const Sweep::Axis& axis : sweep.axes)
    if (sweep.together && axis.values.size() != sweep.axes.front().values.size())
      report.add(
          axis.origin, "sweep." + axis.parameter,
          fmt::format("has {} values, '{}' has {}; with 'together: true' they are paired", axis.values.size(),
                      sweep.axes.front().parameter, sweep.axes.front().values.size()));
  report.diagram().sweep = std::move(sweep);
}

}  // namespace stepwire::diagram
