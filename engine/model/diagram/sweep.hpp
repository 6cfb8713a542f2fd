#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/sampling/design.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/model/diagram/origin.hpp"
#include "engine/model/diagram/swept_values.hpp"

namespace stepwire::diagram {

/// What a file asks to be varied: each point sets these parameters to one value each.
struct Sweep {
  /// Axes whose values are paired: all of them are one axis of the grid.
  enum class Group : unsigned char { none, samples, cases };
  struct Axis {
    std::string parameter;
    SweptValues values;
    Origin origin;
    bool label = false;  ///< a column of words about the points, which sets nothing
    Group group = Group::none;

    bool sampled() const { return group == Group::samples; }
    bool of_cases() const { return group == Group::cases; }
    std::size_t count() const { return values.size(); }
    std::string text(std::size_t value) const { return values.text(value); }
    yaml::Mark mark(std::size_t value) const { return values.mark(value); }
  };
  /// What stays of a run.
  enum class Keep {
    rows,    ///< all that is recorded
    final,   ///< the last recorded row
    numbers  ///< one row of reductions
  };
  std::vector<Axis> axes;
  bool together = false;                     ///< all axes are paired
  std::optional<sampling::Design> design{};  ///< by which sampled axes are drawn
  Keep keep = Keep::rows;
  yaml::Node kept{};  ///< the reductions by name, as written
  std::size_t recorded_runs =
      0;  ///< number of runs of each case that are recorded over time beside the numbers

  /// How many points there are; a double, since a grid may be larger than anything.
  double count() const;
  /// Which value each axis has at a point: the last axis of a grid runs fastest. Those of a group are one
  /// axis of it, where the last of them stands.
  std::vector<std::size_t> indices(std::size_t point) const;
  /// The names of the cases, in each of which all other values are run; none without.
  std::vector<std::string> cases() const;
  /// The points, ascending, of which rows stay beside the numbers that are kept: evenly chosen, the first and
  /// the last one among them.
  std::vector<std::size_t> recorded_points() const;
  bool records_rows_of(std::size_t point) const;
};

/// Labels of a sweep of one parameter at a time: which one differs from the file's value (at the first point
/// none, and the word is `base`), and to what.
inline constexpr const char *differs_label = "differs", *differs_to_label = "differs_to",
                            *nothing_differs = "base";
/// The label of cases.
inline constexpr const char* case_label = "case";

}  // namespace stepwire::diagram
