#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/text/text_table.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/model/block/outline.hpp"

namespace stepwire::drawing {
class DiagramView;
}

namespace stepwire::scene {
struct Scene;
}

namespace stepwire::query {

/// Name of a recorded column in figures and claims.
struct RecordedName {
  std::string name;
  std::optional<unit::Dimension> dimension;  ///< Dimension of the unit; std::nullopt if unknown.
  std::optional<std::size_t>
      recording;  ///< Index of the recording with the column; std::nullopt: all (time, swept parameters).
  std::string column{};  ///< Column name in the table ("lag" for "lag.y"); empty if equal to `name`.
  std::vector<std::string> words{};  ///< Words for the numbers 0, 1, ...; empty for ordinary numbers.
  std::vector<double> values{};  ///< Values of a swept parameter with few of them, SI, ascending; else empty.
  std::string unit{};        ///< Unit in which the file writes the values of a swept parameter; else empty.
  std::string expression{};  ///< Expression that the name replaces in the text of the file; else empty.
  std::optional<double> zeros_if_kelvin{};  ///< Of a column without a known unit, see diagram::Diagram.
  bool is_ratio = false;  ///< True for a number that is no angle: decibels, a share, a damping ratio.
};

/// A parameter of the diagram, used in figures and claims as "$name".
struct KnownParameter {
  std::string name;
  double value = 0.0;  ///< Value in SI.
  std::optional<unit::Dimension> dimension{};
  std::string unit{};    ///< Unit as the file writes it; empty without one.
  std::string varies{};  ///< Refusal of a value that differs from run to run; empty for a constant.
};

/// A block with an outline that figures can draw.
struct NamedOutline {
  std::string name;
  Outline outline;
};

/// A table that figures can show. It is filled before they are drawn.
struct NamedTable {
  std::string name;
  std::shared_ptr<text::TextTable> table = std::make_shared<text::TextTable>();
};

/// A name for an expression.
struct NamedFormula {
  std::string name;
  std::string text;      ///< Text as in the file.
  std::string varies{};  ///< Refusal of a value that differs from run to run; empty for a constant.
};

/// All names that figures and claims of one diagram file may use.
struct SymbolTable {
  std::string file;  ///< File name in the places of faults.
  std::vector<RecordedName> columns;
  std::vector<KnownParameter> parameters{};
  std::vector<std::string> signals{};  ///< Signals that could be recorded, by their names in the diagram.
  std::string unknown{};               ///< Message text on an unknown name, for columns other than signals.
  const drawing::DiagramView* diagram = nullptr;  ///< Diagram view; nullptr if the diagram cannot be drawn.
  std::vector<NamedOutline> outlines{};
  std::vector<NamedTable> tables{};
  std::vector<NamedFormula> drawn{};            ///< Formulas that the figures draw, and numbers of blocks.
  std::shared_ptr<const scene::Scene> scene{};  ///< Scene of the file; nullptr without one.

  const RecordedName* find(std::string_view name) const;
  /// True for a signal that the file does not record.
  bool lacks(std::string_view name) const;
};

}  // namespace stepwire::query
