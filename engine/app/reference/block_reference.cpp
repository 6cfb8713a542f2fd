#include "engine/app/reference/block_reference.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/app/reference/example.hpp"
#include "engine/app/reference/words.hpp"
#include "engine/model/diagram/block_keys.hpp"

namespace stepwire::reference {

namespace {

using Row = std::vector<std::string>;

std::string unit_text(const std::string& unit) {
  if (unit == "1") return "";
  return unit == "*" ? "any" : unit;
}

/// Formats a shape. If a list input concatenates its elements ("+"), each element has a size of its own and
/// the text gives the sum.
std::string size_text(std::string shape) {
  const std::size_t plus = shape.find('+');
  if (plus == std::string::npos) return shape;
  shape.erase(plus, 1);
  const std::string sum = shape.substr(plus, shape.find(' ', plus) - plus);
  return sum == shape ? sum + " in all" : fmt::format("{}, {} in all", shape, sum);
}

ReferenceTable parameters_of(const BlockType& type) {
  ReferenceTable table{"Parameters", {"name", "kind", "unit", "default", "allowed", "meaning"}, {}};
  for (const ParameterSpec& p : type.parameters)
    table.rows.push_back(
        {p.name, kind_text(p.kind), unit_text(p.unit), default_text(type, p), allowed_text(p), p.doc});
  return table;
}

ReferenceTable inputs_of(const BlockType& type) {
  ReferenceTable table{"Inputs", {"name", "takes", "unit", "size", "meaning"}, {}};
  for (const InputSpec& input : type.inputs) {
    const std::string takes = input.list ? "list of signals" : "signal";
    table.rows.push_back({input.name, takes + (input.optional ? ", optional" : ""), unit_text(input.unit),
                          size_text(input.shape), input.doc});
  }
  return table;
}

ReferenceTable outputs_of(const BlockType& type) {
  ReferenceTable table{"Outputs", {"name", "unit", "size", "meaning"}, {}};
  for (const OutputSpec& output : type.outputs) {
    const std::string state = output.state.empty() ? "" : " (the state " + output.state + ")";
    table.rows.push_back({output.name, unit_text(output.unit), size_text(output.shape), output.doc + state});
  }
  return table;
}

ReferenceTable states_of(const BlockType& type) {
  ReferenceTable table{"States", {"name", "kind", "unit", "size", "start", "set by", "meaning"}, {}};
  for (const StateSpec& state : type.states) {
    ParameterSpec start;
    start.unit = state.unit;
    table.rows.push_back({state.name, state.continuous ? "continuous" : "discrete", unit_text(state.unit),
                          size_text(state.shape), value_text(start, {state.initial}),
                          state.settable ? diagram::initial_key(type, state) : "", state.doc});
  }
  return table;
}

ReferenceTable presets_of(const BlockType& type) {
  ReferenceTable table{"Presets", {"name", "meaning"}, {}};
  for (const PresetSpec& preset : type.presets) table.rows.push_back({preset.name, preset.doc});
  return table;
}

ReferenceTable diagnostics_of(const BlockType& type) {
  ReferenceTable table{"Notices", {"name", "effect", "meaning"}, {}};
  for (const DiagnosticSpec& diagnostic : type.diagnostics) {
    const char* const end = diagnostic.is_fault ? "ends the run" : "ends the run, as 'stop_when' does";
    table.rows.push_back({diagnostic.name, diagnostic.ends_run ? end : "is told once", diagnostic.doc});
  }
  return table;
}

bool has_unit_variable(const ReferenceTable& table) {
  for (const Row& row : table.rows)
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      if (row[i].find('\'') != std::string::npos) return true;
  return false;
}

}  // namespace

void drop_empty_columns(ReferenceTable& table) {
  for (std::size_t column = table.header.size() - 1; column > 0; --column) {
    const bool empty = std::all_of(table.rows.begin(), table.rows.end(),
                                   [&](const Row& row) { return row[column].empty(); });
    if (!empty) continue;
    const auto at = static_cast<std::ptrdiff_t>(column);
    table.header.erase(table.header.begin() + at);
    for (Row& row : table.rows) row.erase(row.begin() + at);
  }
}

BlockReference reference_of(const BlockType& type) {
  BlockReference sheet{type.name, type.folder, type.doc, {}, {}, "", block_example(type)};
  if (!type.source.empty()) sheet.facts.emplace_back("source", type.source);
  sheet.facts.emplace_back("timing", timing_text(type.timing));
  if (const std::string text = feedthrough_text(type); !text.empty())
    sheet.facts.emplace_back("feedthrough", text);
  if (!type.not_real_time.empty())
    sheet.facts.emplace_back("real time", "not in a real-time loop: " + type.not_real_time);
  for (ReferenceTable table : {parameters_of(type), inputs_of(type), outputs_of(type), states_of(type),
                               presets_of(type), diagnostics_of(type)}) {
    if (table.rows.empty()) continue;
    drop_empty_columns(table);
    if (has_unit_variable(table))
      sheet.remark =
          "A unit with a quote ('u) is that of what is wired or given there, the same in the whole block.";
    sheet.tables.push_back(std::move(table));
  }
  return sheet;
}

}  // namespace stepwire::reference
