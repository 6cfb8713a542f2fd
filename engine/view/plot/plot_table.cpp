#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/drawn.hpp"
#include "engine/view/plot/plot_kind.hpp"
#include "engine/view/plot/table_rows.hpp"

namespace stepwire::plot {
namespace {

/// Reads a table of a study.
PanelContent read_named_table(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  const auto fault = [&](const yaml::Mark& mark, const yaml::Message& message) {
    faults.add({{names.file, mark}, "figure.of", message, {}});
    return PanelContent{};
  };
  std::vector<std::string> all;
  for (const query::NamedTable& one : names.tables) all.push_back(one.name);
  const yaml::Node* of = node.find("of");
  if (!of)
    return fault(node.mark,
                 fmt::format("a plot 'table' needs 'rows' with 'headings', or in a file with a study 'of', "
                             "the name of a table: {}",
                             fmt::join(all, ", ")));
  const auto found = std::find(all.begin(), all.end(), of->text);
  if (all.empty()) return fault(of->mark, "this file makes no tables; one with a section 'study' does");
  if (found == all.end())
    return fault(of->mark, fmt::format("there is no table '{}'", of->text) +
                               yaml::nearest_or_all(of->text, all, "there are"));
  const yaml::Node* title = node.find("title");
  return [table = names.tables[static_cast<std::size_t>(found - all.begin())].table,
          title = title ? title->text : ""](std::span<const record::Recording>) {
    text::TextTable shown = *table;
    if (!title.empty()) shown.title = title;
    return shown;
  };
}

PanelContent read_table_plot(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  if (!node.find("rows") && !node.find("headings")) return read_named_table(node, names, faults);
  if (const yaml::Node* of = node.find("of"))
    faults.add({{names.file, of->mark}, "figure.of", "a table has 'of' or 'rows', not both", {}});
  return [rows = read_table_rows(node, names, faults)](std::span<const record::Recording> recordings) {
    return filled(rows, recordings);
  };
}

/// Returns each cell by the name of its row and its heading, "thesis.compressed_length"; by their numbers if
/// these have no letters.
std::vector<query::NamedFormula> cells_of(const yaml::Node& node, const query::SymbolTable& names) {
  std::vector<query::NamedFormula> cells;
  if (!node.find("rows") || !node.find("headings")) return cells;
  yaml::Faults told;  // already reported when the content was read
  const TableRows table = read_table_rows(node, names, told);
  for (std::size_t row = 0; row < table.lines.size(); ++row)
    for (std::size_t column = 1; column <= table.lines[row].cells.size(); ++column) {
      const std::string heading = column < table.columns.size() ? table.columns[column] : "";
      cells.push_back({fmt::format("{}.{}", name_of_label(table.lines[row].name, row + 1),
                                   name_of_label(heading, column)),
                       table.lines[row].cells[column - 1].formula.text});
    }
  return cells;
}

}  // namespace

PlotKind table_plot() {
  PlotKind kind;
  kind.name = "table";
  kind.doc = "a table of expressions, or one that a study makes, with its notes";
  kind.options = {
      {"of",
       "which table: errors by condition, or by condition and subject; the analyses of variance; pairs "
       "of conditions within subjects; means and significance beside the published ones; or these over all "
       "experiments; or what is found by `sensitivity`",
       yaml::form::word({"errors", "subjects", "anova", "anova_with_subject", "repeated_measures",
                         "intervals", "comparisons", "effect_sizes", "power", "assumptions", "means",
                         "significance", "experiments", "experiments_significance", "sensitivity"})}};
  for (yaml::Key key : table_rows_form().of) {
    key.required = false;  // `of` may replace them
    kind.options.push_back(described_key(key));
  }
  kind.plane = false;
  kind.read = read_table_plot;
  kind.shown = cells_of;
  kind.reads_rows = [](const yaml::Node& node) { return node.find("of") == nullptr; };
  return kind;
}

}  // namespace stepwire::plot
