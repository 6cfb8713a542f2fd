#include <algorithm>
#include <cmath>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/claim/reduce.hpp"
#include "engine/analyse/claim/reduced_value.hpp"
#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

/// Counts the values in each of `count` bins of an extent.
RectanglesMark bins_of(const std::vector<double>& values, const geometry::Extent& extent, std::size_t count) {
  const double width = extent.width() / static_cast<double>(count);
  RectanglesMark bins{.color = curve_color(0), .edge = "#ffffff"};
  for (std::size_t i = 0; i < count; ++i) {
    bins.x_low.push_back(extent.low + static_cast<double>(i) * width);
    bins.x_high.push_back(extent.low + static_cast<double>(i + 1) * width);
  }
  bins.y_low.assign(count, 0.0);
  bins.y_high.assign(count, 0.0);
  for (const double value : values) {
    const auto bin = static_cast<std::size_t>(std::max(0.0, (value - extent.low) / width));
    bins.y_high[std::min(bin, count - 1)] += 1.0;
  }
  return bins;
}

/// Returns the form of a reduction of the rows of a run.
const yaml::Key& reduction_form() {
  static const yaml::Key form =
      yaml::form::word({"max", "min", "mean", "rms", "spread", "overshoot", "rise_time", "settling_time",
                        "peak_time", "iae", "steady_error"});
  return form;
}

void read_reduction(Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
  const auto word = read.word(node, reduction_form());
  if (!word) return;
  const auto& names = claim::reduction_names();
  panel.reads_all_rows = true;
  panel.options<HistogramOptions>().reduction =
      static_cast<std::size_t>(std::ranges::find(names, reduction_form().words[*word].word) - names.begin());
}

/// Returns the reduced value of each run with a selected row, in the unit of the reduction.
std::vector<double> reduced(const Panel& panel, const record::Recording& recording, const query::Series& x) {
  claim::Rows rows{query::evaluate(x.formula, recording), {}, {}, {}, recording.starts};
  if (const table::Column* time = recording.table.find("time")) rows.time = time->values;
  rows.selected.assign(rows.value.size(), true);
  const auto where = panel.where ? query::evaluate(*panel.where, recording) : std::vector<double>{};
  for (std::size_t i = 0; i < where.size(); ++i) rows.selected[i] = where[i] != 0.0 && !std::isnan(where[i]);
  std::vector<double> values;
  for (std::size_t run = 0; run < rows.starts.size(); ++run) {
    const claim::Rows one = rows.of_run(run);
    if (std::ranges::find(one.selected, true) == one.selected.end()) continue;
    values.push_back(
        claim::reduce(static_cast<claim::Reduction>(*panel.options<HistogramOptions>().reduction), one));
  }
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  return values;
}

/// Draws the reduced values in the unit that follows from that of x.
void draw_reduced(const Panel& panel, const record::Recording& recording, const query::Series& x,
                  PlotBuilder& plot) {
  const std::string unit_text = claim::reduced_unit(
      static_cast<claim::Reduction>(*panel.options<HistogramOptions>().reduction), x.unit_text);
  const unit::Unit unit = unit::parse_unit(unit_text).value_or(unit::Unit{});
  std::vector<double> values = reduced(panel, recording, x);
  for (double& value : values) value = unit.from_si(value);
  plot.label("x", x);
  plot.spec.x.unit = unit_text.empty() ? "" : query::printed_unit(unit_text);
  if (panel.x.label.empty())
    plot.spec.x.label =
        claim::reduction_names()[*panel.options<HistogramOptions>().reduction] + " of " + plot.spec.x.label;
  draw_histogram(values, plot);
  plot.spec.y.label = "runs";
}

void draw_bins(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const query::Series& x = *panel.find("x");
  if (panel.options<HistogramOptions>().reduction)
    return draw_reduced(panel, recording_of(panel, recordings), x, plot);
  const geometry::Curve all = joined(gather(panel, recording_of(panel, recordings), {&x}));
  plot.label("x", x);
  draw_histogram(all.columns.empty() ? std::vector<double>{} : all.columns[0], plot);
  const record::Recording& recording = recording_of(panel, recordings);
  const bool one_of_each = panel.final_rows || recording.starts.size() == recording.table.rows();
  if (one_of_each && recording.starts.size() > 1) plot.spec.y.label = "runs";
}

}  // namespace

void draw_histogram(const std::vector<double>& values, PlotBuilder& plot) {
  const auto& options = plot.panel().options<HistogramOptions>();
  plot.spec.y.label = "rows";
  plot.spec.x.grid = false;
  if (values.empty()) return;
  geometry::Extent extent = geometry::extent_of(values);
  for (const double line : options.lines) extent.add(line);
  extent = extent.padded(options.lines.empty() ? 0.0 : 0.02);
  RectanglesMark bins =
      bins_of(values, extent, static_cast<std::size_t>(std::clamp(std::floor(options.bins), 1.0, 1000.0)));
  const double top = 1.05 * geometry::extent_of(bins.y_high).high;
  plot.range("x", extent);
  plot.range("y", {0.0, top});
  plot.add(std::move(bins));
  for (const double line : options.lines)
    plot.add(LineMark{{{{line, line}, {0.0, top}, {}, {}}}, {curve_color(1), 2.4}});
}

PlotKind histogram_plot() {
  PlotKind kind{
      "histogram",
      "how many rows have which value",
      {{"x", "the value that is counted", true}},
      {number_key("bins", "number of bins (30)", &HistogramOptions::bins),
       {"reduce", "one value for each run in place of each row: max, mean, overshoot, settling_time, ...",
        reduction_form(), read_reduction},
       numbers_key("lines", "a value, or a list, at which a line is drawn", &HistogramOptions::lines, "x")},
      false,
      draw_bins};
  kind.lacks = {KeyNeeds::legend, KeyNeeds::color_bar};
  return kind;
}

}  // namespace stepwire::plot
