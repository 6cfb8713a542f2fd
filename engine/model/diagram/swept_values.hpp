#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/place.hpp"

namespace stepwire::diagram {

/// Values of one axis of a sweep, each as the text of a setting. They are a few texts with locations, each
/// possibly at several points (4 bytes a point). Or they are numbers in one unit with a common location (8
/// bytes a point).
class SweptValues {
 public:
  SweptValues() = default;
  /// Makes values of texts with optional locations. `which` has the index of each value's text; without it
  /// each text is one value.
  explicit SweptValues(std::vector<std::string> texts, std::vector<yaml::Mark> marks = {},
                       std::vector<std::uint32_t> which = {});
  /// Makes values of numbers in a unit, which may be empty.
  SweptValues(std::vector<double> numbers, const std::string& unit, const yaml::Mark& mark);

  std::size_t size() const;
  bool empty() const { return size() == 0; }
  /// Returns the text of a value: for a number the shortest digits that read back to the same double, and its
  /// unit.
  std::string text(std::size_t value) const;
  yaml::Mark mark(std::size_t value) const;

  bool are_numbers() const { return texts_.empty() && !numbers_.empty(); }
  /// Returns a numeric value in SI.
  double number(std::size_t value) const;
  /// Returns the unit of the first value with one.
  std::optional<unit::Dimension> dimension() const;
  /// Returns the texts; an empty list for numbers.
  const std::vector<std::string>& texts() const { return texts_; }
  /// Returns the index of a value's text.
  std::size_t which(std::size_t value) const { return which_.empty() ? value : which_[value]; }

 private:
  std::vector<std::string> texts_;
  std::vector<yaml::Mark> marks_;
  std::vector<std::uint32_t> which_;
  std::vector<double> numbers_;
  std::string unit_text_;
  unit::Unit unit_;
};

}  // namespace stepwire::diagram
