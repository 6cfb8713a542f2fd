#pragma once

#include <optional>
#include <string>

#include "engine/analyse/query/formula.hpp"
#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/message.hpp"

namespace stepwire::query {

/// A number in a figure or claim: "2 N", "2/3", "0.9*$limit".
struct WantedNumber {
  double value = 0.0;                          ///< Value in SI.
  std::optional<unit::Dimension> dimension{};  ///< Dimension of the unit; std::nullopt without one.
  std::string unit{};                          ///< Unit as written; empty without one.
  std::string text{};                          ///< Text as written.
};

/// Reads a number with an optional unit, or an expression of numbers and parameters. Faults are placed inside
/// the text.
std::optional<WantedNumber> read_number(const yaml::Node& node, const SymbolTable& names,
                                        const std::string& subject, yaml::Faults& faults);

/// Returns the unit behind a number: "N m" of "2 N m"; empty without one.
std::string unit_after_number(const std::string& text);

/// Returns the message for two formulas whose values cannot be compared: other units, rates or temperatures
/// of other meanings. Empty if they can.
std::string compared_fault(const Formula& first, const Formula& second);

/// Unit that a number is to have.
struct MeantUnit {
  std::optional<unit::Dimension> dimension{};  ///< std::nullopt if unknown
  bool is_ratio = false;                       ///< True for a pure number, which is no angle.
};

/// Adds a fault if the unit of the number is not that of `what`, the value it is compared with.
void check_dimension(const WantedNumber& number, const MeantUnit& meant, const std::string& what,
                     const yaml::Node& node, const SymbolTable& names, const std::string& subject,
                     yaml::Faults& faults);

/// Returns the fault of a number written without unit where `what` is in a unit other than SI; std::nullopt
/// for 0, infinity, percent and other texts, such as formulas.
std::optional<yaml::Message> bare_number(const std::string& text, const std::string& unit,
                                         const std::string& what);

/// Returns the text of a scalar; adds a fault for any other node.
std::string read_text(const yaml::Node& node, const SymbolTable& names, const std::string& subject,
                      yaml::Faults& faults);

/// Rounds to `digits` significant decimal digits. Returns a non-finite number unchanged.
double rounded(double value, int digits);

/// Formats a number for reports: `digits` significant digits, no trailing zeros.
std::string short_number(double value, int digits = 4);

}  // namespace stepwire::query
