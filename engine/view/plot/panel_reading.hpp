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

/// Read a panel's `boundary`, formulas of its plane, or its `note`. Besides the coordinates they may name
/// recorded columns, whose values are those of the first row that the panel's `where` selects. Each has the
/// index of its recording.
void read_boundaries(const yaml::Node& node, Panel& panel, const query::NamesReading& read);
void read_note(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Reads the value of `region`: names of blocks with an outline.
void read_regions(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Checks that all series along an axis have one unit, that each y has an x, and that the legend has texts
/// for curves only. References, edges of a band and the vertical part of an arrow get the unit of their axis.
void check_axes(Panel& panel, const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults);

/// Reads the value of `marks`: {NAME: [X, Y], ...}, or a list of points, which are named 1, 2, 3. A mark
/// beyond a given range is a fault, so the ranges must be read before.
void read_marks(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Reads the value of `texts`: {TEXT: [X, Y], ...}, which must be within the ranges too.
void read_texts(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

}  // namespace stepwire::plot
