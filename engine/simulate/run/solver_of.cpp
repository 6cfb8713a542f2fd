#include "engine/simulate/run/solver_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace stepwire::run {

namespace {

std::string names_of(bool controlled) {
  std::vector<std::string> names;
  for (const solve::SolverKind& kind : solve::solver_kinds())
    if (controlled ? kind.controls : kind.fixed) names.push_back(kind.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Solvers of other programs, in lower case, and the one here of the same method or use.
struct OtherSolver {
  std::string_view names, here;
  bool controlled;  ///< with steps by its error
};

constexpr OtherSolver other_solvers[] = {
    {"ode45 rk45 dopri5 dp5 tsit5", "dormand_prince", true},
    {"ode23 rk23 bs3", "bogacki_shampine", true},
    {"ode78 ode89 ode113 vern7 dop853", "dop853", true},
    {"ode15s ode15i ode23t ode23tb bdf cvode cvodes ida dassl daspk radau radau5 radauiia5", "radau", true},
    {"ode23s", "rosenbrock", true},
    {"lsoda variablestepauto odeint solve_ivp", "auto", true},
    {"ode1 forwardeuler", "euler", false},
    {"ode2", "heun", false},
    {"ode3", "bogacki_shampine", false},
    {"ode4 rk", "rk4", false},
    {"ode5", "dormand_prince", false},
    {"ode8", "dop853", true},
    {"ode14x ode1be", "sdirk", false}};

/// Returns the setting that takes the place of another program's solver; empty for other names.
std::string other_solver(const std::string& name) {
  std::string word = " " + name + " ";
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const OtherSolver& other : other_solvers) {
    if ((" " + std::string(other.names) + " ").find(word) == std::string::npos) continue;
    const std::string setting = other.controlled
                                    ? fmt::format("solver: {{name: {}, relative: 1e-6}}", other.here)
                                    : fmt::format("solver: {}", other.here);
    return fmt::format("there is no solver '{}'; in its place write '{}'", name, setting);
  }
  return "";
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
  if (const std::string other = other_solver(name); !other.empty()) return other;
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
