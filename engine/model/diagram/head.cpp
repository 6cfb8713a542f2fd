#include "engine/model/diagram/head.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/model/diagram/keys.hpp"

namespace stepwire {

namespace {

const std::vector<std::string> head_keys = {
    "stepwire",   "title",  "caption", "thesis",     "step",   "stop",      "solver", "tolerance",
    "parameters", "inputs", "outputs", "units",      "blocks", "stop_when", "record", "sweep",
    "figure",     "scene",  "claims",  "invariants", "fit",    "study"};

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

/// How wrong a step of an implicit solver may be, a pure number above 0.
void read_tolerance(const Scope& scope, Settings& settings, Report& report) {
  const Node* node = scope.document->root.find("tolerance");
  const Settings::Entry* setting = settings.take("tolerance");
  settings.offer("tolerance");
  if (!node && !setting) return;
  const Origin origin = setting ? setting->origin : scope.at(node->mark);
  if (setting) node = &setting->document.root;
  const auto value = ValueReader(scope.parameters, report, origin.scope).read_number(*node, {}, "tolerance");
  if (!value) return;
  if (*value <= 0.0)
    return report.add(origin, "tolerance", fmt::format("{} is not allowed; it must be above 0", node->text));
  report.diagram().tolerance = *value;
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
  read_tolerance(scope, settings, report);
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
