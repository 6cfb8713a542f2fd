#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/view/plot/gather.hpp"
#include "engine/view/plot/panel_reading.hpp"

namespace stepwire::plot {

/// Rows of what is drawn over a panel, by a condition of its own.
std::vector<geometry::Curve> overlay_rows(const std::optional<query::Formula>& where,
                                          const record::Recording& recording,
                                          const std::vector<const query::Series*>& channels);

/// Reads a coordinate of what is drawn over a panel: an expression, in the unit of the panel's axis.
std::optional<query::Series> read_coordinate(const yaml::Node& node, const std::string& axis,
                                             const Panel& panel, const query::NamesReading& read);

/// The keys of a motion and of a rose.
const yaml::Key& motion_form();
const yaml::Key& rose_form();
/// Words for the colours in which a motion is drawn, with these.
const std::vector<yaml::Key::Word>& motion_colors();

/// Reads `motion`, a map of its keys or a list of such.
void read_motions(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Reads `rose`, a map of its keys or a list of such.
void read_roses(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

}  // namespace stepwire::plot
