#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/place.hpp"

namespace stepwire::diagram {

/// The values of one axis of a sweep, each of them as the text that a setting has. They are few texts with
/// their places, each of which may stand at several points (4 bytes a point), or numbers in one unit, which
/// all come from one place (8 bytes a point).
class SweptValues {
 public:
  SweptValues() = default;
  /// Texts at these places, or at none. `which` says which of them each value is; without it each is one.
  explicit SweptValues(std::vector<std::string> texts, std::vector<yaml::Mark> marks = {},
                       std::vector<std::uint32_t> which = {});
  /// Numbers in a unit, which may be empty.
  SweptValues(std::vector<double> numbers, const std::string& unit, const yaml::Mark& mark);

  std::size_t size() const;
  bool empty() const { return size() == 0; }
  /// Of a number the shortest text that reads back as the same double, and its unit.
  std::string text(std::size_t value) const;
  yaml::Mark mark(std::size_t value) const;

  bool are_numbers() const { return texts_.empty() && !numbers_.empty(); }
  /// A value in SI, where they are numbers.
  double number(std::size_t value) const;
  /// The unit of the first value that is written with one.
  std::optional<unit::Dimension> dimension() const;
  /// The texts, where they are none.
  const std::vector<std::string>& texts() const { return texts_; }
  /// Which of the texts a value is.
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
