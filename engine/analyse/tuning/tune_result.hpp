#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/tuning/evaluation.hpp"
#include "engine/analyse/tuning/resolution.hpp"

namespace stepwire::tuning {

/// Result for one parameter, in SI.
struct TunedNumber {
  std::string name;  ///< Name of the parameter.
  double value = 0.0, start = 0.0, lower = 0.0, upper = 0.0;
  bool at_bound = false;
  std::optional<unit::Dimension> dimension{};
  std::string unit{};                               ///< Unit in which it is shown; empty: SI.
  std::optional<std::array<double, 2>> interval{};  ///< 95 %; std::nullopt in a free direction.
};

/// A target at the optimum.
struct TunedTarget {
  claim::Verdict verdict;
  double off = 0.0;    ///< Error in units of its deviation.
  double start = 0.0;  ///< The same at the given start.
};

/// A claim at the start and at the optimum.
struct TunedClaim {
  claim::Verdict verdict;  ///< Verdict at the optimum.
  double margin = 0.0;     ///< Margin at the optimum, in SI: negative if it fails.
  double start = 0.0;      ///< Value at the given start.
  bool active = false;     ///< True if the margin is close to 0: the claim limits the objective.
};

/// Result of the search from one start.
struct TunedStart {
  std::optional<double> objective{};  ///< std::nullopt if no point satisfies all claims.
  bool converged = false;
  std::size_t evaluations = 0;
};

struct TuneResult {
  std::vector<TunedNumber> numbers;
  double objective = 0.0;        ///< Objective at the optimum.
  double start_objective = 0.0;  ///< Objective at the given start; nan if it cannot be run.
  std::string worst{};           ///< Label of the run with the largest objective; empty for a single run.
  std::vector<TunedTarget> targets{};  ///< Targets in the order of the file.
  Resolution resolution{};             ///< Resolution of the parameters by the targets.
  std::vector<TunedClaim> claims;
  std::vector<Evaluation> history;  ///< Evaluations of all searches, in order.
  std::vector<TunedStart> starts;
  std::vector<std::string> findings;           ///< Messages on bounds, violated claims, failed evaluations.
  std::optional<unit::Dimension> dimension{};  ///< Dimension of the objective.
  std::string method;
  std::size_t runs = 1;  ///< Number of runs per evaluation.
  std::size_t bad = 0;   ///< Number of evaluations without an objective.
  bool feasible = false;
  bool converged = false, interrupted = false, compiled = false;
  double seconds = 0.0;

  std::vector<diagram::Setting> settings;  ///< Settings that give the parameters their optimum.
};

}  // namespace stepwire::tuning
