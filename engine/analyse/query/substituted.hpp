#pragma once

#include <cctype>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/analyse/query/symbol_table.hpp"

namespace stepwire::query {

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

/// Replaces each name that is a parameter, not a signal, by its number.
Substituted with_parameters(const Substituted& text, const SymbolTable& names);

}  // namespace stepwire::query
