#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/expression/expression.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::query {

/// Value of a missing number: NaN.
inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// An expression over recorded columns with resolved names.
struct Formula {
  std::string text;  ///< Text as written.
  expression::Expression expression;
  std::vector<std::string> columns;      ///< Column of each variable of the expression.
  std::optional<std::size_t> recording;  ///< Index of the recording with these columns; std::nullopt: any.
  std::optional<unit::Dimension> dimension;  ///< Dimension of the value; std::nullopt if unknown.
  yaml::Mark mark;
};

/// Reads an expression. `$name` is replaced by the value of a parameter. A quoted word after `NAME ==` or
/// `NAME !=` is replaced by its number in a column of words. Adds faults to `faults`, placed inside the
/// scalar, and returns std::nullopt.
std::optional<Formula> read_formula(const yaml::Node& node, const SymbolTable& names,
                                    const std::string& subject, yaml::Faults& faults);

/// Reads an expression that starts `offset` characters into a scalar.
std::optional<Formula> read_formula(const yaml::Node& node, std::string_view text, std::size_t offset,
                                    const SymbolTable& names, const std::string& subject,
                                    yaml::Faults& faults);

/// Returns the index of the recording that all formulas read; 0 if any recording has their columns. Skips
/// null formulas. Adds a fault that names the columns if they are in different recordings.
std::size_t common_recording(const std::vector<const Formula*>& formulas, const SymbolTable& names,
                             const yaml::Node& at, const std::string& subject, yaml::Faults& faults);

/// Evaluates a formula in each row. Throws std::invalid_argument for a missing column.
std::vector<double> evaluate(const Formula& formula, const record::Recording& recording);

/// Returns the place of the character `offset` of a scalar's text.
yaml::Place place_in(const yaml::Node& node, std::size_t offset, const SymbolTable& names);

}  // namespace stepwire::query
