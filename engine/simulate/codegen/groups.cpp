#include "engine/simulate/codegen/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "engine/model/diagram/report.hpp"
#include "engine/simulate/codegen/names.hpp"
#include "engine/simulate/codegen/value_text.hpp"

namespace stepwire::codegen {

namespace {

std::string unit_text(const std::optional<unit::Dimension>& dimension) {
  return dimension ? fmt::format(" [{}]", unit::si_name(*dimension)) : "";
}

GroupMember member_of(std::string name, std::string meaning, const plan::SignalSlot& slot) {
  GroupMember member{std::move(name), std::move(meaning), {}, {}, slot};
  if (slot.size != 1) member.sizes.push_back(slot.size);
  return member;
}

std::vector<GroupMember> inputs_of(const plan::Plan& plan) {
  std::vector<GroupMember> members;
  for (const diagram::DiagramInput& input : plan.diagram.inputs)
    members.push_back(member_of(
        cpp_identifier(input.name) + "_",
        (input.doc.empty() ? input.name : input.doc) + unit_text(plan.dimension({input.block, 0, -1})),
        plan.blocks[static_cast<std::size_t>(input.block)].outputs.front()));
  return members;
}

std::vector<GroupMember> outputs_of(const plan::Plan& plan) {
  std::vector<GroupMember> members;
  for (const diagram::DiagramOutput& output : plan.diagram.outputs)
    members.push_back(
        member_of(cpp_identifier(output.name) + "_",
                  (output.doc.empty() ? output.name : output.doc) + unit_text(plan.dimension(output.signal)),
                  plan.slot(output.signal)));
  return members;
}

std::vector<GroupMember> recorded_of(const plan::Plan& plan) {
  std::vector<GroupMember> members;
  std::map<std::string, std::size_t> taken;
  for (const diagram::RecordRequest& request : plan.diagram.records)
    for (const diagram::RecordedSignal& signal : request.signals) {
      const std::string name = recorded_member(signal);
      const plan::SignalSlot slot = plan.slot(signal.signal);
      const auto [known, is_new] = taken.emplace(name, slot.offset);
      if (known->second != slot.offset)
        throw yaml::Error(
            plan.diagram.fault(signal.origin, "record",
                               fmt::format("'{}' would be called {} in C++ as another recorded signal is; "
                                           "give it another name",
                                           signal.name, name)));
      if (is_new)
        members.push_back(member_of(name, signal.name + unit_text(plan.dimension(signal.signal)), slot));
    }
  return members;
}

std::vector<GroupMember> states_of(const plan::Plan& plan) {
  std::vector<GroupMember> members;
  std::set<std::string> taken;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const diagram::DiagramBlock& block = plan.diagram.blocks[b];
    for (std::size_t s = 0; s < plan.blocks[b].states.size(); ++s) {
      const StateSpec& spec = block.type().states[s];
      const diagram::SignalRef signal{static_cast<int>(b), -1, static_cast<int>(s)};
      const std::string name = block.name + "." + spec.name;
      if (plan.blocks[b].states[s].size > 0)
        members.push_back(
            member_of(free_member(name, taken),
                      fmt::format("{}, {}{}", name, spec.doc, unit_text(plan.dimension(signal))),
                      plan.blocks[b].states[s]));
    }
  }
  return members;
}

/// Returns "above 0 kg".
std::string bounds_text(const diagram::Definition& definition) {
  std::string text;
  for (const yaml::Entry& bound : definition.bounds) {
    std::string words = bound.key;
    std::replace(words.begin(), words.end(), '_', ' ');
    text += fmt::format("; {} {}", words, bound.value.text);
  }
  return text;
}

std::vector<GroupMember> parameters_of(const plan::Plan& plan, const Tuning& tuning) {
  std::vector<GroupMember> members;
  for (const int d : tuning.parameters) {
    const diagram::DiagramParameter& parameter = plan.diagram.parameters[static_cast<std::size_t>(d)];
    const diagram::Definition& definition = plan.diagram.bindings->definitions[static_cast<std::size_t>(d)];
    const bool follows = !definition.uses.empty() && definition.text.node.is_scalar();
    const std::string& text = definition.text.node.text;
    GroupMember member{tuning.members.at(d),
                       fmt::format("{}{}{}{}", parameter.doc.empty() ? parameter.name : parameter.doc,
                                   unit_text(parameter.dimension), bounds_text(definition),
                                   follows ? fmt::format("; '{}' until it is written", text) : ""),
                       {},
                       numbers_of(parameter.value)};
    if (const auto* vector = std::get_if<Eigen::VectorXd>(&parameter.value.content))
      member.sizes = {vector->size()};
    if (const auto* matrix = std::get_if<Eigen::MatrixXd>(&parameter.value.content)) {
      member.sizes = {matrix->rows(), matrix->cols()};
      const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> by_row = *matrix;
      member.initial.assign(by_row.data(), by_row.data() + by_row.size());
    }
    members.push_back(std::move(member));
  }
  return members;
}

}  // namespace

std::string GroupMember::declaration() const {
  std::string text = "double " + name;
  for (const Index size : sizes) text += fmt::format("[{}]", size);
  return text;
}

std::size_t GroupMember::count() const {
  return static_cast<std::size_t>(std::accumulate(sizes.begin(), sizes.end(), Index{1}, std::multiplies<>()));
}

std::string recorded_member(const diagram::RecordedSignal& signal) {
  return cpp_identifier(signal.name) + "_";
}

Groups::Groups(const plan::Plan& plan, const Tuning& tuning)
    : inputs{"Inputs", "inputs", "Written before evaluate().", inputs_of(plan)},
      outputs{"Outputs", "outputs", "As of the last evaluate().", outputs_of(plan)},
      recorded{"Recorded", "recorded", "What the diagram records, as of the last evaluate().",
               recorded_of(plan)},
      parameters{"Parameters", "parameters",
                 "Written at any time; they hold from the next evaluate() or reset() on.",
                 parameters_of(plan, tuning)},
      states{"States", "states", "What the blocks remember, by name.", states_of(plan)} {}

}  // namespace stepwire::codegen
