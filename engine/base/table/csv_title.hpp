#pragma once

#include <string>

#include "engine/base/table/table.hpp"

namespace stepwire::table {

inline bool is_csv_blank(char c) {
  return c == ' ' || c == '\t';
}

/// Without the blanks around it.
std::string csv_trimmed(const std::string& text);

/// "name [unit]" apart. "x[2]" without a blank is a name with its index.
Column csv_column(const std::string& title);

}  // namespace stepwire::table
