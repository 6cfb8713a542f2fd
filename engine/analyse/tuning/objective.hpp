#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/query/formula.hpp"

namespace stepwire::tuning {

/// An expression of numbers that are made of one run: "settling_time(y)/(1 s) + 0.1*rms(u where time > 1 s)".
struct Objective {
  std::string text{};                      ///< as written
  std::vector<claim::Claim> reductions{};  ///< without comparisons
  std::optional<query::Formula>
      formula{};                     ///< its columns are those of `names`, then swept and tuned parameters
  std::vector<std::string> names{};  ///< of the reductions in the formula

  /// The columns that it reads, of each recording by itself.
  std::vector<std::string> columns() const;
};

/// Reads an objective. Reductions have the names that claims have, and what they reduce in brackets; `max`
/// and `min` of several values are the functions. Faults are placed inside it.
std::optional<Objective> read_objective(const yaml::Node& node, const query::NamesReading& read);

/// Its number in each run, nan where there is none; nothing of a run in which `where` of a reduction selects
/// no row. Throws std::invalid_argument where a column is not there.
std::vector<std::optional<double>> values_of(const Objective& objective,
                                             std::span<const record::Recording> recordings);

}  // namespace stepwire::tuning
