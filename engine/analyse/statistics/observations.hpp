#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stepwire::statistics {

/// A factor of a design: its levels, and the level of every observation.
struct Factor {
  std::string name;
  std::vector<std::string> levels;
  std::vector<std::size_t> level;  ///< Index into levels, one per observation.
  bool subject = false;            ///< True: the levels are subjects (or blocks, plots), not treatments.
};

/// A response and its factors. An observation is one value of each.
struct Observations {
  std::string response;  ///< Name of the response: "path error".
  std::vector<double> values;
  std::vector<Factor> factors;

  /// Returns a factor by name. Throws StatisticsError for an unknown name, and lists the known ones.
  const Factor& factor(const std::string& name) const;

  /// Throws StatisticsError for an empty list, a non-finite value, a factor of another length, a level out of
  /// range, or two factors of one name.
  void check() const;
};

/// Makes a factor from the word of each observation; levels are in order of first occurrence.
Factor make_factor(std::string name, const std::vector<std::string>& words, bool subject = false);

/// Observations with the same levels of some factors.
struct Cell {
  std::vector<std::size_t> levels;  ///< One level per factor.
  std::vector<double> values;
};

/// Returns all combinations of the levels of these factors, the last factor varying fastest. Combinations
/// without observations have no values. Without factors there is one cell.
std::vector<Cell> cells(const Observations& observations, const std::vector<std::string>& factors);

/// Returns "haptic present, visual absent".
std::string cell_name(const Observations& observations, const std::vector<std::string>& factors,
                      const Cell& cell);

}  // namespace stepwire::statistics
