// Compares work and precision of the error-controlled solvers with CVODE of SUNDIALS. The problems are those
// of the Bari test set, of DETEST and of stiff DETEST. Prints a table in Markdown.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/extrapolation.hpp"
#include "bench/solver_runs.hpp"
#include "bench/solver_summary.hpp"
#include "tests/support/ivp/bari.hpp"
#include "tests/support/ivp/detest.hpp"
#include "tests/support/ivp/stiff_detest.hpp"

namespace {

using namespace stepwire;
using bench::SolverRun;

/// Returns a run with the shortest time of several repetitions, within 0.02 s.
template <class Run>
SolverRun shortest(const Run& run) {
  SolverRun best = run();
  double spent = best.seconds;
  for (int i = 0; i < 50 && spent < 0.02; ++i) {
    const SolverRun again = run();
    spent += again.seconds;
    best.seconds = std::min(best.seconds, again.seconds);
  }
  return best;
}

/// Returns CVODE's runs at tolerances from 1e-2 to 1e-13, three per decade.
std::vector<SolverRun> curve_of(const ivp::Problem& problem) {
  std::vector<SolverRun> runs;
  for (int third = 6; third <= 39; ++third) {
    const double relative = std::pow(10.0, -third / 3.0);
    runs.push_back(
        shortest([&] { return bench::run_cvode(problem, relative, problem.absolute * relative); }));
  }
  return runs;
}

/// Returns the cheapest of CVODE's runs with at least these digits; nullptr if there is none.
const SolverRun* as_good(const std::vector<SolverRun>& curve, double digits) {
  const SolverRun* best = nullptr;
  for (const SolverRun& run : curve)
    if (run.failure.empty() && run.digits >= digits && (!best || run.calls < best->calls)) best = &run;
  return best;
}

std::string ratio(double ours, double theirs) {
  return theirs > 0.0 ? fmt::format("{:.2f}", ours / theirs) : "";
}

void print_row(const ivp::Problem& problem, double relative, const std::string& by, const SolverRun& run,
               const SolverRun& cvode, const SolverRun* good) {
  fmt::print("| {} | {:.0e} | {} | {} | {} | {} | {} | {} | {:.0f} | {} | {} | {} |\n", problem.name,
             relative, by, run.failure.empty() ? fmt::format("{:.1f}", run.digits) : run.failure, run.steps,
             run.rejected, run.calls, ratio(run.calls, cvode.calls), 1e6 * run.seconds,
             ratio(run.seconds, cvode.seconds), good ? ratio(run.calls, good->calls) : "",
             good ? ratio(run.seconds, good->seconds) : "");
  std::fflush(stdout);
}

void measure(ivp::Problem problem, const std::vector<std::string>& solvers, bench::SolverSummary& summary) {
  if (problem.right.empty()) problem.right = bench::extrapolate(problem);
  const std::vector<SolverRun> curve = curve_of(problem);
  for (const double relative : {1e-4, 1e-7, 1e-10}) {
    const double absolute = problem.absolute * relative;
    const SolverRun cvode = shortest([&] { return bench::run_cvode(problem, relative, absolute); });
    const auto add = [&](const std::string& by, const SolverRun& run) {
      const SolverRun* good = as_good(curve, run.digits);
      print_row(problem, relative, by, run, cvode, good);
      summary.add(problem, relative, by, run, cvode, good);
    };
    add("CVODE", cvode);
    for (const std::string& solver : solvers)
      add(solver, shortest([&] { return bench::run_engine(problem, solver, relative, absolute); }));
  }
}

}  // namespace

/// Arguments are the names of problems to run. The ring modulator takes minutes and runs only by its name.
int main(int argc, char** argv) {
  fmt::print(
      "| problem | asked | by | digits | steps | rejected | calls | ratio | us | ratio | "
      "calls for its digits | time for its digits |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  bench::SolverSummary summary;
  for (const auto& part : {ivp::bari(), ivp::all_stiff_detest(), ivp::all_detest()})
    for (const ivp::Problem& problem : part) {
      const auto named = [&](const char* name) { return problem.name == name; };
      if (argc > 1 ? std::none_of(argv + 1, argv + argc, named) : problem.name == "RINGMOD") continue;
      const std::vector<std::string> stiff{"rodas", "radau", "auto"},
          others{"dormand_prince", "dop853", "bogacki_shampine", "auto"};
      measure(problem, problem.stiff ? stiff : others, summary);
    }
  summary.print();
}
