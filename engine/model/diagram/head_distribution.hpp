#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/sampling/distribution.hpp"
#include "engine/model/diagram/diagram.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// A number as it is written, and its unit: "5 mm" is {5, "mm"}.
struct WrittenNumber {
  double number = 0.0;
  std::string unit;
};
std::optional<WrittenNumber> written_number(const yaml::Node& node);

/// How a swept parameter is spread, in the unit in which its first number is written.
struct SpreadParameter {
  sampling::Distribution distribution;
  std::string unit;
  std::vector<std::string> words;  ///< what indices stand for, each as a setting has it
  yaml::Mark mark;

  bool is_words() const { return distribution.kind == sampling::Distribution::Kind::words; }
  /// The values at these shares of all samples.
  SweptValues values(const std::vector<double>& shares) const;
};

/// Reads {uniform: [100 N/m, 300 N/m]} and its like; nothing, and a fault, where it cannot be read.
std::optional<SpreadParameter> read_distribution(const yaml::Node& map, const std::string& name,
                                                 const Scope& scope, Report& report);

}  // namespace stepwire::diagram
