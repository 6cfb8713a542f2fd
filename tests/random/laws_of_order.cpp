// The order of a solver: with half of the step the error falls to a 2^p-th. No reference is needed: the
// difference of two runs is the error of the longer steps but for a small part of it. A column proves
// something only where its differences fall by the same factor twice, above rounding: then the factor is
// that of the method, and not of steps that are too long.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/simulate/solve/solver.hpp"
#include "tests/random/law_tools.hpp"
#include "tests/random/reshaping.hpp"
#include "tests/random/smooth.hpp"

namespace stepwire::random {

namespace {

constexpr int halvings = 6;
/// An order that is lower by this than that of the method breaks the law.
constexpr double missing_order = 0.4;
/// Two orders of one column that differ by less are steady.
constexpr double alike = 0.15;
/// A difference of this part of a column's size is no small error.
constexpr double far = 0.01;
/// Differences below this part of a column's size are rounding.
constexpr double rounding_part = 1e-12;
/// The same for a solver whose equations are solved by iteration.
constexpr double solved_part = 1e-8;

/// Order of a solver; 0 for one that is unknown.
int order_of(const std::string& solver) {
  for (const solve::SolverKind& kind : solve::solver_kinds())
    if (kind.name == solver) return kind.order;
  return 0;
}

/// The past of a TransportDelay has the order 4 at corners of higher derivatives.
int order_with_past(const std::string& solver, const Sketch& sketch) {
  bool has_past = std::ranges::any_of(sketch.blocks, [](const Entry& entry) {
    return entry.find("block") && *entry.find("block") == "TransportDelay";
  });
  for (const auto& [file, part] : sketch.parts)
    has_past = has_past || order_with_past(solver, part) < order_of(solver);
  return has_past ? std::min(order_of(solver), 4) : order_of(solver);
}

Sketch with_parts_of_steps(const Sketch& sketch, double step, int parts) {
  Sketch made = sketch;
  for (Key& key : made.head)
    if (key.name == "step") key.value = fmt::format("{:.17g} s", step / parts);
  return made;
}

double size_of(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// Largest difference of two columns, the second of which has twice as many steps.
double difference_of(const std::vector<double>& coarse, const std::vector<double>& fine) {
  double most = 0.0;
  for (std::size_t row = 0; row < coarse.size() && 2 * row < fine.size(); ++row)
    most = std::max(most, std::abs(coarse[row] - fine[2 * row]));
  return most;
}

/// Numbers of one column with ever shorter steps, at all of their ticks.
using Runs = std::vector<std::vector<double>>;

struct ColumnOrder {
  bool is_known = false;
  double order = 0.0;
};

/// The last two orders above rounding.
ColumnOrder order_of(const Runs& runs, double noise) {
  std::vector<double> orders;
  double before = 0.0;
  for (std::size_t k = 0; k + 1 < runs.size(); ++k) {
    const double now = difference_of(runs[k], runs[k + 1]);
    if (!(now > noise * size_of(runs[k]))) break;
    if (k > 0) orders.push_back(std::log2(before / now));
    before = now;
  }
  if (orders.size() < 3 || before > far * size_of(runs.back())) return {};
  const double last = orders.back(), one_before = orders[orders.size() - 2], two = orders[orders.size() - 3];
  return {std::abs(last - one_before) < alike && std::abs(one_before - two) < 2.0 * alike, last};
}

/// The same column of all runs.
Runs runs_of(const std::vector<run::RunResult>& results, std::size_t column) {
  Runs runs;
  for (const run::RunResult& result : results)
    runs.push_back(result.recordings.front().table.columns[column].values);
  return runs;
}

}  // namespace

Verdict verdict_on_order(const std::vector<run::RunResult>& results, int order, double noise) {
  bool proves = false;
  const table::Table& first = results.front().recordings.front().table;
  for (std::size_t c = 1; c < first.columns.size(); ++c) {
    const ColumnOrder found = order_of(runs_of(results, c), noise);
    if (!found.is_known) continue;
    proves = true;
    if (found.order < order - missing_order)
      return verdict_of(fmt::format("{}: the error falls by 2^{:.2f} with half of the step, and not by 2^{}",
                                    first.columns[c].name, found.order, order));
  }
  return proves ? Verdict{} : skipped("no column has an order");
}

Verdict step_halved(const Trial& trial, BatchCode&) {
  const std::string* solver = find_head(trial.sketch, "solver");
  const int order = solver ? order_with_past(*solver, trial.sketch) : 0;
  if (order == 0) return skipped("it has no continuous states, or another solver");
  if (const std::string why = why_not_smooth(trial.sketch); !why.empty()) return skipped(why);
  if (find_head(trial.sketch, "stop_when")) return skipped("it ends by itself");
  const bool is_solved = *solver == "rosenbrock" || *solver == "sdirk";
  std::vector<run::RunResult> results;
  for (int k = 0; k <= halvings; ++k) {
    const Loaded loaded(*trial.registry,
                        with_parts_of_steps(trial.sketch, trial.loaded->plan().diagram.step, 1 << k),
                        trial.folder);
    results.push_back(run(loaded));
    if (!results.back().faults.empty()) return skipped("it ends in a fault");
  }
  return verdict_on_order(results, order, is_solved ? solved_part : rounding_part);
}

}  // namespace stepwire::random
