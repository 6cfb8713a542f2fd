#include "engine/simulate/codegen/event_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/expression/margin.hpp"
#include "engine/model/plan/active.hpp"
#include "engine/model/plan/run_ends.hpp"
#include "engine/model/plan/tear_places.hpp"
#include "engine/simulate/codegen/guard_text.hpp"
#include "engine/simulate/codegen/solver_text.hpp"
#include "engine/simulate/codegen/workspace_text.hpp"
#include "engine/simulate/solve/error_control.hpp"
#include "engine/simulate/solve/event_locator.hpp"
#include "engine/simulate/solve/step_report.hpp"

namespace stepwire::codegen {

namespace {

/// Placeholders in order. Task: states, crossings, first signal, count of numbers, report, jumps of sources,
/// limits of events and iterations. Then: step of the solver, update of time signals, report of the solver
/// and its size, derivatives, calls before guards. At last: numbers that guards keep, stop condition, inner
/// points of the task, updates before an instant, guesses of loops, numbers of the error control, and whether
/// values before an instant are read.
constexpr char locate_form[] =
    "  const solve::EventTask task{{at::time, states, first_derivative, {0}, {1}, {2}, {3}, {4}, {5}, "
    "{6}, "
    "{7}, {16}, {18}, {20}, {21}, {22}, scratch}};\n"
    "  struct Between {{\n    double* w;\n    [[maybe_unused]] const double* numbers;\n    std::int64_t "
    "tick;\n"
    "    void advance([[maybe_unused]] double now, [[maybe_unused]] double end, "
    "[[maybe_unused]] double length) const {{\n{8}    }}\n"
    "{17}"
    "    void begin() const {{\n    forget_fault();\n{9}    settle();\n    "
    "}}\n"
    "    bool failed() const {{ return w[{10}] != 0.0; }}\n"
    "    void forget_fault() const {{ for (int i = 0; i < {11}; ++i) w[{10} + i] = 0.0; }}\n"
    "    void follow() const {{\n{9}    follow_crossings(w, numbers, tick);\n    }}\n"
    "    void crossings(double* z) const {{ look(w, numbers, tick, z); }}\n"
    "    double edge() const {{ return next_edge(w, numbers, tick); }}\n"
    "    void before(double) const {{\n{19}{9}    }}\n"
    "    void begin_event() const {{\n{13}{14}    }}\n"
    "    bool round() const {{\n    event_outputs(w, numbers, tick);\n    const bool stops = {15};\n"
    "    event_updates(w, numbers, tick);\n{14}    return stops;\n    }}\n"
    "    bool after() const {{\n    settle();\n    return {15};\n    }}\n"
    "    void settle() const {{\n{12}    follow_crossings(w, numbers, tick);\n    }}\n"
    "  }};\n"
    "  const Between between{{w, numbers, tick}};\n";

/// Placeholder: step of the solver.
constexpr char watched_form[] =
    "    void advance_watched([[maybe_unused]] double now, [[maybe_unused]] double end, "
    "[[maybe_unused]] double length, const solve::Stops& stops) const {{\n{}    }}\n";

constexpr char in_place[] = "slopes_in_place(w, numbers)";

expression::VariableText stop_variables(const plan::Plan& plan) {
  return [&plan](std::size_t i) {
    return fmt::format("w[{}]", plan.offset(plan.diagram.stop_when->variables[i]));
  };
}

/// Returns the count of signals and states.
std::size_t numbers_at_events(const plan::Plan& plan) {
  return plan.layout.diagnostics - plan.layout.signals;
}

/// Returns the count of numbers of the error control that change with each step.
std::size_t control_count(const plan::Plan& plan) {
  if (!plan.diagram.error_control) return 0;
  return solve::ControlReport::count(plan.layout.state_count) - solve::ControlReport::next;
}

/// Returns the count of the guesses and residuals of all loops.
std::size_t guess_count(const plan::Plan& plan) {
  std::size_t count = 0;
  for (const plan::TearPlace& tear : plan::tear_places(plan)) count += 2 * tear.size;
  return count;
}

std::size_t size_with_guesses(const plan::Plan& plan, std::size_t guesses) {
  return solve::EventTask::scratch_size(plan.layout.state_count, plan.crossing_count, numbers_at_events(plan),
                                        control_count(plan), guesses);
}
std::size_t scratch_size(const plan::Plan& plan) {
  return size_with_guesses(plan, guess_count(plan));
}

/// Returns the declaration of the torn signals of all loops; an empty text without loops.
std::string tears_text(const plan::Plan& plan) {
  std::string tears;
  for (const auto& [offset, size, residual] : plan::tear_places(plan))
    tears += fmt::format("{{{}, {}, {}}}, ", offset, size, residual);
  return tears.empty() ? "" : fmt::format("  static constexpr solve::Tear all_tears[] = {{{}}};\n", tears);
}

std::string guesses_text(const plan::Plan& plan) {
  const std::size_t tears = plan::tear_places(plan).size();
  return tears == 0 ? "solve::LoopGuesses{}" : fmt::format("solve::LoopGuesses{{all_tears, {}}}", tears);
}

/// Returns the condition that ends the run at an event.
std::string ends_text(const plan::Plan& plan) {
  std::string text = plan.stop_crossing
                         ? "(" + plan.diagram.stop_when->expression.cpp_condition(stop_variables(plan)) + ")"
                         : "false";
  for (const std::size_t place : plan::places_of_ends(plan, true))
    text += fmt::format(" || w[{}] == w[at::time]", place);
  return text;
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

std::string edge_text(const plan::Plan& plan, const Statements& statements, const Places& places) {
  std::string text = "  double edge = std::numeric_limits<double>::infinity();\n";
  for (const std::size_t block : plan.edges) text += statements.call(block, Phase::next_edge, places);
  return text + "  return edge;\n";
}

namespace {

/// Returns the task of a step and the operations between its ticks.
std::string between_text(const plan::Plan& plan, const PlaceNames& names) {
  const plan::Layout& layout = plan.layout;
  const diagram::Events& events = plan.diagram.events;
  const bool guards = !plan.event_befores.empty();
  const bool moves = layout.state_count > 0;
  return tears_text(plan) +
         fmt::format(locate_form, layout.state_count, plan.crossing_count, layout.signals,
                     numbers_at_events(plan), layout.events, plan.jumps, events.max_per_step, events.rounds,
                     moves ? solver_text(plan, {false, false, in_place}) : "", follow_time_text(plan),
                     layout.report, solve::StepReport::count, moves ? fmt::format("    {};\n", in_place) : "",
                     guards ? "    event_befores(w, numbers, tick);\n" : "",
                     guards ? keep_text(names, plan) : "", ends_text(plan), events.looks,
                     watches(plan)
                         ? fmt::format(watched_form, solver_text(plan, {false, false, in_place, {}, "stops"}))
                         : "",
                     events.looks_always(),
                     plan.left_updates.empty() ? "" : "    before_instant(w, numbers, tick, w[at::time]);\n",
                     guesses_text(plan), layout.report + solve::ControlReport::next, control_count(plan));
}

}  // namespace

std::string locate_text(const plan::Plan& plan, const PlaceNames& names) {
  return between_text(plan, names) +
         fmt::format("  solve::{}(task, w, between)\n      .advance({}, {}, step);\n",
                     watches(plan) ? "WatchedStep" : "EventLocator", time_text(plan, "tick"),
                     time_text(plan, "tick + 1"));
}

std::string settle_text(const plan::Plan& plan, const PlaceNames& names) {
  return fmt::format("  double scratch[{}];\n", scratch_size(plan)) + between_text(plan, names) +
         "  return solve::EventLocator(task, w, between).settle_tick(step);\n";
}

std::string update_text(const plan::Plan& plan) {
  if (!plan.splits_steps() || !plan.updates_continuous) return "  update(w, numbers, tick);\n";
  return fmt::format(
      "  double tick_states[{0}];\n  for (int i = 0; i < {0}; ++i) tick_states[i] = w[states + i];\n"
      "  update(w, numbers, tick);\n"
      "  if (solve::have_changed(w + states, tick_states, {0})) [[unlikely]]\n"
      "    if (!settle_tick(w, numbers, tick)) return;\n",
      plan.layout.state_count);
}

std::string end_of_left_text(const plan::Plan& plan) {
  if (plan.left_updates.empty()) return "";
  const std::size_t report = plan.layout.events;
  const std::string goes_on = plan.splits_steps() ? fmt::format("if (w[{}] == 0.0 && w[{}] == 0.0) ",
                                                                report + solve::EventReport::end,
                                                                report + solve::EventReport::stopped)
                                                  : "";
  return fmt::format("  {}before_instant(w, numbers, tick, {});\n", goes_on, time_text(plan, "tick + 1"));
}

bool watches(const plan::Plan& plan) {
  return plan.diagram.error_control && plan.layout.state_count > 0;
}

std::string before_step_text(const plan::Plan& plan) {
  const std::size_t states = plan.layout.state_count;
  if (watches(plan))
    return fmt::format("  double scratch[{}];\n  for (int i = 0; i < {}; ++i) scratch[i] = w[states + i];\n",
                       scratch_size(plan), states);
  std::string text =
      fmt::format("  double before[{0}], after[{0}], origin[{1}];\n",
                  std::max<std::size_t>(1, plan.crossing_count), std::max<std::size_t>(1, states));
  if (plan.updates_continuous) text += "  crossing_starts(w, numbers, tick);\n";
  text += "  look(w, numbers, tick, before);\n";
  if (!plan.edges.empty())
    text += fmt::format("  const bool has_edge = next_edge(w, numbers, tick) < solve::left_of({}, step);\n",
                        time_text(plan, "tick + 1"));
  if (!plan.loops.empty())
    text += fmt::format("{}  double guesses[{}];\n  {}.keep(w, guesses);\n", tears_text(plan),
                        guess_count(plan), guesses_text(plan));
  return text + fmt::format("  for (int i = 0; i < {}; ++i) origin[i] = w[states + i];\n", states);
}

// The arguments of locate() are copied, because numbers whose address escapes cannot be in registers.
std::string after_step_text(const plan::Plan& plan) {
  const std::size_t states = plan.layout.state_count, crossings = plan.crossing_count;
  const std::size_t past = plan.layout.events + solve::EventReport::count;
  const std::size_t ahead = plan.layout.events + solve::EventReport::ahead;
  if (watches(plan)) return fmt::format("  locate(w, numbers, tick, scratch);\n  w[{}] = 0.0;\n", ahead);
  const diagram::Events& events = plan.diagram.events;
  return fmt::format("  w[at::time] = {};\n", end_of_step_text(plan)) + follow_time_text(plan) +
         fmt::format(
             "  crossing_ends(w, numbers, tick);\n  look(w, numbers, tick, after);\n  w[{0}] = 1.0;\n"
             "  if (solve::is_eventful(before, after, {{w + {6}, {1}}}, {{step, {5}, true, {7}, {8}}})) "
             "[[unlikely]] {{\n    double scratch[{2}];\n"
             "    for (int i = 0; i < {3}; ++i) scratch[i] = origin[i];\n"
             "    for (int i = 0; i < {1}; ++i) scratch[{4} + i] = before[i];\n{9}"
             "    locate(w, numbers, tick, scratch);\n  }}\n",
             ahead, crossings, scratch_size(plan), states, solve::EventTask::before(states),
             plan.edges.empty() ? "false" : "has_edge", past, events.looks > 0, events.looks_always(),
             plan.loops.empty()
                 ? ""
                 : fmt::format("    for (int i = 0; i < {}; ++i) scratch[{} + i] = guesses[i];\n",
                               guess_count(plan), size_with_guesses(plan, 0)));
}

std::string end_of_step_text(const plan::Plan& plan) {
  const std::string next = time_text(plan, "tick + 1");
  return plan.jumps ? fmt::format("solve::left_of({}, step)", next) : next;
}

std::string times_of_step_text(const plan::Plan& plan) {
  return fmt::format("  [[maybe_unused]] const double length = step, now = {}, end = {};\n",
                     time_text(plan, "tick"), end_of_step_text(plan));
}

}  // namespace stepwire::codegen
