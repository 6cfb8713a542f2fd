#include "engine/simulate/codegen/statements.hpp"
#include "engine/simulate/codegen/workspace_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/simulate/codegen/headers.hpp"

namespace stepwire::codegen {

Phase phase_of(const BlockType& type, Kernel kernel, Phase otherwise) {
  if (type.run_outputs_at_instant.contains(kernel)) return Phase::outputs_at_instant;
  return type.run_update_at_event.contains(kernel) ? Phase::update_at_event : otherwise;
}

const char* function_of(Phase phase) {
  switch (phase) {
    case Phase::outputs:
      return "outputs";
    case Phase::outputs_at_instant:
      return "outputs_at_instant";
    case Phase::derivatives:
      return "derivatives";
    case Phase::update:
      return "update";
    case Phase::update_at_event:
      return "update_at_event";
    case Phase::update_before_instant:
      return "update_before_instant";
    case Phase::crossings:
      return "crossings";
    case Phase::next_edge:
      return "next_edge";
    default:
      return "start";
  }
}

namespace {

constexpr std::string_view over_functions = "<stepwire::Function>";

/// True if the struct of a type is a template over the type of its functions.
bool is_over_functions(const BlockType& type) {
  return type.struct_name.ends_with(over_functions);
}

/// Returns the members of a new block of a type, as text. Equal ones need not be written.
std::map<std::string, std::string> defaults_of(const BlockType& type) {
  const AnyBlock fresh(type);
  Literals literals;
  if (is_over_functions(type)) literals.begin_functions();
  std::map<std::string, std::string> defaults;
  for (const MemberSpec& member : type.members)
    defaults[member.member] = member.literal(fresh.get(), literals);
  return defaults;
}

}  // namespace

std::string struct_of(const plan::Plan& plan, std::size_t block) {
  const BlockType& type = plan.diagram.blocks[block].type();
  std::string name =
      type.struct_name.starts_with("stepwire::") ? type.struct_name.substr(10) : type.struct_name;
  if (is_over_functions(type))
    name.replace(name.size() - over_functions.size(), over_functions.size(), "<Code>");
  return name;
}

Statements::Statements(const plan::Plan& plan, const PlaceNames& names,
                       const std::vector<plan::VariableBlock>& variable, const LanePlaces& lanes,
                       Literals& literals)
    : plan_(plan),
      names_(names),
      lanes_(lanes),
      members_(plan.blocks.size()),
      functions_(plan.blocks.size()) {
  std::map<std::string, std::map<std::string, std::string>> defaults;
  auto next = variable.begin();
  for (int index : plan.memory_order) {
    const auto b = static_cast<std::size_t>(index);
    const diagram::DiagramBlock& block = plan.diagram.blocks[b];
    const auto [known, is_new] = defaults.try_emplace(block.type().name);
    if (is_new) known->second = defaults_of(block.type());
    const bool varies = next != variable.end() && next->block == b;
    literals.vary(varies ? next->items : std::vector<bool>());
    if (is_over_functions(block.type())) literals.begin_functions();
    for (const MemberSpec& member : block.type().members) {
      literals.name_tables(names.block(b) + "_" + member.member);
      const std::string value = member.literal(block.block.get(), literals);
      members_[b].push_back({member.member, value, value == known->second[member.member]});
    }
    if (is_over_functions(block.type())) functions_[b] = literals.end_functions(names.block(b) + "_code");
    if (varies) ++next;
  }
}

Statements::Pieces Statements::set_up(std::size_t block, const Places& places, bool complete) const {
  Pieces pieces{{declaration(block), "", ""}};
  for (const Member& member : members_[block])
    if (complete || !member.is_default)
      pieces.push_back({fmt::format("    b.{} = ", member.name), member.value, ";\n"});
  bind_inputs(block, places, pieces);
  bind_outputs(block, places, pieces);
  bind_states(block, places, pieces);
  bind_rest(block, places, pieces);
  return pieces;
}

std::string Statements::declaration(std::size_t block) const {
  const std::string text = fmt::format("    {} b;\n", struct_of(plan_, block));
  return functions_[block].empty() ? text
                                   : fmt::format("    using Code = formula::{};\n", functions_[block]) + text;
}

std::string Statements::in_lane(const std::string& numbers, std::size_t offset, const Places& places) const {
  const LanePlaces& of = lanes(places);
  return of.lanes == 1 ? numbers : numbers + lane_text(of, of.places[offset]);
}

Statements::Piece Statements::place(const std::string& before, std::size_t offset, const std::string& after,
                                    const Places& places) const {
  const bool fresh = offset < places.is_fresh.size() && places.is_fresh[offset];
  const auto at = static_cast<std::int64_t>(offset);
  if (fresh && offset >= plan_.layout.derivatives)
    return {fmt::format("{}{} + (", before, in_lane(places.dot, offset, places)), names_.at(offset),
            " - first_derivative)" + after, at};
  return {fmt::format("{}{} + ", before, in_lane(fresh ? places.fresh : "w", offset, places)),
          names_.at(offset), after, at};
}

void Statements::bind_inputs(std::size_t block, const Places& places, Pieces& pieces) const {
  const BlockType& type = plan_.diagram.blocks[block].type();
  for (std::size_t i = 0; i < type.inputs.size(); ++i) {
    const auto& slots = plan_.blocks[block].inputs[i];
    const std::string& member = type.inputs[i].member;
    if (slots.empty()) continue;
    if (!type.inputs[i].list) {
      pieces.push_back(place(fmt::format("    b.{}.bind(", member), slots[0].offset,
                             fmt::format(", {});\n", slots[0].size), places));
      continue;
    }
    pieces.push_back({fmt::format("    const Inputs::Element {}[] = {{", member), "", ""});
    for (std::size_t k = 0; k < slots.size(); ++k)
      pieces.push_back(
          place(k == 0 ? "{" : ", {", slots[k].offset, fmt::format(", {}}}", slots[k].size), places));
    pieces.push_back({fmt::format("}};\n    b.{0}.bind({0}, {1});\n", member, slots.size()), "", ""});
  }
}

void Statements::bind_outputs(std::size_t block, const Places& places, Pieces& pieces) const {
  const BlockType& type = plan_.diagram.blocks[block].type();
  for (std::size_t o = 0; o < type.outputs.size(); ++o) {
    const plan::SignalSlot& slot = plan_.blocks[block].outputs[o];
    if (slot.size > 0)
      pieces.push_back(place(fmt::format("    b.{}.bind(", type.outputs[o].member), slot.offset,
                             fmt::format(", {});\n", slot.size), places));
  }
}

void Statements::bind_states(std::size_t block, const Places& places, Pieces& pieces) const {
  const BlockType& type = plan_.diagram.blocks[block].type();
  const plan::PlannedBlock& planned = plan_.blocks[block];
  for (std::size_t s = 0; s < type.states.size(); ++s) {
    const plan::SignalSlot& slot = planned.states[s];
    const std::string& member = type.states[s].member;
    if (slot.size == 0) continue;
    const std::string end = fmt::format(", {});\n", slot.size);
    pieces.push_back(place(fmt::format("    b.{}.bind(", member), slot.offset, end, places));
    if (type.states[s].continuous)
      pieces.push_back(
          {fmt::format("    b.{}.derivative.bind({} + (", member, in_lane(places.dot, slot.offset, places)),
           names_.at(slot.offset), " - states)" + end, static_cast<std::int64_t>(slot.offset)});
  }
}

void Statements::bind_rest(std::size_t block, const Places& places, Pieces& pieces) const {
  const BlockType& type = plan_.diagram.blocks[block].type();
  const plan::PlannedBlock& planned = plan_.blocks[block];
  for (std::size_t n = 0; n < type.diagnostics.size(); ++n)
    pieces.push_back(place(fmt::format("    b.{}.bind(", type.diagnostics[n].member),
                           planned.diagnostics[n].offset, ");\n", places));
  for (const ClockSpec& clock : type.clocks) {
    const std::string before = fmt::format("    b.{}.bind(", clock.member);
    pieces.push_back(clock.bind_time ? place(before, plan::Layout::time, ");\n", places)
                                     : Piece{before, period_text(plan_, block), ");\n"});
  }
}

std::string Statements::call_text(std::size_t block, Phase phase, const std::string& set_up,
                                  const Places& places) const {
  std::string call = phase == Phase::next_edge ? "    edge = std::min(edge, b.next_edge());\n"
                                               : fmt::format("    b.{}({});\n", function_of(phase),
                                                             phase == Phase::crossings ? "zero" : "");
  if (is_of_others(plan_.diagram.blocks[block].type().header))
    call = "    const FloatingPointState kept;\n" + call;
  if (lanes_.lanes == 1 || !lanes(places).blocks[block]) return set_up + call;
  return "    each_lane([&]([[maybe_unused]] const int l) {\n" + set_up + call + "    });\n";
}

std::string Statements::call(std::size_t block, Phase phase, const Places& places) const {
  std::string made;
  for (const Piece& piece : set_up(block, places, lanes_.lanes > 1))
    made += piece.before + piece.hole + piece.after;
  return fmt::format("  {{  // {}\n", comment_of(plan_, block)) + call_text(block, phase, made, places) +
         "  }\n";
}

}  // namespace stepwire::codegen
