#include "engine/view/plot/overlay.hpp"

#include <fmt/format.h>

#include "engine/base/yaml/message.hpp"
#include "engine/view/plot/along_axis.hpp"

namespace stepwire::plot {

std::vector<geometry::Curve> overlay_rows(const std::optional<query::Formula>& where,
                                          const record::Recording& recording,
                                          const std::vector<const query::Series*>& channels) {
  Panel rows;
  rows.where = where;
  return gather(rows, recording, channels).curves;
}

std::optional<query::Series> read_coordinate(const yaml::Node& node, const std::string& axis,
                                             const Panel& panel, const query::NamesReading& read) {
  auto formula = read.formula(node);
  const query::Series* drawn = panel.find(axis);
  if (!formula || !drawn) return std::nullopt;
  const auto &ours = formula->dimension, &theirs = drawn->formula.dimension;
  if (ours && theirs && *ours != *theirs)
    read.fault(node.mark,
               yaml::fault_text("'{}' is in {}, but '{}' in {}; both are drawn along {}", formula->text,
                                unit::si_name(*ours), drawn->formula.text, unit::si_name(*theirs), axis));
  else if (auto wrong = fault_along({*formula, {}, ours ? unit::si_name(*ours) : "", formula->text}, *drawn))
    read.fault(node.mark, std::move(*wrong));
  return query::Series{*formula, drawn->unit, drawn->unit_text, formula->text};
}

}  // namespace stepwire::plot
