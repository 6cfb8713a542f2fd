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

/// A name that figures and claims may use for a recorded column.
struct RecordedName {
  std::string name;
  std::optional<unit::Dimension> dimension;  ///< none where the unit is not known
  std::optional<std::size_t>
      recording;         ///< which recording has it; none: each has it (time, swept parameters)
  std::string column{};  ///< its name in the table where that differs ("lag" for "lag.y"); else empty
  std::vector<std::string> words{};  ///< that its numbers 0, 1, ... stand for; empty: they are numbers
  std::vector<double> values{};      ///< SI, of a swept parameter with few of them, ascending; else empty
  std::string unit{};  ///< in which the file writes the numbers of a swept parameter; else empty
};

/// A parameter of the diagram, used in figures and claims as "$name".
struct KnownParameter {
  std::string name;
  double value = 0.0;  ///< SI
  std::optional<unit::Dimension> dimension{};
};

/// A block whose outline figures may draw.
struct NamedOutline {
  std::string name;
  Outline outline;
};

/// A table that figures may show. It is filled in before they are drawn.
struct NamedTable {
  std::string name;
  std::shared_ptr<text::TextTable> table = std::make_shared<text::TextTable>();
};

/// A name that stands for an expression.
struct NamedFormula {
  std::string name;
  std::string text;  ///< as the file has it
};

/// All that the figures and claims of one diagram file may name.
struct SymbolTable {
  std::string file;  ///< for the places of faults
  std::vector<RecordedName> columns;
  std::vector<KnownParameter> parameters{};
  std::vector<std::string> signals{};  ///< what could be recorded, by the names that the diagram has for it
  std::string unknown{};               ///< said of a name that is no column, where columns are no records
  const drawing::DiagramView* diagram = nullptr;  ///< the diagram itself; null where it cannot be drawn
  std::vector<NamedOutline> outlines{};
  std::vector<NamedTable> tables{};
  std::vector<NamedFormula> drawn{};            ///< what the figures draw, and numbers of blocks
  std::shared_ptr<const scene::Scene> scene{};  ///< what the file shows; null where it has none

  const RecordedName* find(std::string_view name) const;
  /// Is it a signal that the file does not record?
  bool lacks(std::string_view name) const;
};

}  // namespace stepwire::query
