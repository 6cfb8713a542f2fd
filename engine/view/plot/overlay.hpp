#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/view/plot/gather.hpp"
#include "engine/view/plot/panel_reading.hpp"

namespace stepwire::plot {

/// Returns rows of an overlay of a panel, selected by its own condition.
std::vector<geometry::Curve> overlay_rows(const std::optional<query::Formula>& where,
                                          const record::Recording& recording,
                                          const std::vector<const query::Series*>& channels);

/// Reads a coordinate of an overlay: an expression, in the unit of the panel's axis.
std::optional<query::Series> read_coordinate(const yaml::Node& node, const std::string& axis,
                                             const Panel& panel, const query::NamesReading& read);

/// Return the keys of a motion and of a rose.
const yaml::Key& motion_form();
const yaml::Key& rose_form();
/// Returns the names and values of the colours of motions.
const std::vector<yaml::Key::Word>& motion_colors();

/// Reads `motion`, a map of its keys or a list of maps.
void read_motions(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Reads `rose`, a map of its keys or a list of maps.
void read_roses(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

}  // namespace stepwire::plot
