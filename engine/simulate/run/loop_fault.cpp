#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/simulate/run/faults.hpp"
#include "engine/simulate/solve/loop_task.hpp"

namespace stepwire::run {

namespace {

/// Returns "loop.y", or "loop.y.2" for one of several elements.
std::string name_of(const plan::Plan& plan, const diagram::SignalRef& signal, std::size_t element) {
  const diagram::DiagramBlock& block = plan.diagram.blocks[static_cast<std::size_t>(signal.block)];
  const std::string& port = block.type().outputs[static_cast<std::size_t>(signal.output)].name;
  const std::string name = block.name + "." + port;
  return plan.slot(signal).size == 1 ? name : fmt::format("{}.{}", name, element + 1);
}

/// Returns the name of one of the torn numbers of a loop.
std::string name_of(const plan::Plan& plan, const plan::SolvedLoop& loop, std::size_t number) {
  for (const diagram::SignalRef& tear : loop.tears) {
    const auto size = static_cast<std::size_t>(plan.slot(tear).size);
    if (number < size) return name_of(plan, tear, number);
    number -= size;
  }
  return name_of(plan, loop.tears.front(), 0);
}

/// Returns nullptr if all loops are solved.
const plan::SolvedLoop* first_unsolved(const plan::Plan& plan, const double* values) {
  const auto found = std::ranges::find_if(plan.loops, [&](const plan::SolvedLoop& loop) {
    return values[loop.report + solve::LoopReport::unsolved] != 0.0;
  });
  return found == plan.loops.end() ? nullptr : &*found;
}

}  // namespace

bool runs_away_in_loop(const plan::Plan& plan, const double* values) {
  const plan::SolvedLoop* loop = first_unsolved(plan, values);
  return loop && !std::isfinite(values[loop->report + solve::LoopReport::residual]);
}

std::optional<RunFault> fault_of_loops(const plan::Plan& plan, const double* values) {
  const plan::SolvedLoop* loop = first_unsolved(plan, values);
  if (!loop) return std::nullopt;
  const double* report = values + loop->report;
  const double time = report[solve::LoopReport::time];
  const auto tick = static_cast<std::int64_t>(std::floor(time / plan.diagram.step * (1.0 + 1e-12)));
  const std::string subject =
      name_of(plan, *loop, static_cast<std::size_t>(report[solve::LoopReport::number]));
  const diagram::DiagramBlock& block =
      plan.diagram.blocks[static_cast<std::size_t>(loop->tears.front().block)];
  return RunFault{
      block.name, "", time,
      plan.diagram.fault(
          block.origin, block.name,
          fmt::format("the algebraic loop {} is not solved at {:.12g} s (tick {}) within {} iterations: its "
                      "blocks give {} a value that differs by {:.3g} from the one that they are given; the "
                      "run ends here. A law that jumps (a relay) may have no solution: a Lag or a UnitDelay "
                      "in the loop, or a slope in place of the jump helps",
                      loop->path, time, tick, plan.diagram.algebraic_loops.max_iterations, subject,
                      report[solve::LoopReport::residual]))};
}

}  // namespace stepwire::run
