#include "engine/diagram/head.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/diagram/keys.hpp"

namespace stepwire {

namespace {

const std::vector<std::string> head_keys = {
    "stepwire",   "title",  "caption", "thesis", "step",       "stop",      "solver",
    "parameters", "inputs", "outputs", "units",  "blocks",     "stop_when", "record",
    "sweep",      "figure", "scene",   "claims", "invariants", "fit",       "study"};

constexpr double most_steps = 9e15;  // whole numbers beyond are not exact in a double

/// Times of the head: seconds, above 0.
void read_time(const Scope& scope, Settings& settings, Report& report, const std::string& key,
               double& seconds, Origin& origin) {
  const Node* node = scope.document->root.find(key);
  const Settings::Entry* setting = settings.take(key);
  settings.offer(key);
  if (!node && !setting)
    return report.add(scope.at(scope.document->root.mark), "",
                      fmt::format("'{}' is missing; e.g. {}: {}", key, key, key == "step" ? "1 ms" : "5 s"));
  origin = setting ? setting->origin : scope.at(node->mark);
  if (setting) node = &setting->document.root;
  const ValueReader reader(scope.parameters, report, origin.scope);
  const auto value = reader.read_number(*node, parse_unit("s")->dimension, key);
  if (!value) return;
  if (*value <= 0.0)
    return report.add(origin, key, fmt::format("{} is not allowed; it must be above 0", node->text));
  seconds = *value;
}

void read_solver(const Scope& scope, Settings& settings, Report& report) {
  Diagram& diagram = report.diagram();
  settings.offer("solver");
  if (const Settings::Entry* setting = settings.take("solver")) {
    diagram.solver = setting->document.root.text;
    diagram.solver_origin = setting->origin;
  } else if (const Node* solver = scope.document->root.find("solver")) {
    diagram.solver = read_text(*solver, "solver", scope, report);
    diagram.solver_origin = scope.at(solver->mark);
  }
}

std::string text_of(const Scope& scope, const char* key, Report& report) {
  const Node* node = scope.document->root.find(key);
  return node ? read_text(*node, key, scope, report) : "";
}

void read_version(const Scope& scope, Report& report) {
  const Node& root = scope.document->root;
  const Node* version = root.find("stepwire");
  if (!version)
    return report.add(scope.at(root.mark), "",
                      "'stepwire: 1' is missing; it says that this is a diagram file of format 1");
  if (version->text != "1")
    report.add(scope.at(version->mark), "stepwire",
               fmt::format("format '{}' is not known; this program reads format 1", version->text));
}

std::vector<std::string> read_departures(const Node& thesis, const Scope& scope, Report& report) {
  std::vector<std::string> departures;
  const Node* node = thesis.find("departures");
  if (!node) return departures;
  if (!node->is_list()) {
    report.add(scope.at(node->mark), "thesis.departures",
               "is a list of sentences: [the limit is 0.35 A, not 1 A]");
    return departures;
  }
  for (const Node& item : node->items)
    departures.push_back(read_text(item, "thesis.departures", scope, report));
  return departures;
}

void read_thesis(const Scope& scope, Report& report) {
  const Node* thesis = scope.document->root.find("thesis");
  if (!thesis) return;
  if (!thesis->is_map())
    return report.add(scope.at(thesis->mark), "thesis", "must be a map such as {figure: 15, section: 2.5.1}");
  refuse_unknown_keys(*thesis, {"figure", "table", "section", "caption", "says", "departures"}, "thesis",
                      scope, report);
  const auto number = [&](const char* key) -> std::optional<int> {
    const Node* node = thesis->find(key);
    if (!node) return std::nullopt;
    const auto value = parse_quantity(node->text);
    if (value && !value->dimension && value->value == std::floor(value->value) &&
        std::abs(value->value) < 1e6)
      return static_cast<int>(value->value);
    report.add(scope.at(node->mark), fmt::format("thesis.{}", key),
               fmt::format("'{}' is not a whole number", node->text));
    return std::nullopt;
  };
  const auto text = [&](const char* key) {
    const Node* node = thesis->find(key);
    return node ? read_text(*node, fmt::format("thesis.{}", key), scope, report) : "";
  };
  report.diagram().thesis = {number("figure"), number("table"), text("section"),
                             text("caption"),  text("says"),    read_departures(*thesis, scope, report)};
}

constexpr std::size_t most_runs = 100'000;  // of a sweep; each is planned before the first one starts

std::string setting_text(const Node& node) {
  return node.quoted ? fmt::format("\"{}\"", node.text) : node.text;
}

std::vector<std::string> read_range(const Node& map, const std::string& name, const Scope& scope,
                                    Report& report) {
  const std::string subject = "sweep." + name;
  const char* const form = "is written [.., ..] or {from: .., to: .., count: ..}";
  if (refuse_unknown_keys(map, {"from", "to", "count"}, subject, scope, report)) return {};
  const ValueReader reader(scope.parameters, report, scope.index);
  std::vector<double> numbers;
  std::vector<std::optional<Dimension>> dimensions;
  for (const char* key : {"from", "to", "count"}) {
    const Node* node = map.find(key);
    if (!node) {
      report.add(scope.at(map.mark), subject,
                 map.is_map() ? fmt::format("'{}' is missing; it {}", key, form) : form);
      return {};
    }
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
  if (count < 2 || count != std::floor(count) || count > most_runs) {
    report.add(scope.at(map.find("count")->mark), subject,
               fmt::format("'count' must be a whole number from 2 to {}", most_runs));
    return {};
  }
  const auto& dimension = dimensions[0] ? dimensions[0] : dimensions[1];
  const std::string unit = dimension && *dimension != Dimension{} ? " " + si_name(*dimension) : "";
  std::vector<std::string> values;
  for (double i = 0; i < count; ++i)
    values.push_back(fmt::format("{}{}", numbers[0] + (numbers[1] - numbers[0]) * (i / (count - 1)), unit));
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

void read_sweep(const Scope& scope, Report& report) {
  const Node* node = scope.document->root.find("sweep");
  if (!node) return;
  if (!node->is_map())
    return report.add(scope.at(node->mark), "sweep",
                      "must be a map of parameter: {from, to, count} or {values: [..]}");
  Sweep sweep;
  if (const Node* together = node->find("together"))
    sweep.together = read_flag(*together, "sweep.together", scope, report);
  for (const Entry& entry : node->entries) {
    if (entry.key != "together") read_axis(entry, sweep, scope, report);
    if (run_count(sweep) > most_runs)
      return report.add(
          scope.at(node->mark), "sweep",
          fmt::format("makes {} runs or more; at most {} are made", run_count(sweep), most_runs));
  }
  for (const Sweep::Axis& axis : sweep.axes)
    if (sweep.together && axis.values.size() != sweep.axes.front().values.size())
      report.add(
          axis.origin, "sweep." + axis.parameter,
          fmt::format("has {} values, '{}' has {}; with 'together: true' they are paired", axis.values.size(),
                      sweep.axes.front().parameter, sweep.axes.front().values.size()));
  report.diagram().sweep = std::move(sweep);
}

}  // namespace

void check_head_keys(const Scope& scope, Report& report) {
  const Node& root = scope.document->root;
  if (!root.is_map())
    return report.add(scope.at(root.mark), "",
                      "this is no diagram; a diagram is a map with stepwire, title, step, stop, blocks");
  read_version(scope, report);
  refuse_unknown_keys(root, head_keys, "", scope, report);
}

void read_head(const Scope& scope, Settings& settings, Report& report) {
  Diagram& diagram = report.diagram();
  diagram.title = text_of(scope, "title", report);
  diagram.caption = text_of(scope, "caption", report);
  read_solver(scope, settings, report);
  read_time(scope, settings, report, "step", diagram.step, diagram.step_origin);
  read_time(scope, settings, report, "stop", diagram.stop, diagram.stop_origin);
  if (diagram.step > 0.0 && diagram.stop / diagram.step > most_steps)
    report.add(diagram.stop_origin, "stop",
               fmt::format("{} s are more than {} steps of {} s", diagram.stop, most_steps, diagram.step));
  read_thesis(scope, report);
}

void read_head_of_file(const Scope& scope, Report& report) {
  Diagram& diagram = report.diagram();
  read_sweep(scope, report);
  if (const Node* figure = scope.document->root.find("figure")) diagram.figure = *figure;
  if (const Node* scene = scope.document->root.find("scene")) diagram.scene = *scene;
  if (const Node* claims = scope.document->root.find("claims")) diagram.claims = *claims;
  if (const Node* invariants = scope.document->root.find("invariants")) diagram.invariants = *invariants;
  if (const Node* fit = scope.document->root.find("fit")) diagram.fit = *fit;
}

}  // namespace stepwire
