#include "engine/view/plot/gather.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/query/number.hpp"

namespace stepwire::plot {
namespace {

std::vector<double> drawn_values(const query::Series& series, const record::Recording& recording) {
  std::vector<double> values = query::evaluate(series.formula, recording);
  for (double& value : values) value = series.unit.from_si(value);
  return values;
}

/// Returns the key of a channel in its panel: x, y, color, ...
std::string key_of(const Panel& panel, const query::Series* channel) {
  for (const auto& [key, list] : panel.series)
    for (const query::Series& series : list)
      if (&series == channel) return key;
  return {};
}

double shown_width(const AxisOptions& axis) {
  return axis.range ? (*axis.range)[1] - (*axis.range)[0] : std::numeric_limits<double>::infinity();
}

/// Selected rows, with the values that determine their curve.
struct FoundRows {
  std::vector<std::vector<double>> columns;
  std::vector<double> by;
  std::vector<bool> drawn;
  std::vector<bool> first;  ///< true for the first row of a run
};

/// Removes rows with a non-finite column, and those not above zero along a logarithmic axis.
void drop_missing(FoundRows& found, const std::vector<const AxisOptions*>& axes) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double least = axes[i]->log ? 0.0 : -std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < found.drawn.size(); ++row) {
      const double value = found.columns[i][row];
      found.drawn[row] = found.drawn[row] && std::isfinite(value) && value > least;
    }
  }
}

FoundRows find_rows(const Panel& panel, const record::Recording& recording,
                    const std::vector<const query::Series*>& channels) {
  const std::size_t rows = recording.table.rows();
  FoundRows found;
  for (const query::Series* channel : channels) found.columns.push_back(drawn_values(*channel, recording));
  const query::Series* by = panel.find("by");
  found.by = by == nullptr ? std::vector<double>(rows, 0.0) : drawn_values(*by, recording);
  for (const double value : found.by) found.drawn.push_back(std::isfinite(value));
  if (panel.where) {
    const auto where = query::evaluate(*panel.where, recording);
    for (std::size_t row = 0; row < rows; ++row)
      found.drawn[row] = where[row] != 0.0 && !std::isnan(where[row]);
  }
  found.first.assign(rows, false);
  for (const std::size_t start : recording.starts)
    if (start < rows) found.first[start] = true;
  return found;
}

/// Keeps only the last drawn row of each run.
void keep_final_rows(FoundRows& found) {
  bool taken = false;
  for (std::size_t row = found.drawn.size(); row-- > 0;) {
    const bool drawn = found.drawn[row] && !taken;
    found.drawn[row] = drawn;
    taken = (taken || drawn) && !found.first[row];
  }
}

std::size_t group_of(double value, const std::vector<double>& groups) {
  return static_cast<std::size_t>(std::lower_bound(groups.begin(), groups.end(), value) - groups.begin());
}

std::vector<double> find_groups(const FoundRows& found) {
  std::vector<double> groups;
  for (std::size_t row = 0; row < found.by.size(); ++row)
    if (found.drawn[row]) groups.push_back(found.by[row]);
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  return groups;
}

void append(geometry::Curve& curve, const FoundRows& found, std::size_t row) {
  for (std::size_t i = 0; i < found.columns.size(); ++i) curve.columns[i].push_back(found.columns[i][row]);
}

geometry::Curve empty_curve(const FoundRows& found, std::size_t group) {
  return {std::vector<std::vector<double>>(found.columns.size()), group};
}

std::vector<geometry::Curve> one_for_each_group(const FoundRows& found, const std::vector<double>& groups) {
  std::vector<geometry::Curve> curves;
  for (std::size_t group = 0; group < groups.size(); ++group) curves.push_back(empty_curve(found, group));
  for (std::size_t row = 0; row < found.drawn.size(); ++row)
    if (found.drawn[row]) append(curves[group_of(found.by[row], groups)], found, row);
  return curves;
}

std::vector<geometry::Curve> one_for_each_stretch(const FoundRows& found, const std::vector<double>& groups) {
  std::vector<geometry::Curve> curves;
  bool open = false;
  for (std::size_t row = 0; row < found.drawn.size(); ++row) {
    if (found.first[row] || (row > 0 && found.by[row] != found.by[row - 1])) open = false;
    if (found.drawn[row]) {
      if (!open) curves.push_back(empty_curve(found, group_of(found.by[row], groups)));
      append(curves.back(), found, row);
    }
    open = found.drawn[row];
  }
  return curves;
}

geometry::Curves curves_of(const Panel& panel, FoundRows found, const std::vector<const AxisOptions*>& axes) {
  drop_missing(found, axes);
  if (panel.final_rows) keep_final_rows(found);
  geometry::Curves result;
  result.logarithmic = panel.x.log || panel.y.log;
  for (const AxisOptions* axis : axes) result.shown.push_back(shown_width(*axis));
  result.groups = find_groups(found);
  result.curves = panel.final_rows ? one_for_each_group(found, result.groups)
                                   : one_for_each_stretch(found, result.groups);
  return result;
}

}  // namespace

std::vector<std::string> labels_of(const query::Series& by, const std::vector<double>& groups,
                                   const record::Recording& recording, bool named) {
  std::vector<std::string> labels;
  for (const double group : groups) {
    std::string label = query::short_number(group);
    if (!by.unit_text.empty() && by.unit_text != "1") label += " " + by.unit_text;
    if (by.label != by.formula.text)
      label = by.label + " " + label;
    else if (named)
      label = by.label + " = " + label;
    for (const auto& words : recording.categories)
      if (by.formula.text == words.column && group >= 0.0 && group < static_cast<double>(words.texts.size()))
        label = words.texts[static_cast<std::size_t>(group)];
    labels.push_back(label);
  }
  return labels;
}

geometry::Curves gather(const Panel& panel, const record::Recording& recording,
                        const std::vector<const query::Series*>& channels) {
  std::vector<const AxisOptions*> axes;
  for (const query::Series* channel : channels) axes.push_back(&panel.axis(key_of(panel, channel)));
  geometry::Curves result = curves_of(panel, find_rows(panel, recording, channels), axes);
  if (const query::Series* by = panel.find("by")) {
    result.labels = labels_of(*by, result.groups, recording);
    result.legends = labels_of(*by, result.groups, recording, true);
  }
  return result;
}

geometry::Curves curves_of(const Panel& panel, std::vector<std::vector<double>> columns) {
  const std::size_t rows = columns.front().size();
  std::vector<const AxisOptions*> axes{&panel.x};
  axes.resize(columns.size(), &panel.y);
  return curves_of(panel,
                   {std::move(columns), std::vector<double>(rows, 0.0), std::vector<bool>(rows, true),
                    std::vector<bool>(rows, false)},
                   axes);
}

void show_as_written(query::Series& swept, const query::SymbolTable& names) {
  const query::RecordedName* name = names.find(swept.formula.text);
  const auto unit = name ? unit::parse_unit(name->unit) : std::nullopt;
  const auto& dimension = swept.formula.dimension;
  if (!unit || name->unit.empty() || !dimension || unit->dimension != *dimension ||
      swept.unit_text != unit::si_name(*dimension))
    return;
  swept.unit = *unit;
  swept.unit_text = name->unit;
}

}  // namespace stepwire::plot
