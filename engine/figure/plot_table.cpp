#include <fmt/format.h>

#include <algorithm>

#include "engine/figure/number.hpp"
#include "engine/figure/plot_kind.hpp"

namespace stepwire {
namespace {

Picture read_table_plot(const Node& node, const Names& names, Faults& faults) {
  const auto fault = [&](const Mark& mark, const std::string& message) {
    faults.add({{names.file, mark}, "figure.of", message, {}});
    return Picture{};
  };
  std::vector<std::string> all;
  for (const NamedTable& one : names.tables) all.push_back(one.name);
  const Node* of = node.find("of");
  if (!of)
    return fault(node.mark,
                 fmt::format("a plot 'table' needs 'of', the name of a table: {}", fmt::join(all, ", ")));
  const auto found = std::find(all.begin(), all.end(), of->text);
  if (all.empty()) return fault(of->mark, "this file makes no tables; one with a section 'study' does");
  if (found == all.end())
    return fault(of->mark, fmt::format("there is no table '{}'{}", of->text,
                                       nearest_or_all(of->text, all, "there are")));
  const Node* title = node.find("title");
  return [table = names.tables[static_cast<std::size_t>(found - all.begin())].table,
          title = title ? title->text : ""](std::span<const Recording>) {
    TextTable shown = *table;
    if (!title.empty()) shown.title = title;
    return draw(shown);
  };
}

}  // namespace

PlotKind table_plot() {
  PlotKind kind;
  kind.name = "table";
  kind.doc = "a table that a study makes, with its notes";
  kind.options = {
      {"of",
       "which table: errors by condition, or by condition and subject; the analyses of variance; or "
       "means and significance beside the thesis'",
       "",
       false,
       {"errors", "subjects", "anova", "anova_with_subject", "repeated_measures", "means", "significance"}}};
  kind.plane = false;
  kind.read = read_table_plot;
  return kind;
}

}  // namespace stepwire
