#pragma once

#include <vector>

#include "engine/base/fmi/calls.hpp"

namespace stepwire::fmi {

/// Moves numbers in SI to and from variables of a unit: those of one type in one call. Allocates when it is
/// made, and never after.
class ValueGroups {
 public:
  enum class Which { all, continuous };

  /// Numbers lie in the order of the variables, those of an array one after the other; where only continuous
  /// ones are moved, the others have their places all the same.
  explicit ValueGroups(const std::vector<const Variable*>& variables, Which which = Which::all);

  std::size_t count() const { return count_; }
  bool get(Calls& calls, double* numbers);
  bool set(Calls& calls, const double* numbers);

 private:
  struct Place {
    std::size_t number;  ///< in SI
    double factor, offset;
  };
  struct Group {
    Type type;
    std::vector<std::uint32_t> references;
    std::vector<Place> places;
    std::vector<double> room;  ///< for the values as the unit has them
  };

  std::vector<Group> groups_;
  std::size_t count_ = 0;
};

}  // namespace stepwire::fmi
