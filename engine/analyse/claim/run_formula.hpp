#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/query/formula.hpp"

namespace stepwire::claim {

/// An expression of numbers that are made of one run: "settling_time(y)/(1 s) + 0.1*rms(u where time > 1 s)".
struct RunFormula {
  std::string text{};               ///< as written
  std::vector<Claim> reductions{};  ///< without comparisons
  /// Its columns are those of `names`, and what a run has one number of: swept parameters, kept numbers.
  std::optional<query::Formula> formula{};
  std::vector<std::string> names{};  ///< of the reductions in the formula

  /// The columns that it reads, of each recording by itself.
  std::vector<std::string> columns() const;
};

/// True for a text that calls a reduction.
bool has_reduction(const std::string& text);

/// Reads such an expression. Reductions have the names that claims have, and what they reduce in brackets;
/// `max` and `min` of several values are the functions. Faults are placed inside it.
std::optional<RunFormula> read_run_formula(const yaml::Node& node, const query::NamesReading& read);

/// Its number in each run, nan where there is none; nothing of a run in which `where` of a reduction selects
/// no row. Throws std::invalid_argument where a column is not there.
std::vector<std::optional<double>> values_of(const RunFormula& formula,
                                             std::span<const record::Recording> recordings);

}  // namespace stepwire::claim
