#pragma once

#include <string>

namespace stepwire::plan {

/// A parsed shape: "n", "+n", "m x n", "m x +n", "+m x n". A plus marks the sum over the elements of a list.
struct PortShape {
  explicit PortShape(const std::string& text) {
    const std::size_t times = text.find(" x ");
    is_matrix = times != std::string::npos;
    rows = text.substr(0, times);
    if (is_matrix) columns = text.substr(times + 3);
    adds_rows = take_plus(rows);
    adds_columns = take_plus(columns);
  }

  std::string rows, columns;  ///< letters or numbers; a vector has `rows` only
  bool is_matrix = false, adds_rows = false, adds_columns = false;

 private:
  static bool take_plus(std::string& letter) {
    if (!letter.starts_with('+')) return false;
    letter.erase(0, 1);
    return true;
  }
};

}  // namespace stepwire::plan
