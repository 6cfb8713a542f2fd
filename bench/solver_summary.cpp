#include "bench/solver_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stepwire::bench {

void SolverSummary::Ratios::add(double ours, double theirs) {
  if (!(theirs > 0.0)) return;
  logarithms += std::log(ours / theirs);
  largest = std::max(largest, ours / theirs);
  ++count;
}

std::string SolverSummary::Ratios::text() const {
  return count > 0 ? fmt::format("{:.2f} ({:.2f})", std::exp(logarithms / count), largest) : "";
}

void SolverSummary::add(const ivp::Problem& problem, double relative, const std::string& solver,
                        const SolverRun& run, const SolverRun& same_tolerance, const SolverRun* same_digits) {
  Row& row = rows_[{problem.stiff, -relative, solver}];
  ++row.problems;
  row.calls.add(static_cast<double>(run.calls), static_cast<double>(same_tolerance.calls));
  row.time.add(run.seconds, same_tolerance.seconds);
  if (same_digits)
    row.calls_for_digits.add(static_cast<double>(run.calls), static_cast<double>(same_digits->calls));
  if (!run.failure.empty() || run.digits < -std::log10(relative) - 1.0)
    row.few_digits += fmt::format(" {} {}", problem.name,
                                  run.failure.empty() ? fmt::format("{:.1f}", run.digits) : run.failure);
}

void SolverSummary::print() const {
  fmt::print(
      "\n| problems | asked | by | calls, mean (largest) | calls for its digits | time | too few digits |\n"
      "|---|---|---|---|---|---|---|\n");
  for (const auto& [key, row] : rows_) {
    const auto& [stiff, asked, solver] = key;
    fmt::print("| {} {} | {:.0e} | {} | {} | {} | {} |{} |\n", row.problems, stiff ? "stiff" : "not stiff",
               -asked, solver, row.calls.text(), row.calls_for_digits.text(), row.time.text(),
               row.few_digits);
  }
}

}  // namespace stepwire::bench
