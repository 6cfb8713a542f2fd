#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/base/unit/unit.hpp"

namespace stepwire::diagram {

/// Some elements of a signal, from 0.
struct ElementRange {
  std::size_t first = 0;
  std::size_t count = 0;  ///< 0: the whole signal
  bool known = true;      ///< false: one element, of which is not known which it is

  bool is_whole() const { return known && count == 0; }
};

/// The unit of a signal: one for all elements, or one for each. The unit of an element may be unknown.
class ElementUnits {
 public:
  using Each = std::vector<std::optional<unit::Dimension>>;

  ElementUnits(const unit::Dimension& one = {}) : each_{one} {}
  /// Elements of one unit become one unit for all.
  explicit ElementUnits(Each each);
  /// No element has a known unit.
  static ElementUnits unknown() { return ElementUnits(Each{std::nullopt}); }

  /// True where every element has the same unit, or none has a known one.
  bool is_one() const { return each_.size() == 1; }
  /// The unit of every element; nullopt where they differ or are unknown.
  std::optional<unit::Dimension> one() const { return is_one() ? each_.front() : std::nullopt; }
  const Each& each() const { return each_; }
  std::optional<unit::Dimension> of(std::size_t element) const;

  ElementUnits elements(const ElementRange& range) const;
  /// This times other^exponent, element by element. Signals of different sizes give an unknown unit.
  ElementUnits times(const ElementUnits& other, double exponent) const;
  /// The first element that has a unit other than 1, with it.
  std::optional<unit::Dimension> other_than_one() const;

 private:
  Each each_;  ///< one for all, or one for each element
};

/// True where no element has two different known units.
bool agree(const ElementUnits& a, const ElementUnits& b);

}  // namespace stepwire::diagram
