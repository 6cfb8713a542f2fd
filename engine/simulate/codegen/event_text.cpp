#include "engine/simulate/codegen/event_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/expression/margin.hpp"
#include "engine/model/plan/active.hpp"
#include "engine/simulate/codegen/guard_text.hpp"
#include "engine/simulate/codegen/solver_text.hpp"
#include "engine/simulate/solve/event_locator.hpp"

namespace stepwire::codegen {

namespace {

/// Of the states, the crossings, the place of the report, the most events; the solver's step, what follows
/// the time, the rounds at an event, the slopes, what comes before guards, what they keep, whether the run
/// ends, the place and the size of the solver's report.
constexpr char locate_form[] =
    "  const solve::EventTask task{{at::time, states, first_derivative, {0}, {1}, {2}, {3}, scratch}};\n"
    "  const auto go = [&]([[maybe_unused]] double now, [[maybe_unused]] double end, "
    "[[maybe_unused]] double step) {{\n{4}  }};\n"
    "  const auto begin = [&] {{\n    for (int i = 0; i < {12}; ++i) w[{11} + i] = 0.0;\n{5}{7}    "
    "follow_crossings(w, numbers, tick);\n  }};\n"
    "  const auto follow = [&] {{\n{5}    follow_crossings(w, numbers, tick);\n  }};\n"
    "  const auto look_here = [&](double* z) {{ look(w, numbers, tick, z); }};\n"
    "  const auto act = [&] {{\n{5}{8}{9}    for (int round = 0; round < {6}; ++round) {{\n"
    "      event_outputs(w, numbers, tick);\n      event_updates(w, numbers, tick);\n{9}    }}\n"
    "{7}    follow_crossings(w, numbers, tick);\n    return {10};\n  }};\n"
    "  solve::EventLocator(task, w, go, begin, follow, look_here, act)\n"
    "      .advance(static_cast<double>(tick) * step, static_cast<double>(tick + 1) * step, step);\n";

constexpr char in_place[] = "slopes_in_place(w, numbers)";

expression::VariableText stop_variables(const plan::Plan& plan) {
  return [&plan](std::size_t i) {
    return fmt::format("w[{}]", plan.offset(plan.diagram.stop_when->variables[i]));
  };
}

std::string follow_time_text(const plan::Plan& plan) {
  return plan.timed.empty() ? "" : "  follow_time(w, numbers);\n";
}

}  // namespace

std::string look_text(const plan::Plan& plan, const Statements& statements, const Places& places) {
  std::string text = "  Crossings zero(z);\n";
  for (const plan::CrossingCall& call : plan.crossings) {
    const std::string own = statements.call(call.block, Phase::crossings, places);
    const std::string active = active_text(statements.names(), plan::active_of(plan, call.block));
    text += active.empty() ? own
                           : fmt::format(
                                 "  if ({} == 0.0) {{  // what is off crosses nothing\n"
                                 "    for (int i = 0; i < {}; ++i) zero.add(0.0);\n  }} else {{\n{}  }}\n",
                                 active, call.count, own);
  }
  if (plan.stop_crossing)
    text += fmt::format("  zero.add({});\n",
                        expression::margin_of(plan.diagram.stop_when->expression).cpp(stop_variables(plan)));
  return text;
}

std::string locate_text(const plan::Plan& plan, const PlaceNames& names) {
  const plan::Layout& layout = plan.layout;
  const bool guards = !plan.event_befores.empty();
  const bool moves = layout.state_count > 0;
  return fmt::format(
      locate_form, layout.state_count, plan.crossing_count, layout.events, plan.diagram.events.max_per_step,
      moves ? solver_text(plan, {false, false, in_place}) : "", follow_time_text(plan),
      solve::EventTask::rounds, moves ? fmt::format("    {};\n", in_place) : "",
      guards ? "    event_befores(w, numbers, tick);\n" : "", guards ? keep_text(names, plan) : "",
      plan.stop_crossing ? plan.diagram.stop_when->expression.cpp_condition(stop_variables(plan)) : "false",
      layout.report, plan::Layout::report_count);
}

std::string before_step_text(const plan::Plan& plan) {
  const std::size_t states = plan.layout.state_count;
  std::string text = fmt::format("  double before[{0}], after[{0}], origin[{1}];\n", plan.crossing_count,
                                 std::max<std::size_t>(1, states));
  if (plan.updates_continuous) text += "  crossing_starts(w, numbers, tick);\n";
  text += "  look(w, numbers, tick, before);\n";
  return text + fmt::format("  for (int i = 0; i < {}; ++i) origin[i] = w[states + i];\n", states);
}

// What locate() is given is copied there: numbers whose address is known elsewhere are in no register.
std::string after_step_text(const plan::Plan& plan) {
  const std::size_t states = plan.layout.state_count, crossings = plan.crossing_count;
  return "  w[at::time] = static_cast<double>(tick + 1) * step;\n" + follow_time_text(plan) +
         fmt::format(
             "  crossing_ends(w, numbers, tick);\n  look(w, numbers, tick, after);\n  w[{0}] = 1.0;\n"
             "  if (solve::sign_changes(before, after, {1})) [[unlikely]] {{\n    double scratch[{2}];\n"
             "    for (int i = 0; i < {3}; ++i) scratch[i] = origin[i];\n"
             "    for (int i = 0; i < {1}; ++i) scratch[{4} + i] = before[i];\n"
             "    for (int i = 0; i < {1}; ++i) scratch[{5} + i] = after[i];\n"
             "    locate(w, numbers, tick, scratch);\n  }}\n",
             plan.layout.events + solve::EventReport::ahead, crossings,
             solve::EventTask::scratch_size(states, crossings), states, solve::EventTask::before(states),
             solve::EventTask::after(states, crossings));
}

}  // namespace stepwire::codegen
