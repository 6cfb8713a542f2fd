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

/// Where there is no value.
inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// An expression over recorded columns, its names found.
struct Formula {
  std::string text;  ///< as written
  expression::Expression expression;
  std::vector<std::string> columns;          ///< column for each variable of the expression
  std::optional<std::size_t> recording;      ///< which recording has them; none: any
  std::optional<unit::Dimension> dimension;  ///< none where it is not known
  yaml::Mark mark;
};

/// Reads an expression; `$name` is the number of a parameter, and a word in quotes behind `NAME ==` or
/// `NAME !=` that which stands for it in a column of words. What is wrong goes to `faults` with the place
/// inside the scalar, and nothing is returned.
std::optional<Formula> read_formula(const yaml::Node& node, const SymbolTable& names,
                                    const std::string& subject, yaml::Faults& faults);

/// The same for the text that starts `offset` characters into a scalar.
std::optional<Formula> read_formula(const yaml::Node& node, std::string_view text, std::size_t offset,
                                    const SymbolTable& names, const std::string& subject,
                                    yaml::Faults& faults);

/// The one recording that all of these formulas read, or a fault that says which names are recorded apart.
/// Null formulas are passed over; 0 where any recording does.
std::size_t common_recording(const std::vector<const Formula*>& formulas, const SymbolTable& names,
                             const yaml::Node& at, const std::string& subject, yaml::Faults& faults);

/// Its value in each row. Throws std::invalid_argument if a column is not there.
std::vector<double> evaluate(const Formula& formula, const record::Recording& recording);

/// Place of the character `offset` of a scalar's text.
yaml::Place place_in(const yaml::Node& node, std::size_t offset, const SymbolTable& names);

}  // namespace stepwire::query
