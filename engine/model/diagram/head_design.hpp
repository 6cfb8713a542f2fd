#pragma once

#include <vector>

#include "engine/model/diagram/head_distribution.hpp"

namespace stepwire::diagram {

/// A sampled parameter of a sweep.
struct DrawnAxis {
  std::size_t axis = 0;  ///< index in Sweep::axes; its values are not yet set
  SpreadParameter spread;
};

/// Reads the keys `design` and `correlation` of a sweep, and samples the values of its axes.
void draw_axes(const yaml::Node& section, const std::vector<DrawnAxis>& drawn, const Scope& scope,
               Sweep& sweep, Report& report);

}  // namespace stepwire::diagram
