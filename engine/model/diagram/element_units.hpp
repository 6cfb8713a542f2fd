#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/base/unit/unit.hpp"

namespace stepwire::diagram {

/// Units of the elements of a list or matrix of numbers that has several, in column-major order;
/// std::nullopt for a bare number. Empty for numbers in one unit, or without any.
using EachUnit = std::vector<std::optional<unit::Dimension>>;

/// A range of elements of a signal, counted from 0.
struct ElementRange {
  std::size_t first = 0;
  std::size_t count = 0;  ///< 0: the whole signal
  bool known = true;      ///< false: one element of unknown index

  bool is_whole() const { return known && count == 0; }
};

/// Unit of a signal: one for all elements, or one for each. The unit of an element may be unknown.
class ElementUnits {
 public:
  using Each = EachUnit;

  ElementUnits(const unit::Dimension& one = {}) : each_{one} {}
  /// Makes one common unit if all elements have the same.
  explicit ElementUnits(Each each);
  /// Makes a unit that is unknown for all elements.
  static ElementUnits unknown() { return ElementUnits(Each{std::nullopt}); }

  /// True where every element has the same unit, or none has a known one.
  bool is_one() const { return each_.size() == 1; }
  /// Returns the unit of every element; std::nullopt if they differ or are unknown.
  std::optional<unit::Dimension> one() const { return is_one() ? each_.front() : std::nullopt; }
  const Each& each() const { return each_; }
  std::optional<unit::Dimension> of(std::size_t element) const;

  ElementUnits elements(const ElementRange& range) const;
  /// Returns this times other^exponent, element by element. Signals of different sizes give an unknown unit.
  ElementUnits times(const ElementUnits& other, double exponent) const;
  /// Returns the first unit of an element that is not 1; std::nullopt without one.
  std::optional<unit::Dimension> other_than_one() const;

 private:
  Each each_;  ///< one for all, or one for each element
};

/// True where no element has two different known units.
bool agree(const ElementUnits& a, const ElementUnits& b);

}  // namespace stepwire::diagram
