#pragma once

#include <span>
#include <string>
#include <vector>

namespace stepwire::table {

/// View of a column of one run. If `words` is not empty, the numbers 0, 1, ... are codes for its entries.
struct SeriesView {
  std::string name, unit;
  std::span<const double> values;
  std::span<const std::string> words{};
};

/// Value of a swept parameter in a run: a number with its unit, or a word.
struct SweptValue {
  std::string name, unit;
  double number = 0.0;
  std::string word{};  ///< empty: the value is the number
};

/// View of one run, for files that hold several runs.
struct RunView {
  std::string name;  ///< "run-1", ...; empty for a single run
  std::vector<SweptValue> swept;
  std::vector<SeriesView> series;  ///< of equal length; the time is first
};

}  // namespace stepwire::table
