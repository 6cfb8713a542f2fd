#pragma once

#include <optional>
#include <string>

#include "engine/figure/figure.hpp"

namespace stepwire {

/// Keys that every panel takes.
const std::vector<FigureKey>& panel_keys();
/// Keys of a whole picture.
const std::vector<FigureKey>& picture_keys();

/// Reads one panel; keys of the whole picture are passed over where `alone`, else they are refused.
std::optional<Panel> read_panel(const Node& node, const Names& names, bool alone, Faults& faults);

/// Reads "EXPR", "EXPR in UNIT" or {signal: ..., label: ...}.
std::optional<Series> read_series(const Node& node, const Names& names, const std::string& subject,
                                  Faults& faults);

}  // namespace stepwire
