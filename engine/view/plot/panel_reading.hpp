#pragma once

#include <optional>
#include <string>

#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

struct PanelKey;

/// Keys that every panel takes whose plot has what they need.
const std::vector<PanelKey>& panel_keys();
/// Keys of a whole picture.
const std::vector<yaml::KeyRow<Figure, query::NamesReading>>& picture_keys();

/// Reads one panel; keys of the whole picture are passed over where `alone`, else they are refused.
std::optional<Panel> read_panel(const yaml::Node& node, const query::SymbolTable& names, bool alone,
                                yaml::Faults& faults);

/// Reads a number for an axis of the panel, x, y, z or color: in the unit in which that is drawn.
std::optional<double> read_axis_number(const yaml::Node& node, const Panel& panel, const std::string& axis,
                                       const query::SymbolTable& names, const std::string& subject,
                                       yaml::Faults& faults);

/// Reads what follows a panel's `boundary`, formulas of its plane, or its `note`: beside the coordinates they
/// name what was recorded, as it is in the first row that the panel's `where` selects. Each has the index of
/// its recording.
void read_boundaries(const yaml::Node& node, Panel& panel, const query::NamesReading& read);
void read_note(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Reads the value of `region`: names of blocks with an outline.
void read_regions(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Checks that all along an axis have one unit, that there is an x for each y, and texts of the legend for
/// curves only; references get the unit of their axis.
void check_axes(Panel& panel, const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults);

/// Reads the value of `marks`: {NAME: [X, Y], ...}, or a list of points, which are named 1, 2, 3. A mark
/// beyond the ranges that the file gives is a fault; so the panel has its ranges by now.
void read_marks(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Reads the value of `texts`: {TEXT: [X, Y], ...}, which lie within the ranges, too.
void read_texts(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

}  // namespace stepwire::plot
