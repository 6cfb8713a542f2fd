#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "bench/solver_runs.hpp"

namespace stepwire::bench {

/// Means and extremes by solver and tolerance, separately for stiff and other problems.
class SolverSummary {
 public:
  /// Adds a run with two runs of CVODE for comparison: at the same tolerance, and the cheapest of the same
  /// digits (nullptr: none).
  void add(const ivp::Problem& problem, double relative, const std::string& solver, const SolverRun& run,
           const SolverRun& same_tolerance, const SolverRun* same_digits);
  void print() const;

 private:
  struct Ratios {
    double logarithms = 0.0, largest = 0.0;
    int count = 0;
    void add(double ours, double theirs);
    std::string text() const;
  };
  struct Row {
    int problems = 0;
    Ratios calls, calls_for_digits, time;
    std::string few_digits;  ///< Names of problems with more than 1 digit too few.
  };
  std::map<std::tuple<bool, double, std::string>, Row> rows_;
};

}  // namespace stepwire::bench
