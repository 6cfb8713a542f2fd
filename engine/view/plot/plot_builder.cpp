#include "engine/view/plot/plot_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/analyse/query/number.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::plot {
namespace {

const std::vector<ColorStop>& rainbow() {
  static const std::vector<ColorStop> stops{{0.0, "#3b46b3"},  {0.15, "#4681f7"}, {0.28, "#2fb2f4"},
                                            {0.4, "#35dcb0"},  {0.52, "#9ae657"}, {0.64, "#e3d939"},
                                            {0.76, "#faa339"}, {0.87, "#ee5a1d"}, {1.0, "#b41203"}};
  return stops;
}

/// Returns labels at 2 and 5 for a logarithmic axis of less than two decades, in addition to the powers of
/// ten.
std::vector<double> between_decades(const geometry::Extent& shown) {
  std::vector<double> labels;
  if (shown.high > 100.0 * shown.low) return labels;
  for (double decade = std::pow(10.0, std::floor(std::log10(shown.low))); decade <= shown.high;
       decade *= 10.0)
    for (const double label : {2.0 * decade, 5.0 * decade})
      if (label >= shown.low && label <= shown.high) labels.push_back(label);
  return labels;
}

/// Largest legend above the axes; a longer one is beside them. A legend never covers a curve.
constexpr std::size_t max_above = 4;

PlotSpec::Legend legend_of(const std::vector<PlotMark>& marks) {
  const auto has_legend = [](const auto& mark) {
    if constexpr (requires { mark.legend; }) return !mark.legend.empty();
    return false;
  };
  const auto entries =
      std::ranges::count_if(marks, [&](const PlotMark& mark) { return std::visit(has_legend, mark); });
  if (entries == 0) return PlotSpec::Legend::none;
  return entries <= static_cast<std::ptrdiff_t>(max_above) ? PlotSpec::Legend::above
                                                           : PlotSpec::Legend::beside;
}

bool is_finite(const std::vector<double>& x, const std::vector<double>& y) {
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
    if (std::isfinite(x[i]) && std::isfinite(y[i])) return true;
  return false;
}

/// True for a mark of which nothing is seen: without a finite point.
bool is_blank(const PlotMark& mark) {
  const auto has_finite = [](const MarkRows& rows) { return is_finite(rows.x, rows.y); };
  if (const auto* line = std::get_if<LineMark>(&mark)) return std::ranges::none_of(line->curves, has_finite);
  if (const auto* points = std::get_if<PointsMark>(&mark)) return !has_finite(points->rows);
  if (const auto* band = std::get_if<BandMark>(&mark)) return !is_finite(band->low, band->high);
  if (const auto* image = std::get_if<ImageMark>(&mark)) return !is_finite(image->values, image->values);
  return false;
}

bool is_one_point(const MarkRows& rows) {
  const auto is_constant = [](const std::vector<double>& values) {
    return std::ranges::all_of(values, [&](double value) { return value == values.front(); });
  };
  return !rows.x.empty() && is_constant(rows.x) && is_constant(rows.y) && is_constant(rows.z);
}

/// Draws a line whose curves are one point each as dots, since a line of no length is not seen.
void show_points(LineMark& line) {
  if (line.dots > 0.0 || !std::ranges::all_of(line.curves, is_one_point)) return;
  line.dots = dot_size;
  for (MarkRows& rows : line.curves)
    for (std::vector<double>* column : {&rows.x, &rows.y, &rows.z, &rows.value})
      if (column->size() > 1) column->erase(column->begin() + 1, column->end());
}

MarkRows rows_of_columns(const geometry::Curve& curve, bool space) {
  const std::size_t plain = space ? 3 : 2;
  MarkRows rows{curve.columns.at(0), curve.columns.at(1), {}, {}};
  if (space) rows.z = curve.columns.at(2);
  if (curve.columns.size() > plain) rows.value = curve.columns[plain];
  return rows;
}

}  // namespace

PlotAxis& PlotBuilder::axis(const std::string& name) {
  if (name == "x") return spec.x;
  if (name == "y") return spec.y;
  std::optional<PlotAxis>& axis = name == "z" ? spec.z : spec.color;
  if (name == "color" && !axis) spec.palette = rainbow();
  if (!axis) axis.emplace();
  return *axis;
}

void PlotBuilder::cover(const std::vector<geometry::Curve>& curves) {
  for (const geometry::Curve& curve : curves) {
    for (const double value : curve.columns.at(0)) x.add(value);
    for (const double value : curve.columns.at(1)) y.add(value);
  }
}

void PlotBuilder::label(const std::string& name, const query::Series& series) {
  const std::string& given = panel_.axis(name).label;
  PlotAxis& named = axis(name);
  named.label = given.empty() ? series.label : given;
  named.unit = series.unit_text.empty() ? "" : query::printed_unit(series.unit_text);
}

void PlotBuilder::range(const std::string& name, const geometry::Extent& extent) {
  const AxisOptions& options = panel_.axis(name);
  const geometry::Extent shown =
      options.range ? geometry::Extent{(*options.range)[0], (*options.range)[1]} : extent;
  PlotAxis& set = axis(name);
  set.log = options.log;
  if (set.log && shown.low <= 0.0) return set.range.reset();
  set.range = {query::rounded(shown.low, 9), query::rounded(shown.high, 9)};
  if (set.log) set.more_ticks = between_decades(shown);
}

void PlotBuilder::color_bar(const query::Series& series, const geometry::Extent& extent) {
  const bool flat = extent.empty() || !(extent.high > extent.low);
  range("color", flat ? extent.padded(0.0) : extent);
  label("color", series);
}

void PlotBuilder::plane(double room) {
  for (const std::string name : {"x", "y"}) {
    geometry::Extent& extent = name == "x" ? x : y;
    const auto& given = panel_.axis(name).range;
    extent = given ? geometry::Extent{(*given)[0], (*given)[1]} : extent.padded(room);
    range(name, extent);
  }
}

void PlotBuilder::judge_marks() {
  is_blank_ = std::ranges::all_of(spec.marks, is_blank);
  for (PlotMark& mark : spec.marks)
    if (auto* line = std::get_if<LineMark>(&mark)) show_points(*line);
}

PlotSpec PlotBuilder::finished() {
  spec.title = panel_.title;
  spec.equal = panel_.equal;
  for (const auto& [axis, given] : {std::pair{&spec.x, &panel_.x.label}, {&spec.y, &panel_.y.label}})
    if (!given->empty()) axis->label = *given;
  spec.legend = legend_of(spec.marks);
  const bool is_empty = spec.marks.empty() || std::ranges::all_of(spec.marks, is_blank);
  if (is_empty) {
    spec.z.reset();
    spec.view.reset();
    for (PlotAxis* one : {&spec.x, &spec.y})
      *one = {.label = one->label, .unit = one->unit, .range = {{0.0, 1.0}}};
  }
  if (is_empty || is_blank_)
    spec.texts.push_back({.text = blank_text(), .x = 0.5, .y = 0.5, .in_frame = true, .color = "#555555"});
  return std::move(spec);
}

/// Returns the text in place of what the plot would show.
std::string PlotBuilder::blank_text() const {
  if (!spec.marks.empty()) return "no finite numbers to draw";
  return panel_.where ? fmt::format("'{}' selects no rows", panel_.where->text) : "no rows to draw";
}

double PlotBuilder::suitable_height() const {
  if (height > 0.0) return height;
  if (spec.view) return 0.8 * width;
  if (!panel_.equal || x.empty() || y.empty()) return 0.66 * width;
  const double ratio = y.width() / x.width();
  return std::clamp((width - room_across) * ratio + room_up, 0.3 * width, 1.2 * width);
}

MarkRows plane_rows(const geometry::Curve& curve) {
  return rows_of_columns(curve, false);
}

std::vector<MarkRows> plane_rows(const std::vector<geometry::Curve>& curves) {
  std::vector<MarkRows> rows;
  for (const geometry::Curve& curve : curves) rows.push_back(rows_of_columns(curve, false));
  return rows;
}

std::vector<MarkRows> space_rows(const std::vector<geometry::Curve>& curves) {
  std::vector<MarkRows> rows;
  for (const geometry::Curve& curve : curves) rows.push_back(rows_of_columns(curve, true));
  return rows;
}

std::string curve_color(std::size_t index) {
  static const std::array<const char*, 8> colors{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                 "#E69F00", "#56B4E9", "#4D4D4D", "#8C6D1F"};
  return colors[index % colors.size()];
}

}  // namespace stepwire::plot
