#pragma once

#include <cstddef>

#include "engine/analyse/comparison/compare.hpp"

namespace stepwire::comparison {

/// Rows [begin, end) of a trace at one instant.
struct RowGroup {
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end - begin; }
};

/// Range of values; empty without a finite one.
struct ValueRange {
  double low, high;
  bool has_missing = false;
  bool empty() const { return !(low <= high); }
};

/// Values of a trace at any time. Times within `same` of each other are one instant.
class Sampling {
 public:
  Sampling(const Trace& trace, bool hold, double same) : trace_(trace), hold_(hold), same_(same) {}

  /// Returns the rows at an instant; an empty group before the next row without one.
  RowGroup group(double time) const;
  /// Returns the value between the rows around an empty group.
  double between(double time, const RowGroup& at) const;
  /// Returns the values within [from, to]: of its rows, and at its ends.
  ValueRange range(double from, double to) const;

 private:
  void add_end(double time, ValueRange& range) const;

  const Trace& trace_;
  bool hold_;
  double same_;
};

/// Returns the time below which two instants are the same one, for times up to `last`.
double same_instant(double last);

}  // namespace stepwire::comparison
