#include "engine/simulate/replay/run_note.hpp"

#include "engine/base/unit/unit.hpp"
#include "engine/simulate/replay/replay_folder.hpp"

namespace stepwire::replay {

namespace {

/// Returns the index of a run that a file numbers from 1.
std::size_t run_number(const yaml::Node& node, std::size_t runs, const std::string& file) {
  const auto number = unit::parse_quantity(node.text);
  if (number && number->value >= 1.0 && number->value <= static_cast<double>(runs))
    return static_cast<std::size_t>(number->value) - 1;
  throw yaml::Error(
      yaml::Fault{{file, node.mark}, "recorded_runs", "has a run that is none of those of 'runs'", {}});
}

}  // namespace

RunNote read_run_note(const std::string& file) {
  RunNote note;
  note.document = yaml::read_document(file, wide_limits).root;  // JSON is a subset of YAML
  const yaml::Node *sweep = note.document.find("sweep"), *runs = note.document.find("runs");
  const auto count = runs ? unit::parse_quantity(runs->text) : std::nullopt;
  if (!sweep || !count || !(count->value >= 1.0 && count->value < 1e9))
    throw yaml::Error(yaml::Fault{{file, {}}, "", "does not say 'sweep' and 'runs', as every run does", {}});
  note.runs = static_cast<std::size_t>(count->value);
  for (const yaml::Node& axis : sweep->items)
    if (const yaml::Node* parameter = axis.find("parameter")) note.swept.push_back(parameter->text);
  if (const yaml::Node* keep = note.document.find("keep")) note.keep = keep->text;
  if (const yaml::Node* recorded = note.document.find("recorded_runs"))
    for (const yaml::Node& run : recorded->items) note.recorded.push_back(run_number(run, note.runs, file));
  return note;
}

}  // namespace stepwire::replay
