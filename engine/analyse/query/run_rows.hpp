#pragma once

#include <cstddef>
#include <optional>

#include "engine/analyse/query/formula.hpp"

namespace stepwire::query {

/// The rows of one run of a recording, and the first of them for which a condition holds.
struct RunRows {
  std::size_t begin = 0, end = 0, first = 0;

  bool none() const { return first >= end; }
};

/// Finds the first row of all for which `where` is true (without it, the first), and the run in which it
/// lies.
RunRows rows_of_run(const std::optional<Formula>& where, const record::Recording& recording);

}  // namespace stepwire::query
