#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::coverage {

/// Transition of a chart, by the indices of its states.
struct ChartArrow {
  std::size_t from, to;
};

/// States of a chart in the order of their numbers, by full names, with the declared transitions.
struct Chart {
  std::vector<std::string> states{};
  std::vector<ChartArrow> arrows{};

  /// True if a state is `holder` or within it.
  bool is_within(std::size_t state, std::size_t holder) const;
};

/// Returns the chart of a block with states; an empty one for other blocks.
Chart chart_of(const diagram::DiagramBlock& block);

}  // namespace stepwire::coverage
