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

/// The name that starts at a position, dots included.
std::string name_at(std::string_view text, std::size_t position);

/// Returns a number in SI, with its unit where an expression can have that.
std::string number_text(double value, const std::optional<unit::Dimension>& dimension,
                        const SymbolTable& names);

/// A text in which each $name and each "word" is replaced by its number and each name of something drawn by
/// its expression, and for each character where it came from.
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

/// The same with the number of each name that is no signal, but a parameter.
Substituted with_parameters(const Substituted& text, const SymbolTable& names);

}  // namespace stepwire::query
