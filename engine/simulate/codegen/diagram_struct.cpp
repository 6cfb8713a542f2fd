#include "engine/simulate/codegen/diagram_struct.hpp"

#include <fmt/format.h>

#include <map>
#include <vector>

#include "engine/simulate/codegen/cpp_words.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/names.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire {

namespace {

/// One member of the struct: what it is called, and where it comes from.
struct Member {
  std::string name, meaning;
  SignalSlot slot;
};

std::string unit_text(const Plan& plan, const SignalRef& signal) {
  const auto dimension = plan.dimension(signal);
  return dimension ? fmt::format(" [{}]", si_name(*dimension)) : "";
}

std::vector<Member> inputs_of(const Plan& plan) {
  std::vector<Member> members;
  for (const DiagramInput& input : plan.diagram.inputs)
    members.push_back({cpp_identifier(input.name) + "_", input.doc + unit_text(plan, {input.block, 0, -1}),
                       plan.blocks[static_cast<std::size_t>(input.block)].outputs.front()});
  return members;
}

std::vector<Member> outputs_of(const Plan& plan) {
  std::vector<Member> members;
  for (const DiagramOutput& output : plan.diagram.outputs)
    members.push_back({cpp_identifier(output.name) + "_", output.doc + unit_text(plan, output.signal),
                       plan.slot(output.signal)});
  return members;
}

std::vector<Member> recorded_of(const Plan& plan) {
  std::vector<Member> members;
  std::map<std::string, std::size_t> taken;
  for (const RecordRequest& request : plan.diagram.records)
    for (const RecordedSignal& signal : request.signals) {
      const std::string name = recorded_member(signal);
      const SignalSlot slot = plan.slot(signal.signal);
      const auto [known, is_new] = taken.emplace(name, slot.offset);
      if (known->second != slot.offset)
        throw Error(
            plan.diagram.fault(signal.origin, "record",
                               fmt::format("'{}' would be called {} in C++ as another recorded signal is; "
                                           "give it another name",
                                           signal.name, name)));
      if (is_new) members.push_back({name, signal.name + unit_text(plan, signal.signal), slot});
    }
  return members;
}

std::string type_text(const Member& member, const std::string& value) {
  return member.slot.size == 1
             ? fmt::format("double {}{}", member.name, value)
             : fmt::format("double {}[{}]{}", member.name, member.slot.size, value.empty() ? "" : "{}");
}

std::string group_text(const std::string& type, const std::string& name, const std::string& doc,
                       const std::vector<Member>& members) {
  if (members.empty()) return "";
  std::string text = fmt::format("  /// {}\n  struct {} {{\n", doc, type);
  for (const Member& member : members)
    text += fmt::format("    {};  ///< {}\n", type_text(member, "{}"), cpp_comment(member.meaning));
  return text + fmt::format("  }} {};\n\n", name);
}

/// Copies between the struct's members and the numbers of the workspace.
std::string copies(const std::string& group, const std::vector<Member>& members, bool from_workspace) {
  std::string text;
  for (const Member& member : members)
    for (Index k = 0; k < member.slot.size; ++k) {
      const std::string element = member.slot.size == 1 ? "" : fmt::format("[{}]", k);
      const std::string own = fmt::format("{}.{}{}", group, member.name, element);
      const std::string place = fmt::format("w_[{}]", member.slot.offset + static_cast<std::size_t>(k));
      text +=
          from_workspace ? fmt::format("  {} = {};\n", own, place) : fmt::format("  {} = {};\n", place, own);
    }
  return text;
}

std::string fault_text(const Plan& plan) {
  std::string text;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const DiagramBlock& block = plan.diagram.blocks[b];
    for (std::size_t n = 0; n < block.type().notices.size(); ++n)
      if (block.type().notices[n].ends_run)
        text += fmt::format("  if (w_[{}] != Notice::never) return {};\n", plan.blocks[b].notices[n].offset,
                            cpp_string(comment_of(plan, b) + ": " + block.type().notices[n].doc));
  }
  if (plan.layout.state_count > 0 && find_implicit(plan.diagram.solver))
    text += fmt::format("  if (w_[{}] != 0.0) return \"the step is too large for the solver\";\n",
                        plan.layout.report);
  return text;
}

/// The condition under which the run ends early, on the numbers of the workspace.
std::string stop_text(const Plan& plan) {
  if (!plan.diagram.stop_when) return "false";
  return plan.diagram.stop_when->expression.cpp_condition([&](std::size_t i) {
    return fmt::format("w_[{}]", plan.offset(plan.diagram.stop_when->variables[i]));
  });
}

}  // namespace

std::string recorded_member(const RecordedSignal& signal) {
  return cpp_identifier(signal.name) + "_";
}

std::string struct_text(const Plan& plan, const std::string& name) {
  return fmt::format(
             "#pragma once\n\n#include <cstdint>\n\nnamespace {0} {{\n\n"
             "/// {1}\n///\n"
             "/// All numbers are SI. A tick is evaluate(), which reads the inputs and computes the outputs, "
             "and "
             "advance(),\n/// which goes on by {2} s; step() is both. Nothing allocates, throws, locks or "
             "calls the "
             "system.\nstruct Diagram {{\n",
             name, cpp_comment(plan.diagram.title), number_text(plan.diagram.step)) +
         group_text("Inputs", "inputs", "Written before evaluate().", inputs_of(plan)) +
         group_text("Outputs", "outputs", "As of the last evaluate().", outputs_of(plan)) +
         group_text("Recorded", "recorded", "What the diagram records, as of the last evaluate().",
                    recorded_of(plan)) +
         fmt::format(
             "  std::int64_t tick = 0;\n\n"
             "  Diagram() {{ reset(); }}\n"
             "  /// Puts everything at time 0.\n  void reset();\n"
             "  void evaluate();\n  void advance();\n"
             "  void step() {{\n    evaluate();\n    advance();\n  }}\n"
             "  /// Of this tick [s].\n  double time() const {{ return static_cast<double>(tick) * {0}; }}\n"
             "  /// Is every signal and state a finite number?\n  bool finite() const;\n"
             "  /// Why a block has ended the run; null while none has.\n  const char* fault() const;\n"
             "  /// Is the diagram's `stop_when` true?\n  bool stops() const;\n\n"
             " private:\n  double w_[{1}];  // where each number lies is told in the source\n}};\n\n"
             "}}  // namespace {2}\n",
             number_text(plan.diagram.step), plan.layout.size, name);
}

std::string struct_definitions(const Plan& plan, const std::string& name) {
  const Layout& layout = plan.layout;
  return fmt::format(
      "namespace {0} {{\n\n"
      "void Diagram::reset() {{\n  tick = 0;\n  ::reset(w_, nullptr);\n{1}}}\n\n"
      "[[gnu::flatten]] void Diagram::evaluate() {{\n{2}  ::evaluate(w_, nullptr, tick);\n{3}{4}}}\n\n"
      "[[gnu::flatten]] void Diagram::advance() {{\n  ::advance(w_, nullptr, tick);\n  ++tick;\n}}\n\n"
      "bool Diagram::finite() const {{\n"
      "  std::uint64_t bits = 0;  // a product with 0 is 0 for what is finite and nan for the rest\n"
      "  for (int i = {5}; i < {6}; ++i) bits |= std::bit_cast<std::uint64_t>(w_[i] * 0.0);\n"
      "  return (bits << 1) == 0;\n}}\n\n"
      "const char* Diagram::fault() const {{\n{7}  return nullptr;\n}}\n\n"
      "bool Diagram::stops() const {{\n  return {8};\n}}\n\n}}  // namespace {0}\n",
      name, copies("inputs", inputs_of(plan), true), copies("inputs", inputs_of(plan), false),
      copies("outputs", outputs_of(plan), true), copies("recorded", recorded_of(plan), true), layout.signals,
      layout.dots + layout.state_count, fault_text(plan), stop_text(plan));
}

}  // namespace stepwire
