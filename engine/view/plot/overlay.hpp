#pragma once

#include <optional>
#include <vector>

#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

/// Returns rows of an overlay of a panel, selected by its own condition.
std::vector<geometry::Curve> overlay_rows(const std::optional<query::Formula>& where,
                                          const record::Recording& recording,
                                          const std::vector<const query::Series*>& channels);

/// Return the keys of a motion and of a rose.
const yaml::Key& motion_form();
const yaml::Key& rose_form();
/// Returns the names and values of the colours of motions.
const std::vector<yaml::Key::Word>& motion_colors();

/// Reads `motion`, a map of its keys or a list of maps.
void read_motions(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Reads `rose`, a map of its keys or a list of maps.
void read_roses(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Read a panel's `boundary`, formulas of its plane, or its `note`. Besides the coordinates they may name
/// recorded columns, whose values are those of the first row that the panel's `where` selects. Each has the
/// index of its recording.
void read_boundaries(const yaml::Node& node, Panel& panel, const query::NamesReading& read);
void read_note(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Reads the value of `region`: names of blocks with an outline.
void read_regions(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Reads the value of `marks`: {NAME: [X, Y], ...}, or a list of points, which are named 1, 2, 3. A mark
/// beyond a given range is a fault, so the ranges must be read before.
void read_marks(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

/// Reads the value of `texts`: {TEXT: [X, Y], ...}, which must be within the ranges too.
void read_texts(const yaml::Node& node, Panel& panel, const query::NamesReading& read);

}  // namespace stepwire::plot
