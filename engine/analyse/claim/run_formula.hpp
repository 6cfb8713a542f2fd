#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/query/formula.hpp"

namespace stepwire::claim {

/// Expression over numbers of one run: "settling_time(y)/(1 s) + 0.1*rms(u where time > 1 s)".
struct RunFormula {
  std::string text{};               ///< Text as written.
  std::vector<Claim> reductions{};  ///< Reductions called in the text, without comparisons.
  /// Formula over the reductions in `names` and over constants of a run: swept parameters, kept numbers.
  std::optional<query::Formula> formula{};
  std::vector<std::string> names{};  ///< Names of the reductions in the formula.

  /// Returns the columns that the formula and its reductions read.
  std::vector<std::string> columns() const;
};

/// True for a text that calls a reduction.
bool has_reduction(const std::string& text);

/// Reads such an expression. A reduction is called by its key in claims, with the reduced formula in
/// brackets. `max` and `min` with several arguments are the ordinary functions. Faults are placed inside the
/// text.
std::optional<RunFormula> read_run_formula(const yaml::Node& node, const query::NamesReading& read);

/// Evaluates the formula in each run: std::nullopt where `where` of a reduction selects no row, nan where the
/// value is undefined. Throws std::invalid_argument for a missing column.
std::vector<std::optional<double>> values_of(const RunFormula& formula,
                                             std::span<const record::Recording> recordings);

}  // namespace stepwire::claim
