#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::query {

/// A number as a figure or claim gives it: "2 N", "2/3", "0.9*$limit".
struct WantedNumber {
  double value = 0.0;                          ///< SI
  std::optional<unit::Dimension> dimension{};  ///< none for a bare number or an expression
  std::string unit{};                          ///< as written, empty if none
  std::string text{};                          ///< as written
};

/// Reads a number with an optional unit, or an expression of numbers and parameters. Faults are placed inside
/// it.
std::optional<WantedNumber> read_number(const yaml::Node& node, const SymbolTable& names,
                                        const std::string& subject, yaml::Faults& faults);

/// Adds a fault where the number has a unit of another kind than the `what` that it is held against.
void check_dimension(const WantedNumber& number, const std::optional<unit::Dimension>& dimension,
                     const std::string& what, const yaml::Node& node, const SymbolTable& names,
                     const std::string& subject, yaml::Faults& faults);

/// A fault for a key that nobody knows; a key that looks like the rest of a broken expression is told so.
void add_unknown_key(const yaml::Entry& entry, const std::vector<std::string>& known,
                     const std::string& owner, const SymbolTable& names, const std::string& subject,
                     yaml::Faults& faults);

/// The text of a scalar, or a fault.
std::string read_text(const yaml::Node& node, const SymbolTable& names, const std::string& subject,
                      yaml::Faults& faults);

/// The number that is written with so many significant digits; what is no finite number is itself.
double rounded(double value, int digits);

/// A number for people: `digits` significant digits, no trailing zeros.
std::string short_number(double value, int digits = 4);

}  // namespace stepwire::query
