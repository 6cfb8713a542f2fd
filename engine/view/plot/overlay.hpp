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
                                      const NamesReading& read);

/// The keys of a motion and of a rose.
const Key& motion_form();
const Key& rose_form();
/// Words for the colours in which a motion is drawn, with these.
const std::vector<Key::Word>& motion_colors();

/// Reads `motion`, a map of its keys or a list of such.
void read_motions(const Node& node, Panel& panel, const NamesReading& read);

/// Reads `rose`, a map of its keys or a list of such.
void read_roses(const Node& node, Panel& panel, const NamesReading& read);

}  // namespace stepwire
