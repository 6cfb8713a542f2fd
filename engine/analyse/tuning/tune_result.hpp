#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/tuning/evaluation.hpp"
#include "engine/analyse/tuning/resolution.hpp"

namespace stepwire::tuning {

/// A number that was found, in SI.
struct TunedNumber {
  std::string name;  ///< of the parameter
  double value = 0.0, start = 0.0, lower = 0.0, upper = 0.0;
  bool at_bound = false;
  std::optional<unit::Dimension> dimension{};
  std::string unit{};                               ///< for showing it; empty: SI
  std::optional<std::array<double, 2>> interval{};  ///< 95 % by the targets; empty of a free direction
};

/// A target at what was found.
struct TunedTarget {
  claim::Verdict verdict;
  double off = 0.0;    ///< in its deviations
  double start = 0.0;  ///< the same at the given start
};

/// A claim at the start and at what was found.
struct TunedClaim {
  claim::Verdict verdict;  ///< at what was found
  double margin = 0.0;     ///< there, in SI: negative where it fails
  double start = 0.0;      ///< its value at the given start
  bool active = false;  ///< holds with next to nothing to spare, so that it keeps the objective from falling
};

/// How a search from one start went.
struct TunedStart {
  std::optional<double> objective{};  ///< empty if no point has all claims
  bool converged = false;
  std::size_t evaluations = 0;
};

struct TuneResult {
  std::vector<TunedNumber> numbers;
  double objective = 0.0;              ///< at what was found
  double start_objective = 0.0;        ///< at the given start; nan where it cannot be run
  std::string worst{};                 ///< the run whose objective is the largest; empty of one run
  std::vector<TunedTarget> targets{};  ///< in the order of the file
  Resolution resolution{};             ///< by these targets
  std::vector<TunedClaim> claims;
  std::vector<Evaluation> history;  ///< of all searches, in their order
  std::vector<TunedStart> starts;
  std::vector<std::string> findings;           ///< what is at a bound, in the way, or could not be run
  std::optional<unit::Dimension> dimension{};  ///< of the objective
  std::string method;
  std::size_t runs = 1;  ///< of one evaluation
  std::size_t bad = 0;   ///< evaluations without an objective
  bool feasible = false;
  bool converged = false, interrupted = false, compiled = false;
  double seconds = 0.0;

  std::vector<diagram::Setting> settings;  ///< what sets the parameters to what was found
};

}  // namespace stepwire::tuning
