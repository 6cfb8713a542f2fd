#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/view/plot/gather.hpp"
#include "engine/view/plot/panel_reading.hpp"

namespace stepwire {

/// Rows of what is drawn over a panel, by a condition of its own.
std::vector<Curve> overlay_rows(const std::optional<Formula>& where, const Recording& recording,
                                const std::vector<const Series*>& channels);

/// Reads a coordinate of what is drawn over a panel: an expression, in the unit of the panel's axis.
std::optional<Series> read_coordinate(const Node& node, const std::string& axis, const Panel& panel,
                                      const Names& names, const std::string& subject, Faults& faults);

/// Adds a fault for each key of a map that is no row.
void check_keys(const Node& node, const std::vector<FigureKey>& rows, const std::string& owner,
                const Names& names, const std::string& subject, Faults& faults);

/// The keys of a motion and of a rose.
const std::vector<FigureKey>& motion_keys();
const std::vector<FigureKey>& rose_keys();

/// Reads `motion`, a map of its keys or a list of such.
void read_motions(const Node& node, Panel& panel, const Names& names, Faults& faults);

/// Reads `rose`, a map of its keys or a list of such.
void read_roses(const Node& node, Panel& panel, const Names& names, Faults& faults);

}  // namespace stepwire
