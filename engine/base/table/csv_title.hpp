#pragma once

#include <string>

#include "engine/base/table/table.hpp"

namespace stepwire::table {

inline bool is_csv_blank(char c) {
  return c == ' ' || c == '\t';
}

/// Returns the text without surrounding blanks.
std::string csv_trimmed(const std::string& text);

/// Splits "name [unit]" into its parts. "x[2]" without a blank is a name with an index.
Column csv_column(const std::string& title);

}  // namespace stepwire::table
