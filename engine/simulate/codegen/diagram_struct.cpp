#include "engine/simulate/codegen/diagram_struct.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/hash/hash.hpp"
#include "engine/model/plan/run_ends.hpp"
#include "engine/simulate/codegen/between_ticks.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/names.hpp"
#include "engine/simulate/codegen/tuning_text.hpp"
#include "engine/simulate/codegen/workspace_text.hpp"
#include "engine/simulate/solve/event_locator.hpp"
#include "engine/simulate/solve/loop_task.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::codegen {

namespace {

/// Placeholders: name, title, step.
constexpr char struct_head[] =
    "#pragma once\n\n#include <cstdint>\n\nnamespace {0} {{\n\n"
    "/// {1}\n///\n"
    "/// All numbers are SI. A tick is evaluate(), which reads the inputs and computes the outputs, "
    "and "
    "advance(),\n/// which goes on by {2} s; step() is both. Nothing allocates, throws, locks or "
    "calls the "
    "system.\nstruct Diagram {{\n";

const char* const parameter_members =
    "  /// Why these parameters would be refused; null where they would not.\n"
    "  const char* check(const Parameters& wanted) const;\n"
    "  /// Why those that were written were refused at the last evaluate() or reset(); null "
    "where "
    "they hold. Until\n  /// they are right the former ones hold.\n"
    "  const char* parameter_fault() const { return parameter_fault_; }\n\n";

/// Returns the member function for the time of a stop between two ticks, in plans that may have one.
std::string stopped_time(const plan::Plan& plan) {
  if (!plan::may_end_between(plan)) return "";
  return fmt::format("w_[{}] != 0.0 ? w_[{}] : ", plan.layout.events + solve::EventReport::stopped,
                     plan::Layout::time);
}

const char* const unsolved_member =
    "  /// Which algebraic loop has had no solution; null while all have.\n"
    "  const char* unsolved() const;\n";

/// Placeholders: constructor, time of the tick, count of numbers, members of a program with parameters, name,
/// member of one with algebraic loops, time of a stop between ticks.
constexpr char struct_members[] =
    "  /// All that moves in a run: plain numbers, to be kept anywhere.\n  struct State {{\n"
    "    std::uint64_t layout = 0;  ///< of the diagram that it belongs to\n"
    "    std::int64_t tick = 0;\n    double numbers[{2}]{{}};\n  }};\n"
    "  void save(State& state) const;\n"
    "  /// Returns to a state that was saved between advance() and evaluate(). Inputs and "
    "parameters "
    "stay as they\n  /// are. False, and nothing happens, for a state of another diagram.\n"
    "  [[nodiscard]] bool restore(const State& state);\n\n"
    "  std::int64_t tick = 0;\n\n"
    "  Diagram(){0}\n"
    "  /// Puts everything at time 0.\n  void reset();\n"
    "  void evaluate();\n  void advance();\n"
    "  void step() {{\n    evaluate();\n    advance();\n  }}\n"
    "  /// Of this tick [s].\n  double time() const {{ return {6}{1}; }}\n"
    "  /// Is every signal and state a finite number?\n  bool finite() const;\n"
    "  /// Judges the last tick of a run, after its evaluate(). No advance() follows.\n"
    "  void look_at_end();\n"
    "  /// Why a block has ended the run; null while none has.\n  const char* fault() const;\n"
    "{5}"
    "  /// Is the diagram's `stop_when` true?\n  bool stops() const;\n\n"
    " private:\n{3}  double w_[{2}];  // where each number lies is told in the source\n}};\n\n"
    "}}  // namespace {4}\n";

/// Placeholders: counts of dependent parameters and of numbers.
constexpr char tuned_members[] =
    "  void take_parameters();\n\n  Parameters held_{{}};  // the ones that hold\n"
    "  bool own_[{}]{{}};      // does a parameter follow from others no more?\n"
    "  const char* parameter_fault_ = nullptr;\n"
    "  double numbers_[{}];  // that blocks read, as they follow from the parameters\n";

const char* const tuned_functions =
    "Diagram::Diagram() {\n  std::memcpy(numbers_, first_numbers, sizeof numbers_);\n  reset();\n}\n\n"
    "[[gnu::noinline]] void Diagram::take_parameters() {\n  Parameters p = parameters;\n"
    "  parameter_fault_ = follow_parameters(p, held_, own_, numbers_);\n  if (parameter_fault_) return;\n"
    "  parameters = held_ = p;\n  follow_values(w_, numbers_);\n}\n\n"
    "const char* Diagram::check(const Parameters& wanted) const {\n  Parameters p = wanted;\n"
    "  bool own[sizeof own_];\n  std::memcpy(own, own_, sizeof own_);\n"
    "  return follow_parameters(p, held_, own, nullptr);\n}\n\n";

/// Returns "{}", "{2.0}" or "{{1.0, 2.0}, {3.0, 4.0}}".
std::string initial_text(const GroupMember& member) {
  std::string text;
  const std::size_t columns = member.sizes.size() == 2 ? static_cast<std::size_t>(member.sizes[1]) : 0;
  for (std::size_t k = 0; k < member.initial.size(); ++k) {
    if (columns > 0 && k % columns == 0) text += k == 0 ? "{" : "}, {";
    text += (k == 0 || (columns > 0 && k % columns == 0) ? "" : ", ") + number_text(member.initial[k]);
  }
  return "{" + text + (columns > 0 ? "}}" : "}");
}

std::string type_text(const Group& group) {
  std::string text = fmt::format("  /// {}\n  struct {} {{\n", group.doc, group.type);
  for (const GroupMember& member : group.members)
    text += fmt::format("    {}{};  ///< {}\n", member.declaration(), initial_text(member),
                        cpp_comment(member.meaning));
  return text + "  }";
}

/// Returns the struct of a group and its member; an empty text for an empty group.
std::string group_text(const Group& group) {
  return group.members.empty() ? "" : type_text(group) + fmt::format(" {};\n\n", group.name);
}

std::string states_text(const Group& states) {
  if (states.members.empty()) return "";
  return type_text(states) +
         ";\n  /// Those of this tick, to be read or written between advance() and evaluate().\n"
         "  States states() const;\n  void set_states(const States& states);\n\n";
}

std::string fixed_text(const Tuning& tuning) {
  if (tuning.fixed.empty()) return "";
  std::string text = "  // Parameters of the file that keep their value:\n";
  for (const FixedParameter& fixed : tuning.fixed)
    text += "  //   " + cpp_comment(fixed.name + ": " + fixed.reason) + "\n";
  return text + "\n";
}

/// Returns statements that copy between the struct's members and the numbers of the workspace.
std::string copies(const std::string& from, const Group& group, bool from_workspace) {
  std::string text;
  for (const GroupMember& member : group.members)
    for (Index k = 0; k < member.slot.size; ++k) {
      const std::string element = member.slot.size == 1 ? "" : fmt::format("[{}]", k);
      const std::string own = fmt::format("{}.{}{}", from, member.name, element);
      const std::string place = fmt::format("w_[{}]", member.slot.offset + static_cast<std::size_t>(k));
      text +=
          from_workspace ? fmt::format("  {} = {};\n", own, place) : fmt::format("  {} = {};\n", place, own);
    }
  return text;
}

std::string copies(const Group& group, bool from_workspace) {
  return copies(group.name, group, from_workspace);
}

std::string unsolved_text(const plan::Plan& plan) {
  if (plan.loops.empty()) return "";
  std::string text = "const char* Diagram::unsolved() const {\n";
  for (const plan::SolvedLoop& loop : plan.loops)
    text += fmt::format("  if (w_[{}] != 0.0) return {};\n", loop.report + solve::LoopReport::unsolved,
                        cpp_string("the algebraic loop " + loop.path + " is not solved"));
  return text + "  return nullptr;\n}\n\n";
}

std::string fault_text(const plan::Plan& plan) {
  std::string text = plan.loops.empty() ? "" : "  if (const char* reason = unsolved()) return reason;\n";
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const diagram::DiagramBlock& block = plan.diagram.blocks[b];
    for (std::size_t n = 0; n < block.type().diagnostics.size(); ++n)
      if (block.type().diagnostics[n].ends_run)
        text += fmt::format("  if (w_[{}] != Diagnostic::never) return {};\n",
                            plan.blocks[b].diagnostics[n].offset,
                            cpp_string(comment_of(plan, b) + ": " + block.type().diagnostics[n].doc));
  }
  if (plan.splits_steps())
    text += fmt::format("  if (w_[{}] != 0.0) return \"events of a step come to no end\";\n",
                        plan.layout.events + solve::EventReport::end);
  if (plan.layout.state_count > 0 &&
      solve::find_called(plan.diagram.solver, plan.diagram.error_control.has_value()))
    text += fmt::format("  if (w_[{}] != 0.0) return \"the step is too large for the solver\";\n",
                        plan.layout.report);
  return text;
}

/// Returns the condition under which the run ends early, as C++ on the numbers of the workspace.
std::string stop_text(const plan::Plan& plan) {
  if (!plan.diagram.stop_when) return "false";
  return plan.diagram.stop_when->expression.cpp_condition([&](std::size_t i) {
    return fmt::format("w_[{}]", plan.offset(plan.diagram.stop_when->variables[i]));
  });
}

/// Returns a key that differs between diagrams with different layouts of the workspace, for checks of saved
/// states.
std::string layout_key(const plan::Plan& plan) {
  hash::Hash hash;
  const PlaceNames names(plan);
  for (const NamedPlace& place : names.places())
    hash.add(fmt::format("{} {} {}", place.offset, place.size, place.name));
  return "0x" + hash.add(std::to_string(plan.layout.size)).text().substr(0, 16) + "u";
}

/// Texts of programs with parameters; empty in others.
struct Tuned {
  std::string check;  ///< condition that they were written
  std::string members, functions, numbers = "nullptr", restore;
};

Tuned tuned(const plan::Plan& plan, const Tuning& tuning) {
  if (tuning.parameters.empty()) return {};
  const std::size_t dependents = dependent_count(plan, tuning);
  std::string numbers;
  for (std::size_t i = 0; i < tuning.numbers.size(); ++i)
    numbers += (i == 0 ? "" : i % 8 == 0 ? ",\n      " : ", ") + number_text(tuning.numbers[i]);
  Tuned text;
  text.check =
      "  if (std::memcmp(&parameters, &held_, sizeof held_) != 0)\n    take_parameters();\n"
      "  else\n    parameter_fault_ = nullptr;\n";
  text.members = fmt::format(tuned_members, std::max<std::size_t>(dependents, 1),
                             std::max<std::size_t>(tuning.numbers.size(), 1));
  text.functions = "namespace {\n\n" + tuning_text(plan, tuning) +
                   fmt::format("constexpr double first_numbers[] = {{{}}};\n\n}}  // namespace\n\n",
                               numbers.empty() ? "0.0" : numbers) +
                   tuned_functions;
  text.numbers = "numbers_";
  text.restore = "  follow_values(w_, numbers_);\n";
  return text;
}

std::string states_definitions(const plan::Plan& plan, const Group& states) {
  if (states.members.empty()) return "";
  return fmt::format(
      "Diagram::States Diagram::states() const {{\n  States states;\n{}  return states;\n}}\n\n"
      "void Diagram::set_states(const States& states) {{\n{}}}\n\n",
      copies(states, true),
      copies(states, false) +
          (plan.rest.empty()
               ? ""
               : fmt::format("  w_[{}] = 0.0;\n", plan.layout.events + solve::EventReport::ahead)));
}

std::string save_definitions(const plan::Plan& plan, const Tuned& tuned) {
  return fmt::format(
      "void Diagram::save(State& state) const {{\n  state.layout = {0};\n  state.tick = tick;\n"
      "  std::memcpy(state.numbers, w_, sizeof w_);\n}}\n\n"
      "bool Diagram::restore(const State& state) {{\n  if (state.layout != {0}) return false;\n"
      "  tick = state.tick;\n  std::memcpy(w_, state.numbers, sizeof w_);\n{1}  return true;\n}}\n\n",
      layout_key(plan), tuned.restore);
}

}  // namespace

std::string struct_text(const plan::Plan& plan, const Tuning& tuning, const Groups& groups,
                        const std::string& name, bool between_ticks) {
  const bool tunes = !tuning.parameters.empty();
  return fmt::format(struct_head, name, cpp_comment(plan.diagram.title), number_text(plan.diagram.step)) +
         group_text(groups.inputs) + group_text(groups.outputs) + group_text(groups.recorded) +
         group_text(groups.parameters) + fixed_text(tuning) + (tunes ? parameter_members : "") +
         states_text(groups.states) + (between_ticks ? between_ticks_members(plan) : "") +
         fmt::format(struct_members, tunes ? ";" : " { reset(); }", time_text(plan, "tick"), plan.layout.size,
                     tuned(plan, tuning).members, name, plan.loops.empty() ? "" : unsolved_member,
                     stopped_time(plan));
}

/// Returns the functions of the struct that only look at its numbers.
std::string look_definitions(const plan::Plan& plan, const std::string& name) {
  return fmt::format(
      "bool Diagram::finite() const {{\n"
      "  std::uint64_t bits = 0;  // a product with 0 is 0 for what is finite and nan for the rest\n"
      "  for (int i = {0}; i < {1}; ++i) bits |= std::bit_cast<std::uint64_t>(w_[i] * 0.0);\n"
      "  return (bits << 1) == 0;\n}}\n\n"
      "const char* Diagram::fault() const {{\n{2}  return nullptr;\n}}\n\n"
      "bool Diagram::stops() const {{\n  return {3};\n}}\n\n}}  // namespace {4}\n",
      plan.layout.signals, plan.layout.derivatives + plan.layout.state_count, fault_text(plan),
      stop_text(plan), name);
}

std::string struct_definitions(const plan::Plan& plan, const Tuning& tuning, const Groups& groups,
                               const std::string& name, bool between_ticks) {
  const Tuned tuned = codegen::tuned(plan, tuning);
  return fmt::format("namespace {} {{\n\n", name) + tuned.functions +
         fmt::format(
             "void Diagram::reset() {{\n{0}  tick = 0;\n  ::reset(w_, {1});\n{2}}}\n\n"
             "[[gnu::flatten]] void Diagram::evaluate() {{\n{0}{3}  ::evaluate(w_, {1}, tick);\n{4}{5}}}\n\n"
             "[[gnu::flatten]] void Diagram::advance() {{\n  ::advance(w_, {1}, tick);\n  ++tick;\n}}\n\n"
             "void Diagram::look_at_end() {{\n{6}}}\n\n",
             tuned.check, tuned.numbers, copies(groups.inputs, true), copies(groups.inputs, false),
             copies(groups.outputs, true), copies(groups.recorded, true),
             plan.end_updates.empty() ? ""
                                      : fmt::format("  ::updates_at_end(w_, {}, tick);\n", tuned.numbers)) +
         save_definitions(plan, tuned) + states_definitions(plan, groups.states) + unsolved_text(plan) +
         (between_ticks
              ? between_ticks_definitions(plan, tuned.numbers, tuned.check + copies(groups.inputs, false),
                                          copies(groups.outputs, true) + copies(groups.recorded, true))
              : "") +
         look_definitions(plan, name);
}

}  // namespace stepwire::codegen
