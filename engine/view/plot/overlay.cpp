#include "engine/view/plot/overlay.hpp"

#include <fmt/format.h>

#include "engine/base/yaml/fault_text.hpp"

namespace stepwire {

std::vector<Curve> overlay_rows(const std::optional<Formula>& where, const Recording& recording,
                                const std::vector<const Series*>& channels) {
  Panel rows;
  rows.where = where;
  return gather(rows, recording, channels).curves;
}

std::optional<Series> read_coordinate(const Node& node, const std::string& axis, const Panel& panel,
                                      const NamesReading& read) {
  auto formula = read.formula(node);
  const Series* drawn = panel.find(axis);
  if (!formula || !drawn) return std::nullopt;
  const auto &ours = formula->dimension, &theirs = drawn->formula.dimension;
  if (ours && theirs && *ours != *theirs)
    read.fault(node.mark, fault_text("'{}' is in {}, but '{}' in {}; both are drawn along {}", formula->text,
                                     si_name(*ours), drawn->formula.text, si_name(*theirs), axis));
  return Series{*formula, drawn->unit, drawn->unit_text, formula->text};
}

}  // namespace stepwire
