#pragma once

#include <span>
#include <string>
#include <vector>

namespace stepwire::table {

/// A column of one run, whose numbers lie elsewhere. Where `words` has some, the numbers 0, 1, ... stand for
/// them.
struct SeriesView {
  std::string name, unit;
  std::span<const double> values;
  std::span<const std::string> words{};
};

/// What a run of a sweep sets: a number with its unit, or a word.
struct SweptValue {
  std::string name, unit;
  double number = 0.0;
  std::string word{};  ///< empty: it is the number
};

/// One run as files with a place for each run have it.
struct RunView {
  std::string name;  ///< "run-1", ...; empty for a single run
  std::vector<SweptValue> swept;
  std::vector<SeriesView> series;  ///< of equal length, the time first
};

}  // namespace stepwire::table
