#include "engine/analyse/linear/delay_chain.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace stepwire::linear {

namespace {

/// Returns the system with wires in place of its delays. No loop of delays alone may exist.
StateSpace with_wires(const StateSpace& system) {
  const auto d = static_cast<Eigen::Index>(system.delays.size());
  const Eigen::Index p = std::ssize(system.outputs), m = std::ssize(system.inputs);
  const Eigen::MatrixXd inner = Eigen::MatrixXd::Identity(d, d) - system.D.bottomRightCorner(d, d);
  const Eigen::PartialPivLU<Eigen::MatrixXd> solver(inner);
  const Eigen::MatrixXd from_states = solver.solve(system.C.bottomRows(d)),
                        from_inputs = solver.solve(system.D.bottomLeftCorner(d, m));
  StateSpace wired = system;
  wired.delays.clear();
  wired.A = system.A + system.B.rightCols(d) * from_states;
  wired.B = system.B.leftCols(m) + system.B.rightCols(d) * from_inputs;
  wired.C = system.C.topRows(p) + system.D.topRightCorner(p, d) * from_states;
  wired.D = system.D.topLeftCorner(p, m) + system.D.topRightCorner(p, d) * from_inputs;
  return wired;
}

/// Returns the system from one column of B to one row of C, without delays and without unused states.
StateSpace part_between(const StateSpace& system, Eigen::Index column, Eigen::Index row) {
  return StateSpace{system.A,      system.B.col(column), system.C.row(row), system.D.block(row, column, 1, 1),
                    system.states, {{"", ""}},           {{"", ""}},        0.0}
      .connected();
}

/// True if a path from a column of B to a row of C passes no delay.
bool has_path(const StateSpace& system, Eigen::Index column, Eigen::Index row) {
  return system.D(row, column) != 0.0 || !part_between(system, column, row).states.empty();
}

}  // namespace

std::optional<DelayChain> delay_chain(const StateSpace& system) {
  const auto d = static_cast<Eigen::Index>(system.delays.size());
  if (d == 0) return DelayChain{system, 0.0};
  // Node 0 is the source of paths (input or end of a delay) and their target (output or start of a delay).
  std::vector<char> passed(static_cast<std::size_t>(d) + 1, 0);
  double time = 0.0;
  Eigen::Index here = 0;
  for (Eigen::Index count = 0; count <= d; ++count) {
    Eigen::Index next = -1;
    for (Eigen::Index row = 0; row <= d; ++row) {
      if (!has_path(system, here, row)) continue;
      if (next >= 0) return std::nullopt;
      next = row;
    }
    if (next < 0 || std::exchange(passed[static_cast<std::size_t>(next)], 1)) return std::nullopt;
    if (next > 0) time += system.delays[static_cast<std::size_t>(next - 1)].time;
    here = next;
    if (here == 0) break;
  }
  if (here != 0 || std::ranges::count(passed, 1) != d + 1) return std::nullopt;
  return DelayChain{with_wires(system).connected(), time};
}

StateSpace around_delay(const StateSpace& system, std::size_t delay) {
  const auto m = std::ssize(system.inputs), p = std::ssize(system.outputs);
  std::vector<Eigen::Index> columns{m + static_cast<Eigen::Index>(delay)},
      rows{p + static_cast<Eigen::Index>(delay)};
  StateSpace around = system;
  around.delays.clear();
  for (std::size_t k = 0; k < system.delays.size(); ++k) {
    if (k == delay) continue;
    columns.push_back(m + static_cast<Eigen::Index>(k));
    rows.push_back(p + static_cast<Eigen::Index>(k));
    around.delays.push_back(system.delays[k]);
  }
  around.inputs = {system.delays[delay].in};
  around.outputs = {system.delays[delay].out};
  around.B = system.B(Eigen::all, columns);
  around.C = system.C(rows, Eigen::all);
  around.D = system.D(rows, columns);
  return around;
}

StateSpace with_loops_only(const StateSpace& system) {
  std::vector<Eigen::Index> columns, rows;
  StateSpace part = system;
  part.delays.clear();
  for (std::size_t i = 0; i < system.inputs.size(); ++i) columns.push_back(static_cast<Eigen::Index>(i));
  for (std::size_t o = 0; o < system.outputs.size(); ++o) rows.push_back(static_cast<Eigen::Index>(o));
  for (std::size_t k = 0; k < system.delays.size(); ++k) {
    const StateSpace around = around_delay(system, k).connected();
    if (around.states.empty() && around.delays.empty() && around.D(0, 0) == 0.0) continue;
    columns.push_back(std::ssize(system.inputs) + static_cast<Eigen::Index>(k));
    rows.push_back(std::ssize(system.outputs) + static_cast<Eigen::Index>(k));
    part.delays.push_back(system.delays[k]);
  }
  part.B = system.B(Eigen::all, columns);
  part.C = system.C(rows, Eigen::all);
  part.D = system.D(rows, columns);
  return part;
}

}  // namespace stepwire::linear
