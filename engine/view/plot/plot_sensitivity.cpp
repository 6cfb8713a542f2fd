#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

constexpr double parameter_height = 44.0, room_around = 130.0;  // [pixels]
constexpr double bar_width = 0.34;                              // [rows]

/// Measure that determines the order, and a second one beside it.
struct Measures {
  const char *first, *second;
  const char *first_legend, *second_legend;
  const char* axis;  ///< prefix of the name of the outcome
};
constexpr Measures all_measures[] = {
    {".total.", ".first.", "total index", "first index", "part of the variance of "},
    {".size.", ".deviation.", "mean size of the effect", "deviation of the effect", "effect on "},
    {".partial.", ".rank.", "partial rank correlation", "rank correlation", "correlation with "}};

/// Returns the measures whose first one is a column of this name; nullptr without one.
const Measures* measures_of(const std::string& column) {
  const auto found = std::ranges::find_if(
      all_measures, [&](const Measures& one) { return column.find(one.first) != std::string::npos; });
  return found == std::end(all_measures) ? nullptr : found;
}

/// Parameter with two numbers, each with its interval.
struct SensitivityBar {
  std::string parameter;
  double value[2], low[2], high[2];
};

/// Returns the outcomes with known sensitivity.
std::vector<std::string> outcomes_of(const query::SymbolTable& names, std::string& column) {
  std::vector<std::string> all;
  for (const query::RecordedName& one : names.columns) {
    const Measures* measures = measures_of(one.name);
    if (!measures || one.name.ends_with(".low") || one.name.ends_with(".high")) continue;
    const std::string name = one.name.substr(0, one.name.find(measures->first));
    if (name == column) {
      column = one.name;
      return {};
    }
    if (std::ranges::find(all, name) == all.end()) all.push_back(name);
  }
  return all;
}

void read_outcome(Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
  const std::string name = read.text(node);
  std::string column = name;
  const std::vector<std::string> all = outcomes_of(read.names, column);
  if (column == name)
    return read.fault(node.mark, fmt::format("there is no outcome '{}'", name) +
                                     yaml::nearest_or_all(name, all, "the section 'sensitivity' has"));
  yaml::Node of = node;
  of.text = column;
  if (auto series = read.series(of)) panel.series["of"] = {std::move(*series)};
}

std::vector<SensitivityBar> sensitivities_of(const std::string& outcome, const Measures& measures,
                                             const table::Table& table) {
  const auto number = [&](const std::string& name) {
    const table::Column* column = table.find(name);
    return column && !column->values.empty() ? column->values.front() : query::nothing;
  };
  std::vector<SensitivityBar> bars;
  const std::string begin = outcome + measures.first;
  for (const table::Column& column : table.columns) {
    if (!column.name.starts_with(begin) || column.name.ends_with(".low") || column.name.ends_with(".high"))
      continue;
    SensitivityBar bar{column.name.substr(begin.size()), {}, {}, {}};
    for (const std::size_t i : {0, 1}) {
      const std::string name = outcome + (i == 0 ? measures.first : measures.second) + bar.parameter;
      bar.value[i] = number(name);
      bar.low[i] = number(name + ".low");
      bar.high[i] = number(name + ".high");
    }
    if (std::isfinite(bar.value[0])) bars.push_back(std::move(bar));
  }
  std::ranges::stable_sort(bars, std::ranges::greater{},
                           [](const SensitivityBar& bar) { return std::abs(bar.value[0]); });
  return bars;
}

void name_parameters(const std::vector<SensitivityBar>& bars, const Panel& panel, PlotAxis& axis) {
  axis = {.range = {{static_cast<double>(bars.size()) - 0.4, -0.6}},
          .line = false,
          .tick_marks = false,
          .grid = false};
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const auto given = panel.names.find(bars[i].parameter);
    axis.named_ticks.push_back(
        {static_cast<double>(i), given == panel.names.end() ? bars[i].parameter : given->second});
  }
}

/// Draws a bar and its interval for each parameter, the first measure above the second.
void draw_measure(const std::vector<SensitivityBar>& bars, std::size_t which, const char* legend,
                  geometry::Extent& extent, PlotBuilder& plot) {
  RectanglesMark boxes{.color = curve_color(which), .legend = legend};
  LineMark intervals{{}, {"#333333", 1.4}};
  for (std::size_t row = 0; row < bars.size(); ++row) {
    const SensitivityBar& bar = bars[row];
    const double top = static_cast<double>(row) + (which == 0 ? -bar_width : 0.0), bottom = top + bar_width;
    if (!std::isfinite(bar.value[which])) continue;
    boxes.x_low.push_back(std::min(0.0, bar.value[which]));
    boxes.x_high.push_back(std::max(0.0, bar.value[which]));
    boxes.y_low.push_back(top);
    boxes.y_high.push_back(bottom);
    extent.add(bar.value[which]);
    if (!std::isfinite(bar.low[which]) || !std::isfinite(bar.high[which])) continue;
    const double middle = 0.5 * (top + bottom);
    intervals.curves.push_back({{bar.low[which], bar.high[which]}, {middle, middle}, {}, {}});
    extent.add(bar.low[which]);
    extent.add(bar.high[which]);
  }
  plot.add(std::move(boxes));
  plot.add(std::move(intervals));
}

void draw_sensitivity(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const query::Series& of = *panel.find("of");
  const std::string& column = of.formula.columns.front();
  const Measures& measures = *measures_of(column);
  const std::string outcome = column.substr(0, column.find(measures.first));
  const std::vector<SensitivityBar> bars =
      sensitivities_of(outcome, measures, recording_of(panel, recordings).table);
  plot.label("x", of);
  plot.spec.x.label = panel.x.label.empty() ? measures.axis + outcome : panel.x.label;
  if (bars.empty()) return;
  geometry::Extent extent{0.0, 0.0};
  draw_measure(bars, 0, measures.first_legend, extent, plot);
  draw_measure(bars, 1, measures.second_legend, extent, plot);
  plot.range("x", extent.padded(0.05));
  name_parameters(bars, panel, plot.spec.y);
  plot.height = room_around + parameter_height * static_cast<double>(bars.size());
}

}  // namespace

PlotKind sensitivity_plot() {
  PlotKind kind{
      "sensitivity",
      "which drawn parameter matters how much for an outcome of the section `sensitivity`, the one that "
      "matters most on top; the lines are intervals",
      {},
      {yaml::needed(PanelKey{"of", "an outcome, by its name", yaml::form::string(), read_outcome}),
       {"names", "what the parameters are called: {k: stiffness}", yaml::form::names(yaml::form::text(), 1),
        [](Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
          for (const yaml::Entry& entry : node.entries)
            panel.names[entry.key] = yaml::below(read, entry.key).text(entry.value);
        }}},
      false,
      draw_sensitivity};
  kind.lacks = {KeyNeeds::choice, KeyNeeds::rows, KeyNeeds::legend, KeyNeeds::up, KeyNeeds::color_bar};
  return kind;
}

}  // namespace stepwire::plot
