#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stepwire::statistics {

/// What may explain a response: its levels and the level of every observation.
struct Factor {
  std::string name;
  std::vector<std::string> levels;
  std::vector<std::size_t> level;  ///< index into levels, one for each observation
  bool subject = false;            ///< its levels are people (or blocks, plots), not treatments
};

/// A response and the factors that may explain it: one observation is one value of each.
struct Observations {
  std::string response;  ///< what the values are: "path error"
  std::vector<double> values;
  std::vector<Factor> factors;

  /// Throws StatisticsError for a name that no factor has; it names those that there are.
  const Factor& factor(const std::string& name) const;

  /// Throws StatisticsError where there are no values, where a value is no finite number, where a factor has
  /// another length or a level out of range,
  /// and where two factors have one name.
  void check() const;
};

/// A factor from the word of each observation; levels are in the order in which they come up.
Factor make_factor(std::string name, const std::vector<std::string>& words, bool subject = false);

/// The observations that have the same levels of some factors.
struct Cell {
  std::vector<std::size_t> levels;  ///< one for each of the factors
  std::vector<double> values;
};

/// All combinations of the levels of these factors, the last one running fastest; those that nobody observed
/// have no values. Without factors there is one cell.
std::vector<Cell> cells(const Observations& observations, const std::vector<std::string>& factors);

/// "haptic present, visual absent".
std::string cell_name(const Observations& observations, const std::vector<std::string>& factors,
                      const Cell& cell);

}  // namespace stepwire::statistics
