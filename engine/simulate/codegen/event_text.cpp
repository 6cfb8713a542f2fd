#include "engine/simulate/codegen/event_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/model/plan/active.hpp"
#include "engine/simulate/codegen/guard_text.hpp"
#include "engine/simulate/codegen/solver_text.hpp"
#include "engine/simulate/solve/event_locator.hpp"

namespace stepwire::codegen {

namespace {

/// Of the numbers of scratch memory, states, crossings, the place of the report, the most events; the
/// solver's step, what follows the time, what comes before events, the rounds at an event, the slopes.
constexpr char advance_form[] =
    "  double scratch[{0}];\n"
    "  const solve::EventTask task{{at::time, states, first_derivative, {1}, {2}, {3}, {4}, scratch}};\n"
    "  const auto go = [&]([[maybe_unused]] double now, [[maybe_unused]] double end, "
    "[[maybe_unused]] double step) {{\n{5}  }};\n"
    "  const auto follow = [&] {{\n{6}    crossing_outputs(w, numbers, tick);\n  }};\n"
    "  const auto look_here = [&](double* z) {{ look(w, numbers, tick, z); }};\n"
    "  const auto act = [&] {{\n{6}    for (int round = 0; round < {7}; ++round) {{\n"
    "      event_outputs(w, numbers, tick);\n      event_updates(w, numbers, tick);\n    }}\n"
    "{8}    crossing_outputs(w, numbers, tick);\n  }};\n"
    "  solve::EventLocator(task, w, go, follow, look_here, act)\n"
    "      .advance(static_cast<double>(tick) * step, static_cast<double>(tick + 1) * step, step);\n";

constexpr char slopes_form[] = "    slopes(w, w, numbers, w + first_derivative);\n";

/// What comes before the first step of the solver.
std::string start_text(const plan::Plan& plan, const PlaceNames& names) {
  const bool moves = plan.layout.state_count > 0;
  std::string text = moves ? keep_text(names, plan) : "";
  if (plan.updates_continuous)
    text += std::string(slopes_form) + "    crossing_outputs(w, numbers, tick);\n";
  else if (moves)
    text += "  derivatives(w, numbers, w + first_derivative);\n";
  return text;
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
  return text;
}

std::string located_advance_text(const plan::Plan& plan, const PlaceNames& names) {
  const plan::Layout& layout = plan.layout;
  const bool moves = layout.state_count > 0;
  const std::size_t scratch = solve::EventTask::scratch_size(layout.state_count, plan.crossing_count);
  return "  update(w, numbers, tick);\n" + start_text(plan, names) +
         fmt::format(advance_form, std::max<std::size_t>(1, scratch), layout.state_count, plan.crossing_count,
                     layout.events, plan.diagram.events.max_per_step,
                     moves ? solver_text(plan, false, false) : "",
                     plan.timed.empty() ? "" : "    follow_time(w, numbers);\n", solve::EventTask::rounds,
                     moves ? slopes_form : "");
}

}  // namespace stepwire::codegen
