#include "engine/view/plot/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/number.hpp"

namespace stepwire {

std::vector<Curve> overlay_rows(const std::optional<Formula>& where, const Recording& recording,
                                const std::vector<const Series*>& channels) {
  Panel rows;
  rows.where = where;
  return gather(rows, recording, channels).curves;
}

std::optional<Series> read_coordinate(const Node& node, const std::string& axis, const Panel& panel,
                                      const Names& names, const std::string& subject, Faults& faults) {
  auto formula = read_formula(node, names, subject, faults);
  const Series* drawn = panel.find(axis);
  if (!formula || !drawn) return std::nullopt;
  const auto &ours = formula->dimension, &theirs = drawn->formula.dimension;
  if (ours && theirs && *ours != *theirs)
    faults.add({{names.file, node.mark},
                subject,
                fmt::format("'{}' is in {}, but '{}' in {}; both are drawn along {}", formula->text,
                            si_name(*ours), drawn->formula.text, si_name(*theirs), axis),
                {}});
  return Series{*formula, drawn->unit, drawn->unit_text, formula->text};
}

void check_keys(const Node& node, const std::vector<FigureKey>& rows, const std::string& owner,
                const Names& names, const std::string& subject, Faults& faults) {
  std::vector<std::string> known;
  for (const FigureKey& row : rows) known.push_back(row.name);
  for (const Entry& entry : node.entries)
    if (std::ranges::find(known, entry.key) == known.end())
      add_unknown_key(entry, known, owner, names, subject, faults);
}

}  // namespace stepwire
