#include "engine/figure/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/number.hpp"

namespace stepwire {
namespace {

std::vector<double> drawn_values(const Series& series, const Recording& recording) {
  std::vector<double> values = evaluate(series.formula, recording);
  for (double& value : values) value = series.unit.from_si(value);
  return values;
}

/// Rows as they are found, with what decides about their curve.
struct Source {
  std::vector<std::vector<double>> columns;
  std::vector<double> by;
  std::vector<bool> drawn;
  std::vector<bool> first;  ///< of a run
};

Source read_source(const Panel& panel, const Recording& recording,
                   const std::vector<const Series*>& channels) {
  const std::size_t rows = recording.table.rows();
  Source source;
  for (const Series* channel : channels) source.columns.push_back(drawn_values(*channel, recording));
  const Series* by = panel.find("by");
  source.by = by == nullptr ? std::vector<double>(rows, 0.0) : drawn_values(*by, recording);
  for (const double value : source.by) source.drawn.push_back(std::isfinite(value));
  if (panel.where) {
    const auto where = evaluate(*panel.where, recording);
    for (std::size_t row = 0; row < rows; ++row)
      source.drawn[row] = where[row] != 0.0 && !std::isnan(where[row]);
  }
  for (const auto& column : source.columns)
    for (std::size_t row = 0; row < rows; ++row)
      source.drawn[row] = source.drawn[row] && std::isfinite(column[row]);
  source.first.assign(rows, false);
  for (const std::size_t start : recording.starts)
    if (start < rows) source.first[start] = true;
  return source;
}

/// Leaves only the last drawn row of each run.
void keep_final_rows(Source& source) {
  bool taken = false;
  for (std::size_t row = source.drawn.size(); row-- > 0;) {
    const bool drawn = source.drawn[row] && !taken;
    source.drawn[row] = drawn;
    taken = (taken || drawn) && !source.first[row];
  }
}

std::size_t group_of(double value, const std::vector<double>& groups) {
  return static_cast<std::size_t>(std::lower_bound(groups.begin(), groups.end(), value) - groups.begin());
}

std::vector<double> find_groups(const Source& source) {
  std::vector<double> groups;
  for (std::size_t row = 0; row < source.by.size(); ++row)
    if (source.drawn[row]) groups.push_back(source.by[row]);
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  return groups;
}

void append(Curve& curve, const Source& source, std::size_t row) {
  for (std::size_t i = 0; i < source.columns.size(); ++i) curve.columns[i].push_back(source.columns[i][row]);
}

Curve empty_curve(const Source& source, std::size_t group) {
  return {std::vector<std::vector<double>>(source.columns.size()), group};
}

std::vector<Curve> one_for_each_group(const Source& source, const std::vector<double>& groups) {
  std::vector<Curve> curves;
  for (std::size_t group = 0; group < groups.size(); ++group) curves.push_back(empty_curve(source, group));
  for (std::size_t row = 0; row < source.drawn.size(); ++row)
    if (source.drawn[row]) append(curves[group_of(source.by[row], groups)], source, row);
  return curves;
}

std::vector<Curve> one_for_each_stretch(const Source& source, const std::vector<double>& groups) {
  std::vector<Curve> curves;
  bool open = false;
  for (std::size_t row = 0; row < source.drawn.size(); ++row) {
    if (source.first[row] || (row > 0 && source.by[row] != source.by[row - 1])) open = false;
    if (source.drawn[row]) {
      if (!open) curves.push_back(empty_curve(source, group_of(source.by[row], groups)));
      append(curves.back(), source, row);
    }
    open = source.drawn[row];
  }
  return curves;
}

std::vector<std::string> labels_of(const Series& by, const std::vector<double>& groups,
                                   const Recording& recording) {
  std::vector<std::string> labels;
  for (const double group : groups) {
    std::string label = short_number(group);
    if (!by.unit_text.empty() && by.unit_text != "1") label += " " + by.unit_text;
    if (by.label != by.formula.text) label = by.label + " " + label;
    for (const auto& words : recording.words)
      if (by.formula.text == words.column && group >= 0.0 && group < static_cast<double>(words.texts.size()))
        label = words.texts[static_cast<std::size_t>(group)];
    labels.push_back(label);
  }
  return labels;
}

/// Rows of a stretch that must stay: both ends, and the extremes of each column.
void keep_extremes(const Curve& curve, std::size_t begin, std::size_t end, std::vector<std::size_t>& rows) {
  std::vector<std::size_t> kept{begin};
  for (const auto& column : curve.columns) {
    const auto from = column.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto to = column.begin() + static_cast<std::ptrdiff_t>(end);
    const auto [low, high] = std::minmax_element(from, to);
    kept.push_back(static_cast<std::size_t>(low - column.begin()));
    kept.push_back(static_cast<std::size_t>(high - column.begin()));
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  rows.insert(rows.end(), kept.begin(), kept.end());
}

}  // namespace

Curves gather(const Panel& panel, const Recording& recording, const std::vector<const Series*>& channels) {
  Source source = read_source(panel, recording, channels);
  if (panel.final_rows) keep_final_rows(source);
  Curves result;
  result.groups = find_groups(source);
  result.curves = panel.final_rows ? one_for_each_group(source, result.groups)
                                   : one_for_each_stretch(source, result.groups);
  if (const Series* by = panel.find("by")) result.labels = labels_of(*by, result.groups, recording);
  return result;
}

Curve decimate(const Curve& curve, std::size_t limit) {
  const std::size_t rows = curve.size();
  if (rows <= limit) return curve;
  const std::size_t stretches = std::max<std::size_t>(1, limit / (2 * curve.columns.size() + 1));
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < stretches; ++i)
    keep_extremes(curve, i * rows / stretches, (i + 1) * rows / stretches, kept);
  if (kept.back() != rows - 1) kept.push_back(rows - 1);
  Curve result{std::vector<std::vector<double>>(curve.columns.size()), curve.group};
  for (std::size_t i = 0; i < curve.columns.size(); ++i)
    for (const std::size_t row : kept) result.columns[i].push_back(curve.columns[i][row]);
  return result;
}

}  // namespace stepwire
