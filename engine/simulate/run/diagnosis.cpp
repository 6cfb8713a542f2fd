// What a run that ended early, or blocks during a run, have to say.
#include <fmt/format.h>

#include <cmath>

#include "engine/model/signal/diagnostic.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/finite.hpp"

namespace stepwire::run {

namespace {

/// 0 if all are finite.
double first_not_finite(const double* values, const plan::SignalSlot& slot) {
  for (const double* value = values + slot.offset; value != values + slot.offset + slot.size; ++value)
    if (!std::isfinite(*value)) return *value;
  return 0.0;
}

RunFault make_fault(const plan::Plan& plan, std::size_t block, const std::string& port, double time,
                    const std::string& message) {
  const diagram::DiagramBlock& from = plan.diagram.blocks[block];
  const std::string subject = port.empty() ? from.name : from.name + "." + port;
  return {from.name, port, time, plan.diagram.fault(from.origin, subject, message)};
}

}  // namespace

StepCount Executor::step_count() const {
  if (!plan_.diagram.error_control) return {};
  const double* report = values() + plan_.layout.report;
  return {static_cast<std::int64_t>(report[solve::ControlReport::steps]),
          static_cast<std::int64_t>(report[solve::ControlReport::rejected]),
          report[solve::ControlReport::largest], report[solve::ControlReport::stiff] != 0.0};
}

namespace {

/// Of a step to the tick at `end`, in which the run stands at `now`.
std::string text_of_step(const diagram::Diagram& diagram, const double* report, double now, double end) {
  if (report[0] == solve::StepReport::unsolved)
    return fmt::format(
        "the solver finds no solution for the step to {:.12g} s, where Newton's method still changes this "
        "state by "
        "{:.2g} of its size; the run ends here. A smaller step, or a law without jumps, helps",
        end, report[1]);
  if (report[0] == solve::StepReport::too_many_steps)
    return fmt::format(
        "the solver does not come from {:.12g} s to the tick at {:.12g} s within 'max_steps', or within "
        "steps that the "
        "time can tell apart: the error of this state is {:.2g} of what is allowed; the run ends here. A "
        "stiff solver "
        "(radau, auto), a larger 'relative' or 'absolute', or a law without jumps helps",
        now, end, report[1]);
  return fmt::format(
      "the step to {:.12g} s errs by {:.2g} of the size of this state, and 'tolerance' is {:g}; the run ends "
      "here. A "
      "smaller step{} helps",
      end, report[1], diagram.tolerance,
      diagram.solver == "sdirk" ? " or solver: auto" : ", solver: sdirk or solver: auto");
}

}  // namespace

std::optional<RunFault> Executor::wrong_step() const {
  const double* report = values() + plan_.layout.report;
  if (report[0] == solve::StepReport::fine) return std::nullopt;
  const std::string message = text_of_step(plan_.diagram, report, values()[plan::Layout::time], time());
  const std::size_t place = plan_.layout.states + static_cast<std::size_t>(report[2]);
  for (std::size_t b = 0; b < plan_.blocks.size(); ++b) {
    const auto& slots = plan_.blocks[b].states;
    for (std::size_t s = 0; s < slots.size(); ++s)
      if (place - slots[s].offset < static_cast<std::size_t>(slots[s].size))
        return make_fault(plan_, b, plan_.diagram.blocks[b].type().states[s].name, time(), message);
  }
  return std::nullopt;
}

std::optional<RunFault> Executor::not_finite() const {
  const auto cure = [&](double value) {
    return fmt::format(
        "became {} at {:.12g} s; the run ends here. A smaller step, a stiff solver (rosenbrock, sdirk) or a "
        "check "
        "of the parameters helps",
        std::isnan(value) ? std::abs(value) : value, time());  // the sign of NaN says nothing
  };
  // States first: an integration that ran away is the cause of what follows from it. Then outputs in the
  // order of their computation, where the first is the cause of the others.
  for (const bool states : {true, false})
    for (int index : plan_.memory_order) {
      const auto b = static_cast<std::size_t>(index);
      const plan::PlannedBlock& block = plan_.blocks[b];
      const BlockType& type = plan_.diagram.blocks[b].type();
      const auto& slots = states ? block.states : block.outputs;
      for (std::size_t i = 0; i < slots.size(); ++i) {
        if ((states && !type.states[i].continuous) || first_not_finite(values(), slots[i]) == 0.0) continue;
        return make_fault(plan_, b, states ? type.states[i].name : type.outputs[i].name, time(),
                          cure(first_not_finite(values(), slots[i])));
      }
    }
  return std::nullopt;
}

std::string Executor::diagnostic_text(std::size_t block, std::size_t diagnostic) const {
  const DiagnosticSpec& spec = plan_.diagram.blocks[block].type().diagnostics[diagnostic];
  return spec.detail ? spec.doc + ": " + spec.detail(memory(block)) : spec.doc;
}

std::optional<RunFault> Executor::fault() const {
  if (healthy_) return std::nullopt;
  for (std::size_t b = 0; b < plan_.blocks.size(); ++b) {
    const auto& specs = plan_.diagram.blocks[b].type().diagnostics;
    for (std::size_t n = 0; n < specs.size(); ++n) {
      const double first = workspace_.values[plan_.blocks[b].diagnostics[n].offset];
      if (specs[n].ends_run && first != Diagnostic::never)
        return make_fault(plan_, b, "", first,
                          fmt::format("{} (at {:.12g} s); the run ends here", diagnostic_text(b, n), first));
    }
  }
  if (!loops_solved())
    if (auto unsolved = unsolved_loop()) return unsolved;
  if (auto fault = event_fault()) return fault;
  if (auto wrong = wrong_step()) return wrong;
  return not_finite();
}

std::vector<RaisedDiagnostic> Executor::diagnostics() const {
  std::vector<RaisedDiagnostic> raised;
  for (std::size_t b = 0; b < plan_.blocks.size(); ++b) {
    const diagram::DiagramBlock& block = plan_.diagram.blocks[b];
    for (std::size_t n = 0; n < block.type().diagnostics.size(); ++n) {
      const double first = workspace_.values[plan_.blocks[b].diagnostics[n].offset];
      if (!block.type().diagnostics[n].ends_run && first != Diagnostic::never)
        raised.push_back({block.name, diagnostic_text(b, n), first});
    }
  }
  return raised;
}

bool Executor::is_finite() const {
  for (const Piece& piece : checked_)
    if (!piece.active || *piece.active != 0.0)
      if (!all_finite(values() + piece.first, piece.end - piece.first)) return false;
  return true;
}

bool Executor::diagnostic_ends_run() const {
  for (std::size_t offset : ending_diagnostics_)
    if (workspace_.values[offset] != Diagnostic::never) return true;
  return false;
}

}  // namespace stepwire::run
