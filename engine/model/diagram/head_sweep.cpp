// The values that a file runs itself for.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "engine/model/diagram/head.hpp"
#include "engine/model/diagram/head_keys.hpp"

namespace stepwire {

namespace {

constexpr std::size_t max_runs = 100'000;  // of a sweep; each is planned before the first one starts

std::string setting_text(const Node& node) {
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
std::optional<std::pair<double, std::string>> number_and_unit(const Node& node) {
  if (!node.is_scalar() || !parse_quantity(node.text)) return std::nullopt;
  const std::size_t sign = node.text.starts_with('+') ? 1 : 0;
  double number = 0.0;
  const char* const end = node.text.data() + node.text.size();
  const char* rest = std::from_chars(node.text.data() + sign, end, number).ptr;
  while (rest != end && *rest == ' ') ++rest;
  return std::pair(number, std::string(rest, end));
}

std::vector<std::string> read_range(const Node& map, const std::string& name, const Scope& scope,
                                    Report& report) {
  const std::string subject = "sweep." + name;
  if (!map.is_map()) {
    report.add(scope.at(map.mark), subject, "is written [.., ..] or {from: .., to: .., count: ..}");
    return {};
  }
  const std::size_t before = report.faults().size();
  HeadReading(subject, scope, report).check(map, range_form());
  if (report.faults().size() > before) return {};
  const ValueReader reader(scope.parameters, report, scope.index);
  std::vector<double> numbers;
  std::vector<std::optional<Dimension>> dimensions;
  for (const char* key : {"from", "to", "count"}) {
    const Node* node = map.find(key);
    const auto written = reader.read(*node, subject);
    if (!written) return {};
    const double* number = std::get_if<double>(&written->value.content);
    if (!number) {
      report.add(scope.at(node->mark), subject,
                 fmt::format("'{}' is no number; words are swept as a list", written->text));
      return {};
    }
    numbers.push_back(*number);
    dimensions.push_back(written->dimension);
  }
  if (const std::string complaint = unit_complaint(dimensions[1], dimensions[0]); !complaint.empty()) {
    report.add(scope.at(map.find("to")->mark), subject, fmt::format("'to' {}", complaint));
    return {};
  }
  const double count = numbers[2];
  if (count < 2 || count != std::floor(count) || count > max_runs) {
    report.add(scope.at(map.find("count")->mark), subject,
               fmt::format("'count' must be a whole number from 2 to {}", max_runs));
    return {};
  }
  const auto& dimension = dimensions[0] ? dimensions[0] : dimensions[1];
  std::string unit = dimension && *dimension != Dimension{} ? si_name(*dimension) : "";
  const auto from = number_and_unit(*map.find("from")), to = number_and_unit(*map.find("to"));
  if (from && to && from->second == to->second) {  // 1 mm to 9 mm is whole in millimetres, not in metres
    numbers = {from->first, to->first};
    unit = from->second;
  }
  std::vector<std::string> values;
  for (double i = 0; i < count; ++i)
    values.push_back(fmt::format("{}{}{}", value_of_range(numbers[0], numbers[1], i, count - 1),
                                 unit.empty() ? "" : " ", unit));
  return values;
}

void read_axis(const Entry& entry, Sweep& sweep, const Scope& scope, Report& report) {
  const Node* list = entry.value.is_map() ? entry.value.find("values") : &entry.value;
  Sweep::Axis axis{entry.key, {}, {}, scope.at(entry.mark)};
  if (list && list->is_list()) {
    for (const Node& item : list->items) {
      axis.values.push_back(setting_text(item));
      axis.marks.push_back(item.mark);
    }
    if (axis.values.empty()) report.add(scope.at(list->mark), "sweep." + entry.key, "has no values");
  } else {
    axis.values = read_range(entry.value, entry.key, scope, report);
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

}  // namespace

void read_sweep(const Scope& scope, Report& report) {
  const Node* node = scope.document->root.find("sweep");
  if (!node) return;
  if (!node->is_map())
    return report.add(scope.at(node->mark), "sweep",
                      "must be a map of parameter: {from, to, count} or {values: [..]}");
  Sweep sweep;
  if (const Node* together = node->find("together"))
    HeadReading("sweep.together", scope, report).take(*together, form::truth(), sweep.together);
  for (const Entry& entry : node->entries) {
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

}  // namespace stepwire
