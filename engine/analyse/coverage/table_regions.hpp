#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::coverage {

/// Regions between the points of a table: intervals, or cells of a grid. A grid of
/// many cells has the intervals of each argument instead.
class TableRegions {
 public:
  /// Returns the regions of a block with its present values; std::nullopt for a block that is no such table.
  static std::optional<TableRegions> of(const diagram::DiagramBlock& block,
                                        const plan::PlannedBlock& planned);

  /// Names of the regions, in the order of their indices: "u from 0 to 1".
  const std::vector<std::string>& names() const { return names_; }
  /// Returns the indices of the regions in which the arguments of all elements are. Arguments beyond the
  /// points are in none.
  std::vector<std::size_t> at(const double* values) const;

 private:
  /// An argument: the place of its elements in the workspace, and the points along it.
  struct Axis {
    std::string input;
    std::size_t place, size;
    std::vector<double> points;

    std::optional<std::size_t> interval(const double* values, std::size_t element) const;
    std::string name(std::size_t interval) const;
  };

  static std::optional<Axis> axis_of(const diagram::DiagramBlock& block, const plan::PlannedBlock& planned,
                                     const char* input, const char* points);
  void add_axes(const diagram::DiagramBlock& block, const plan::PlannedBlock& planned);
  void name_regions();
  void add_element(const double* values, std::size_t element, std::vector<std::size_t>& found) const;

  std::vector<Axis> axes_;
  bool has_cells_ = true;  ///< false: the intervals of each axis, one axis behind the other
  std::vector<std::string> names_;
};

}  // namespace stepwire::coverage
