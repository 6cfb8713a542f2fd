#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/simulate/run/faults.hpp"
#include "engine/simulate/solve/error_control.hpp"
#include "engine/simulate/solve/step_report.hpp"

namespace stepwire::run {

namespace {

/// Rounds down to two digits.
double rounded_down(double value) {
  if (!(value > 0.0)) return 0.0;
  const double digit = fn::pow(10.0, std::floor(fn::log10(value)) - 1.0);
  return digit * std::floor(value / digit * (1.0 + 1e-6));
}

std::string text_of_unstable(const diagram::Diagram& diagram, const double* report) {
  const double longest = rounded_down(report[solve::StepReport::longest_step]);
  const double growth = report[1];
  return fmt::format(
      "{} with steps of {:g} s {} at each step, while the equations do not let it grow: what was recorded is "
      "wrong. {}, solver: auto, or a stiff one (rosenbrock, sdirk) helps",
      diagram.solver, diagram.step,
      growth < 1.1 ? fmt::format("lets this state grow by {:.2g} %", 100.0 * (growth - 1.0))
                   : fmt::format("makes this state {:.3g} times as large", growth),
      longest > 0.0 ? fmt::format("A step of at most {:g} s", longest) : "A solver of higher order");
}

/// Cure where the solution slides along a jump of its derivatives, which no solver can follow.
constexpr char cure_of_switches[] =
    ". Where a switch without hysteresis changes back at once (a sign, a relay, Coulomb friction), a "
    "hysteresis, a Friction block or fixed steps (solver: rk4) helps";

/// True for a solver that takes stiff plants.
bool is_stiff(const std::string& solver) {
  static constexpr std::array names{"auto", "radau", "rodas", "rosenbrock", "sdirk"};
  return std::ranges::find(names, solver) != names.end();
}

/// Returns the message on a step to the tick at `end` that has reached the time `now`.
std::string text_of_step(const diagram::Diagram& diagram, const double* report, double now, double end) {
  if (report[0] == solve::StepReport::unsolved)
    return fmt::format(
        "the solver finds no solution for the step to {:.12g} s, where Newton's method still changes this "
        "state by {:.2g} of its size; the run ends here. A smaller step, or a law without jumps, helps{}",
        end, report[1], cure_of_switches);
  if (report[0] == solve::StepReport::too_many_steps)
    return fmt::format(
        "the solver does not come from {:.12g} s to the tick at {:.12g} s within 'max_steps', or within "
        "steps that the time can tell apart: the error of this state is {:.2g} of what is allowed; the run "
        "ends here. {}, or a law without jumps helps{}",
        now, end, report[1],
        is_stiff(diagram.solver) ? "A larger 'relative' or 'absolute'"
                                 : "A stiff solver (radau, auto), a larger 'relative' or 'absolute'",
        cure_of_switches);
  if (report[0] == solve::StepReport::unstable) return text_of_unstable(diagram, report);
  return fmt::format(
      "the step to {:.12g} s errs by {:.2g} of the size of this state, and 'tolerance' is {:g}; the run ends "
      "here. A smaller step{} helps{}",
      end, report[1], diagram.tolerance,
      diagram.solver == "sdirk" ? " or solver: auto" : ", solver: sdirk or solver: auto", cure_of_switches);
}

}  // namespace

std::optional<RunFault> fault_of_step(const plan::Plan& plan, const double* values, double tick_time) {
  const double* report = values + plan.layout.report;
  if (report[0] == solve::StepReport::fine) return std::nullopt;
  const std::string message = text_of_step(plan.diagram, report, values[plan::Layout::time], tick_time);
  const std::size_t place = plan.layout.states + static_cast<std::size_t>(report[2]);
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const auto& slots = plan.blocks[b].states;
    for (std::size_t s = 0; s < slots.size(); ++s)
      if (place - slots[s].offset < static_cast<std::size_t>(slots[s].size))
        return fault_of(plan, b, plan.diagram.blocks[b].type().states[s].name, tick_time, message);
  }
  return std::nullopt;
}

std::vector<RaisedDiagnostic> notes_on_small_states(const plan::Plan& plan, const double* values) {
  std::vector<RaisedDiagnostic> notes;
  if (!plan.diagram.error_control) return notes;
  const double absolute = plan.diagram.error_control->absolute;
  const double* const sizes = values + plan.layout.report + solve::ControlReport::sizes;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const diagram::DiagramBlock& block = plan.diagram.blocks[b];
    for (std::size_t s = 0; s < plan.blocks[b].states.size(); ++s) {
      const StateSpec& state = block.type().states[s];
      const plan::SignalSlot& slot = plan.blocks[b].states[s];
      if (!state.continuous || slot.size == 0) continue;
      const double* const first = sizes + (slot.offset - plan.layout.states);
      const double most = *std::max_element(first, first + slot.size);
      if (!(most > 0.0) || most >= 100.0 * absolute) continue;
      notes.push_back(
          {block.name,
           fmt::format("state {} is never above {:.2g} in its SI unit, and the solver may err by {:g}; "
                       "set 'absolute' in 'solver' to a small part of the state",
                       state.name, most, absolute)});
    }
  }
  return notes;
}

}  // namespace stepwire::run
