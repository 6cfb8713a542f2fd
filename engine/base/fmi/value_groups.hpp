#pragma once

#include <vector>

#include "engine/base/fmi/calls.hpp"

namespace stepwire::fmi {

/// Transfers SI numbers to and from variables of a unit, grouped by type to one call each. Allocates only on
/// construction.
class ValueGroups {
 public:
  enum class Which { all, continuous };

  /// Numbers are in the order of the variables; those of an array are contiguous. With Which::continuous the
  /// other variables are skipped, but keep their positions.
  explicit ValueGroups(const std::vector<const Variable*>& variables, Which which = Which::all);

  std::size_t count() const { return count_; }
  bool get(Calls& calls, double* numbers);
  bool set(Calls& calls, const double* numbers);

 private:
  struct Place {
    std::size_t number;  ///< index among the SI numbers
    double factor, offset;
  };
  struct Group {
    Type type;
    std::vector<std::uint32_t> references;
    std::vector<Place> places;
    std::vector<double> room;  ///< buffer for values in the unit's type
  };

  std::vector<Group> groups_;
  std::size_t count_ = 0;
};

}  // namespace stepwire::fmi
