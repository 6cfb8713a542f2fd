#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/sampling/design.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/place.hpp"

namespace stepwire::diagram {

/// Location in a file of a diagram: `scope` identifies the file and its user.
struct Origin {
  int scope = 0;
  yaml::Mark mark;
};

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

/// Parameter variations defined by a file: each point sets one value for each of these parameters.
struct Sweep {
  /// Groups of axes whose values are paired: all axes of a group are one axis of the grid.
  enum class Group : unsigned char { none, samples, cases };
  struct Axis {
    std::string parameter;
    SweptValues values;
    Origin origin;
    bool label = false;  ///< a column of words about the points; it sets no parameter
    Group group = Group::none;

    bool sampled() const { return group == Group::samples; }
    bool of_cases() const { return group == Group::cases; }
    std::size_t count() const { return values.size(); }
    std::string text(std::size_t value) const { return values.text(value); }
    yaml::Mark mark(std::size_t value) const { return values.mark(value); }
  };
  /// Results that are kept of a run.
  enum class Keep {
    rows,    ///< all recorded rows
    final,   ///< the last recorded row
    numbers  ///< one row of reductions
  };
  std::vector<Axis> axes;
  bool together = false;                     ///< all axes are paired
  std::optional<sampling::Design> design{};  ///< of the sampled axes
  Keep keep = Keep::rows;
  yaml::Node kept{};              ///< the named reductions, as written
  std::size_t recorded_runs = 0;  ///< number of runs of each case whose rows are kept beside the numbers

  /// Returns the number of points; a double, since a grid may exceed every integer type.
  double count() const;
  /// Returns the index of each axis' value at a point. The last axis of a grid varies fastest. The axes of a
  /// group form one axis at the position of the last one.
  std::vector<std::size_t> indices(std::size_t point) const;
  /// Returns the names of the cases, each combined with all other values; an empty list without cases.
  std::vector<std::string> cases() const;
  /// Returns the points, ascending, whose rows are kept beside the reduced numbers: evenly chosen, including
  /// the first and the last one.
  std::vector<std::size_t> recorded_points() const;
  bool records_rows_of(std::size_t point) const;
};

/// Labels of a sweep of one parameter at a time: the parameter that differs from the file's value, and its
/// value. The first point has the word `base`.
inline constexpr const char *differs_label = "differs", *differs_to_label = "differs_to",
                            *nothing_differs = "base";
/// Label of the cases.
inline constexpr const char* case_label = "case";

}  // namespace stepwire::diagram
