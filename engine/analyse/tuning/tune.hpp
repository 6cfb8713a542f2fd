#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/tuning/evaluation.hpp"
#include "engine/analyse/tuning/tune_runs.hpp"
#include "engine/base/messages/items.hpp"
#include "engine/base/result/record.hpp"

namespace stepwire::tuning {

/// Singular values and confidence intervals of an optimisation with targets. Parameters are scaled by the way
/// between their bounds, targets by their deviations.
struct Resolution {
  std::vector<std::vector<double>> jacobian{};  ///< Jacobian: one row per target.
  /// Singular values of the Jacobian, the largest first. A direction with a value below 1 is free: the whole
  /// way from bound to bound changes the targets by less than one deviation.
  std::vector<double> singular_values{};
  /// 95 % interval of each parameter within its bounds, SI; std::nullopt if it takes part in a free
  /// direction.
  std::vector<std::optional<std::array<double, 2>>> intervals{};
  std::vector<std::string> findings{};  ///< Parameters of each free direction, as text.
};

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
  std::string file{};      ///< Diagram file.
  std::string minimise{};  ///< Expression of the objective.
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

/// Options of a call that are not part of the file.
struct TuneOptions {
  unsigned threads = 0;  ///< 0: all cores. The result is the same to the last bit.
  std::function<void(double fraction, const std::string& what)> progress{};
  messages::ItemWorkers* workers =
      nullptr;  ///< Processes that search from the starts; nullptr: this process does.
};

/// Minimises the objective of a file subject to its claims. Throws Error for faults of the request, and if no
/// start can be run. Without a finished run (interrupted) the result has no numbers.
TuneResult tune(const TuneSource& source, const run::Job& job, const TuneRequest& request,
                const TuneOptions& options = {});

/// Declares the fields of tune.json.
void declare(result::Record<TuneResult>& is);

}  // namespace stepwire::tuning
