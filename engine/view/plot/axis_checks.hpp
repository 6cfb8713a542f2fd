#pragma once

#include <optional>
#include <string>

#include "engine/analyse/query/series.hpp"
#include "engine/base/yaml/message.hpp"
#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

/// Returns the fault of a series drawn along the axis of another one: a unit of another quantity, an unknown
/// unit, a rate or temperature of another meaning. Returns std::nullopt if it can be drawn in that unit.
std::optional<yaml::Message> fault_along(const query::Series& series, const query::Series& axis);

/// Returns the fault of a number written without unit on an axis whose unit is not SI; std::nullopt for 0,
/// infinity and other texts.
std::optional<yaml::Message> bare_number(const std::string& text, const query::Series& axis);

/// Checks that all series along an axis have one unit, that each y has an x, and that the legend has texts
/// for curves only. References, edges of a band and the vertical part of an arrow get the unit of their axis.
void check_axes(Panel& panel, const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults);

}  // namespace stepwire::plot
