// Calls of a table that have to agree with each other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/simulate/run/executor.hpp"

namespace stepwire::run {

namespace {

std::size_t unknowns_of(const plan::LoopCall& call) {
  std::size_t unknowns = 0;
  for (const plan::SignalSlot& tear : call.tears) unknowns += static_cast<std::size_t>(tear.size);
  return unknowns;
}

/// "loop.y", or "loop.y.2" of several
std::string name_of(const plan::Plan& plan, const diagram::SignalRef& signal, std::size_t element) {
  const diagram::DiagramBlock& block = plan.diagram.blocks[static_cast<std::size_t>(signal.block)];
  const std::string& port = block.type().outputs[static_cast<std::size_t>(signal.output)].name;
  const std::string name = block.name + "." + port;
  return plan.slot(signal).size == 1 ? name : fmt::format("{}.{}", name, element + 1);
}

/// Which of the torn numbers of a loop it is.
std::string name_of(const plan::Plan& plan, const plan::SolvedLoop& loop, std::size_t number) {
  for (const diagram::SignalRef& tear : loop.tears) {
    const auto size = static_cast<std::size_t>(plan.slot(tear).size);
    if (number < size) return name_of(plan, tear, number);
    number -= size;
  }
  return name_of(plan, loop.tears.front(), 0);
}

}  // namespace

Executor::Table::Loop::Loop(const plan::Plan& plan, const plan::LoopCall& call)
    : first(call.first),
      end(call.end),
      unknowns(unknowns_of(call)),
      solver(static_cast<Eigen::Index>(unknowns)) {
  for (const plan::SignalSlot& tear : call.tears)
    tears.push_back({tear.offset, static_cast<std::size_t>(tear.size)});
  const plan::SolvedLoop& loop = plan.loops[call.loop];
  const diagram::AlgebraicLoops& options = plan.diagram.algebraic_loops;
  task = {tears.data(), tears.size(),       loop.diagnostics.data(), loop.diagnostics.size(),
          loop.report,  plan::Layout::time, options.tolerance,       options.max_iterations};
}

void Executor::run_range(Table& table, std::size_t first, std::size_t end) {
  for (Table::Loop& loop : table.loops) {
    if (loop.first < first || loop.first >= end) continue;
    run_calls(table, first, loop.first);
    solve_loop(table, loop);
    first = loop.end;
  }
  run_calls(table, first, end);
}

void Executor::solve_loop(const Table& table, Table::Loop& loop) {
  loop.solver.solve(loop.task, workspace_.values.data(), [&] { run_calls(table, loop.first, loop.end); });
}

bool Executor::loops_solved() const {
  if (goes_on_unsolved_) return true;
  return std::ranges::all_of(plan_.loops, [&](const plan::SolvedLoop& loop) {
    return workspace_.values[loop.report + solve::LoopReport::unsolved] == 0.0;
  });
}

std::optional<RunFault> Executor::unsolved_loop() const {
  for (const plan::SolvedLoop& loop : plan_.loops) {
    const double* report = values() + loop.report;
    if (report[solve::LoopReport::unsolved] == 0.0) continue;
    const double time = report[solve::LoopReport::time], residual = report[solve::LoopReport::residual];
    if (!std::isfinite(residual))
      if (auto cause = not_finite()) return cause;
    const auto number = static_cast<std::size_t>(report[solve::LoopReport::number]);
    const auto tick = static_cast<std::int64_t>(std::floor(time / plan_.diagram.step * (1.0 + 1e-12)));
    const std::string subject = name_of(plan_, loop, number);
    const diagram::DiagramBlock& block =
        plan_.diagram.blocks[static_cast<std::size_t>(loop.tears.front().block)];
    return RunFault{
        block.name, "", time,
        plan_.diagram.fault(
            block.origin, block.name,
            fmt::format(
                "the algebraic loop {} is not solved at {:.12g} s (tick {}) within {} iterations: its "
                "blocks give {} a value that differs by {:.3g} from the one that they are given; the "
                "run ends here. A law that jumps (a relay) may have no solution: a Lag or a UnitDelay "
                "in the loop, or a slope in place of the jump helps",
                loop.path, time, tick, plan_.diagram.algebraic_loops.max_iterations, subject, residual))};
  }
  return std::nullopt;
}

LoopCost& LoopCost::operator+=(const LoopCost& other) {
  if (unsolved == 0) first_unsolved = other.first_unsolved;
  instants += other.instants;
  iterations += other.iterations;
  most = std::max(most, other.most);
  unsolved += other.unsolved;
  return *this;
}

void add_loops(std::vector<LoopCost>& all, const std::vector<LoopCost>& more) {
  for (const LoopCost& loop : more) {
    const auto known = std::ranges::find(all, loop.path, &LoopCost::path);
    if (known == all.end())
      all.push_back(loop);
    else
      *known += loop;
  }
}

std::vector<LoopCost> Executor::loop_costs() const {
  std::vector<LoopCost> costs;
  for (const plan::SolvedLoop& loop : plan_.loops) {
    const double* report = values() + loop.report;
    const auto whole = [&](std::size_t number) { return static_cast<std::int64_t>(report[number]); };
    std::int64_t unknowns = 0;
    for (const diagram::SignalRef& tear : loop.tears) unknowns += plan_.slot(tear).size;
    costs.push_back({loop.path, unknowns, whole(solve::LoopReport::instants),
                     whole(solve::LoopReport::passes), whole(solve::LoopReport::most),
                     whole(solve::LoopReport::unsolved), report[solve::LoopReport::time]});
  }
  return costs;
}

}  // namespace stepwire::run
