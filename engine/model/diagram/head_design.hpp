#pragma once

#include <vector>

#include "engine/model/diagram/head_distribution.hpp"

namespace stepwire::diagram {

/// A parameter of a sweep that is drawn.
struct DrawnAxis {
  std::size_t axis = 0;  ///< in Sweep::axes, where its values are still missing
  SpreadParameter spread;
};

/// Reads the keys `design` and `correlation` of a sweep, and draws the values of its axes by them.
void draw_axes(const yaml::Node& section, const std::vector<DrawnAxis>& drawn, const Scope& scope,
               Sweep& sweep, Report& report);

}  // namespace stepwire::diagram
