#include "tests/diagrams/imported_unit.hpp"

#include <fmt/format.h>

#include <cstring>
#include <map>

#include "engine/app/fmu/variables.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire {

namespace {

/// Numbers of an output as FMI has them: rows of a matrix behind each other.
std::vector<double> numbers_of(const run::Executor& run, const plan::SignalSlot& slot) {
  std::vector<double> numbers;
  for (Index k = 0; k < slot.size; ++k)
    numbers.push_back(run.values()[slot.offset + static_cast<std::size_t>(k % slot.columns * slot.rows() +
                                                                          k / slot.columns)]);
  return numbers;
}

using Outputs = std::vector<std::pair<std::string, plan::SignalSlot>>;

/// The signals that the outputs of a unit are, in their order.
Outputs outputs_of(const plan::Plan& plan, bool exchange) {
  std::map<std::string, plan::SignalSlot> slots;
  for (const diagram::RecordRequest& request : plan.diagram.records)
    for (const diagram::RecordedSignal& signal : request.signals)
      slots.emplace(signal.name, plan.slot(signal.signal));
  for (const diagram::DiagramOutput& output : plan.diagram.outputs)
    slots.insert_or_assign(output.name, plan.slot(output.signal));
  Outputs outputs;
  for (const fmu::Variable& variable : fmu::variables_of(plan, codegen::tuning_of(plan), exchange))
    if (variable.causality == "output") outputs.emplace_back(variable.name, slots.at(variable.name));
  return outputs;
}

std::string solver_text(const diagram::Diagram& own) {
  if (const auto& control = own.error_control)
    return fmt::format("solver: {{name: {}, relative: {:.17g}, absolute: {:.17g}, max_steps: {}}}\n",
                       own.solver, control->relative, control->absolute, control->max_steps);
  return own.solver.empty() ? "" : "solver: " + own.solver + "\n";
}

std::string difference_at(std::int64_t tick, const Outputs& outputs, const run::Executor& own,
                          const run::Executor& unit, const std::vector<plan::SignalSlot>& shown) {
  std::size_t port = 0, place = 0;
  for (const auto& [name, slot] : outputs)
    for (const double number : numbers_of(own, slot)) {
      const plan::SignalSlot& of = shown.at(port);
      const double other = unit.values()[of.offset + place];
      if (std::memcmp(&number, &other, sizeof number) != 0)
        return fmt::format("{} at tick {}: {} and not {}", name, tick, other, number);
      if (++place == static_cast<std::size_t>(of.size)) ++port, place = 0;
    }
  return port == shown.size() ? "" : fmt::format("{} outputs of {}", port, shown.size());
}

}  // namespace

std::string text_with_unit(const diagram::Diagram& own, const std::string& file, const std::string& keys,
                           std::int64_t ticks) {
  std::string text = fmt::format("stepwire: 1\ntitle: an exported unit\nstep: {:.17g} s\nstop: {:.17g} s\n",
                                 own.step, own.step * static_cast<double>(ticks)) +
                     solver_text(own);
  if (own.events.locate) text += "events: locate\n";
  return text + fmt::format("blocks:\n  unit: {{block: Fmu, file: {}, {}}}\n", file, keys);
}

std::string difference_of_unit(const plan::Plan& own_plan, const plan::Plan& outer, bool exchanges,
                               std::int64_t ticks) {
  run::Executor own(own_plan), unit(outer);
  const Outputs outputs = outputs_of(own_plan, exchanges);
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    own.evaluate();
    unit.evaluate();
    if (!own.healthy() || !unit.healthy())
      return own.healthy() == unit.healthy() ? "" : fmt::format("only one run has failed, at tick {}", tick);
    const std::string text = difference_at(tick, outputs, own, unit, outer.blocks[0].outputs);
    if (!text.empty()) return text;
    own.advance();
    unit.advance();
  }
  return "";
}

}  // namespace stepwire
