#pragma once

#include <optional>
#include <string>

#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

struct PanelKey;

/// Returns the keys that every panel takes whose plot has what they need.
const std::vector<PanelKey>& panel_keys();
/// Returns the keys of a whole picture.
const std::vector<yaml::KeyRow<Figure, query::NamesReading>>& picture_keys();

/// Reads one panel. Keys of the whole picture are skipped if `alone`, else they are refused.
std::optional<Panel> read_panel(const yaml::Node& node, const query::SymbolTable& names, bool alone,
                                yaml::Faults& faults);

/// Reads a number for an axis of the panel, x, y, z or color, in the displayed unit.
std::optional<double> read_axis_number(const yaml::Node& node, const Panel& panel, const std::string& axis,
                                       const query::SymbolTable& names, const std::string& subject,
                                       yaml::Faults& faults);

}  // namespace stepwire::plot
