#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/sampling/distribution.hpp"
#include "engine/model/diagram/bare_number.hpp"
#include "engine/model/diagram/diagram.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// Distribution of a swept parameter, in the unit of its first number.
struct SpreadParameter {
  sampling::Distribution distribution;
  std::string unit;
  std::vector<std::string> words;  ///< words coded by indices, as texts of a setting
  yaml::Mark mark;

  bool is_words() const { return distribution.kind == sampling::Distribution::Kind::words; }
  /// Returns the quantiles at these probabilities.
  SweptValues values(const std::vector<double>& shares) const;
};

/// Adds a fault for each number without unit, except 0, beside numbers with units, and returns false after
/// one. Lists are compared element by element. Formulas and words have no unit of their own.
bool have_units_together(const std::vector<const yaml::Node*>& numbers, const std::string& subject,
                         const Scope& scope, Report& report);

/// Reads a distribution such as {uniform: [100 N/m, 300 N/m]}; adds a fault and returns std::nullopt for an
/// invalid one.
std::optional<SpreadParameter> read_distribution(const yaml::Node& map, const std::string& name,
                                                 const Scope& scope, Report& report);

/// Most runs of a sweep: all are checked before the first one starts.
inline constexpr std::size_t max_runs = 10'000'000;

/// Reads {from: .., to: .., count: ..}; returns no values after a fault.
SweptValues read_range(const yaml::Node& map, const std::string& name, const Scope& scope, Report& report);

}  // namespace stepwire::diagram
