#pragma once

#include <cctype>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/expression/expression.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/error.hpp"
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
  bool is_ratio = false;  ///< True for a number that is no angle, although radians have no dimension.
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

/// Returns the message for an unknown name of a signal.
yaml::Message unknown_column(const std::string& name, const SymbolTable& names);

inline bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Returns the name that starts at a position, with its dots.
std::string name_at(std::string_view text, std::size_t position);

/// Returns the name among SymbolTable::drawn of a parameter whose text is a formula of signals: "$boundary".
std::string name_of_text(const std::string& parameter);

/// Returns a number in SI, with its unit if expressions support that unit.
std::string number_text(double value, const std::optional<unit::Dimension>& dimension,
                        const SymbolTable& names);

/// Text after substitution, and the original position of each character. Each $name and each "word" is
/// replaced by its number, each name of a drawn formula by its expression.
struct Substituted {
  std::string text;
  std::vector<std::size_t> origin;

  void append(std::string_view part, std::size_t from) {
    text += part;
    origin.insert(origin.end(), part.size(), from);
  }
  std::size_t origin_of(std::size_t position) const {
    if (origin.empty()) return 0;
    return position < origin.size() ? origin[position] : origin.back() + 1;
  }
};

Substituted substitute(std::string_view text, const SymbolTable& names);

}  // namespace stepwire::query
