#include "engine/model/diagram/head.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/yaml/message.hpp"
#include "engine/model/diagram/head_keys.hpp"

namespace stepwire::diagram {

namespace {

constexpr double max_steps = 9e15;  // larger whole numbers are not exact in a double

void read_version(const Scope& scope, Report& report) {
  const yaml::Node& root = scope.document->root;
  const yaml::Node* version = root.find("stepwire");
  if (!version)
    return report.add(scope.at(root.mark), "",
                      "'stepwire: 1' is missing; it says that this is a diagram file of format 1");
  if (version->text != "1")
    report.add(scope.at(version->mark), "stepwire",
               yaml::fault_text("format '{}' is not known; this program reads format 1", version->text));
}

/// Sets the value of a row from the file, or from a setting of the call.
void read_row(const yaml::KeyRow<Diagram, HeadReading>& row, const Scope& scope, Settings& settings,
              Report& report) {
  static const std::vector<std::string> settable{"step", "stop", "solver", "tolerance"};
  const bool may_be_set = std::ranges::find(settable, row.name) != settable.end();
  const Settings::Entry* setting = may_be_set ? settings.take(row.name) : nullptr;
  if (may_be_set) settings.offer(row.name);
  const yaml::Node* node = setting ? &setting->document.root : scope.document->root.find(row.name);
  if (!node && (row.name == "step" || row.name == "stop"))
    report.add(scope.at(scope.document->root.mark), "", HeadReading::missing(row));
  if (!node || !row.set) return;
  const Origin origin = setting ? setting->origin : scope.at(node->mark);
  row.set(report.diagram(), *node, HeadReading(row.name, scope, report, origin));
}

/// Adds a fault for each conflict that a merge has left in the file.
void refuse_conflicts(const Scope& scope, Report& report) {
  const yaml::Node* conflicts = scope.document->root.find("conflicts");
  if (!conflicts) return;
  const auto text_of = [](const yaml::Node& item, const char* key) {
    const yaml::Node* value = item.find(key);
    return value && value->is_scalar() ? value->text : std::string("unknown");
  };
  if (!conflicts->is_list() || conflicts->items.empty())
    report.add(scope.at(conflicts->mark), "conflicts", "has no conflict; remove the section");
  for (const yaml::Node& item : conflicts->items)
    report.add(
        scope.at(item.mark), text_of(item, "at"),
        yaml::fault_text("ours is {}, theirs is {}, before it was {}; write the right value there and remove "
                         "this item of 'conflicts'",
                         text_of(item, "ours"), text_of(item, "theirs"), text_of(item, "base")));
}

}  // namespace

void check_head_keys(const Scope& scope, Report& report) {
  const yaml::Node& root = scope.document->root;
  if (!root.is_map())
    return report.add(scope.at(root.mark), "",
                      "this is no diagram; a diagram is a map with stepwire, title, step, stop, blocks");
  read_version(scope, report);
  HeadReading("", scope, report).check_unknown(root, head_form());
  refuse_conflicts(scope, report);
}

void read_head(const Scope& scope, Settings& settings, Report& report) {
  const Diagram& diagram = report.diagram();
  for (const auto& row : head_rows()) read_row(row, scope, settings, report);
  if (diagram.step > 0.0 && diagram.stop / diagram.step > max_steps)
    report.add(diagram.stop_origin, "stop",
               fmt::format("{} s are more than {} steps of {} s", diagram.stop, max_steps, diagram.step));
}

void read_head_of_file(const Scope& scope, Report& report) {
  Diagram& diagram = report.diagram();
  read_sweep(scope, report);
  if (const yaml::Node* figure = scope.document->root.find("figure")) diagram.figure = *figure;
  if (const yaml::Node* scene = scope.document->root.find("scene")) diagram.scene = *scene;
  if (const yaml::Node* claims = scope.document->root.find("claims")) diagram.claims = *claims;
  if (const yaml::Node* invariants = scope.document->root.find("invariants"))
    diagram.invariants = *invariants;
  if (const yaml::Node* fit = scope.document->root.find("fit")) diagram.fit = *fit;
  if (const yaml::Node* node = scope.document->root.find("sensitivity")) diagram.sensitivity = *node;
}

}  // namespace stepwire::diagram
