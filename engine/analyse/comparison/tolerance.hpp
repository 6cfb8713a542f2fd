#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::comparison {

/// Accepted difference of a signal. Where absolute and relative are given, the larger one counts.
struct Tolerance {
  std::optional<double> absolute{};       ///< Number in SI with a unit, else in the unit of the signal.
  std::optional<unit::Dimension> unit{};  ///< Dimension of `absolute`; std::nullopt without a unit.
  std::string absolute_text{};            ///< Text as written: "0.1 N".
  std::optional<double> relative{};       ///< Share of the largest absolute value of the signal in A.
  std::optional<double> jitter{};         ///< Time by which an edge may be earlier or later [s].
  std::optional<bool> hold{};             ///< True: B keeps each value up to the next row.
};

/// Tolerance of the signals whose names match a pattern with * and ?.
struct ToleranceRule {
  std::string signals = "*";
  Tolerance tolerance{};
};

/// Tolerances of a comparison, and the signals that it considers.
struct Tolerances {
  std::vector<ToleranceRule> rules{};  ///< Later rules win, key by key.
  std::vector<std::string> only{};     ///< Patterns of the compared signals; empty: all.

  Tolerance of(const std::string& signal) const;
  bool includes(const std::string& signal) const;
};

/// True if a name matches a pattern with * (any text), ? (one character) and [ab].
bool matches(const std::string& pattern, const std::string& name);

/// Set a value of a tolerance from its text. They return what is wrong with it; empty if nothing is.
std::string set_absolute(Tolerance& tolerance, const std::string& text);
std::string set_relative(Tolerance& tolerance, const std::string& text);
std::string set_jitter(Tolerance& tolerance, const std::string& text);

/// File of accepted differences: `compare --within FILE`.
struct Acceptance {
  std::string baseline{};  ///< File or folder that the run is compared with, from the folder of the file.
  Tolerances tolerances{};
};

/// Reads such a file. Throws yaml::Error with all faults.
Acceptance read_acceptance(const std::string& file);

}  // namespace stepwire::comparison
