#pragma once

#include <cstddef>
#include <optional>

#include "engine/analyse/query/formula.hpp"

namespace stepwire::query {

/// Row range of one run of a recording, and the first row in it that satisfies a condition.
struct RunRows {
  std::size_t begin = 0, end = 0, first = 0;

  bool none() const { return first >= end; }
};

/// Finds the first row of a recording for which `where` holds (without `where`, row 0), and the run that
/// contains it.
RunRows rows_of_run(const std::optional<Formula>& where, const record::Recording& recording);

}  // namespace stepwire::query
