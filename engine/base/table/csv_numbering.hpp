#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace stepwire::table {

/// The words of one column, each with its number.
struct CsvNumbering {
  std::vector<std::string>* texts = nullptr;  ///< nullptr where the column holds numbers
  std::unordered_map<std::string, double> numbers{};

  double operator()(const std::string& text) {
    const auto [place, is_new] = numbers.try_emplace(text, static_cast<double>(texts->size()));
    if (is_new) texts->push_back(text);
    return place->second;
  }
};

}  // namespace stepwire::table
