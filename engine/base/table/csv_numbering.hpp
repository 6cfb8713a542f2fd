#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace stepwire::table {

/// Assigns the numbers 0, 1, ... to the words of one column.
struct CsvNumbering {
  std::vector<std::string>* texts = nullptr;  ///< nullptr for a column of numbers
  std::unordered_map<std::string, double> numbers{};

  double operator()(const std::string& text) {
    const auto [place, is_new] = numbers.try_emplace(text, static_cast<double>(texts->size()));
    if (is_new) texts->push_back(text);
    return place->second;
  }
};

}  // namespace stepwire::table
