#include "engine/simulate/run/solver_of.hpp"

#include <fmt/format.h>

namespace stepwire::run {

namespace {

std::string names_of(bool controlled) {
  std::vector<std::string> names;
  for (const solve::SolverKind& kind : solve::solver_kinds())
    if (controlled ? kind.controls : kind.fixed) names.push_back(kind.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

yaml::Message why_none(const std::string& name, bool controlled) {
  std::vector<std::string> all;
  for (const solve::SolverKind& kind : solve::solver_kinds()) {
    all.push_back(kind.name);
    if (kind.name != name) continue;
    return controlled ? fmt::format("{} has no estimate of its error; of those that have one take one of {}",
                                    name, names_of(true))
                      : fmt::format("{} chooses its steps; give its error: {{name: {}, relative: 1e-6}}",
                                    name, name);
  }
  return fmt::format("there is no solver '{}'", name) +
         yaml::did_you_mean(name, all, fmt::format("Known are: {}", fmt::join(all, ", ")));
}

}  // namespace

std::unique_ptr<solve::Solver> solver_of(const plan::Plan& plan) {
  const diagram::Diagram& diagram = plan.diagram;
  if (diagram.solver.empty()) return nullptr;
  std::optional<solve::ErrorControl> control;
  if (const auto& own = diagram.error_control) control = {own->relative, own->absolute, own->max_steps};
  auto solver = solve::make_solver(diagram.solver, plan.layout.state_count, control);
  if (!solver)
    throw yaml::Error(
        diagram.fault(diagram.solver_origin, "solver", why_none(diagram.solver, control.has_value())));
  return plan.layout.state_count > 0 ? std::move(solver) : nullptr;
}

}  // namespace stepwire::run
