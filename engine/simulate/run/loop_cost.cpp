#include "engine/simulate/run/loop_cost.hpp"

#include <algorithm>

#include "engine/simulate/solve/loop_task.hpp"

namespace stepwire::run {

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

std::vector<LoopCost> loop_costs(const plan::Plan& plan, const double* values) {
  std::vector<LoopCost> costs;
  for (const plan::SolvedLoop& loop : plan.loops) {
    const double* report = values + loop.report;
    const auto whole = [&](std::size_t number) { return static_cast<std::int64_t>(report[number]); };
    std::int64_t unknowns = 0;
    for (const diagram::SignalRef& tear : loop.tears) unknowns += plan.slot(tear).size;
    costs.push_back({loop.path, unknowns, whole(solve::LoopReport::instants),
                     whole(solve::LoopReport::passes), whole(solve::LoopReport::most),
                     whole(solve::LoopReport::unsolved), report[solve::LoopReport::time]});
  }
  return costs;
}

}  // namespace stepwire::run
