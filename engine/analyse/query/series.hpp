#pragma once

#include <optional>
#include <string>

#include "engine/analyse/query/formula.hpp"
#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::query {

/// Returns a unit as printed: mm, N m, m/s², °; "–" for a number without unit.
std::string printed_unit(const std::string& unit);

/// A quantity drawn along an axis or as a colour: formula, unit of the drawing, label without unit.
struct Series {
  Formula formula;
  unit::Unit unit;
  std::string unit_text;  ///< Unit as written; empty if unknown.
  std::string label;      ///< The expression, or the label that the file gives.

  /// Returns the label of an axis: "rig.x [mm]".
  std::string axis_label() const;
};

/// Returns advice on how to give a formula a unit: "name its SI unit behind it, as 'x in m', or in the head
/// units: {..}".
std::string unit_cure(const Formula& formula, const unit::Dimension& wanted);

/// Reads "EXPR", "EXPR in UNIT" or {signal: ..., label: ...}.
std::optional<Series> read_series(const yaml::Node& node, const SymbolTable& names,
                                  const std::string& subject, yaml::Faults& faults);

}  // namespace stepwire::query
