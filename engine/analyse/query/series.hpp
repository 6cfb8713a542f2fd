#pragma once

#include <optional>
#include <string>

#include "engine/analyse/query/formula.hpp"
#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::query {

/// A unit as people print it: mm, N m, m/s², °; "–" where there is none.
std::string printed_unit(const std::string& unit);

/// What is drawn along an axis or as a colour: a formula, the unit it is drawn in, and its label without
/// unit.
struct Series {
  Formula formula;
  unit::Unit unit;
  std::string unit_text;  ///< empty where the unit is not known
  std::string label;      ///< the expression unless the file says otherwise

  /// "rig.x [mm]".
  std::string axis_label() const;
};

/// How to give a formula a unit of a dimension: "name its SI unit behind it, as 'x in m', or in the head
/// units: {..}".
std::string unit_cure(const Formula& formula, const unit::Dimension& wanted);

/// Reads "EXPR", "EXPR in UNIT" or {signal: ..., label: ...}.
std::optional<Series> read_series(const yaml::Node& node, const SymbolTable& names,
                                  const std::string& subject, yaml::Faults& faults);

}  // namespace stepwire::query
