#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/linear_rows.hpp"
#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

constexpr double per_degree = 180.0 / std::numbers::pi;
const LineStyle zero_border{"#888888", 1.2, {4.0, 3.0}}, margin_line{"#d11a1a", 2.0};

double decibels(double factor) {
  return 20.0 * std::log10(factor);
}

std::vector<double> each(std::vector<double> values, double (*function)(double)) {
  for (double& value : values) value = function(value);
  return values;
}

LineMark segment(double x, double low, double high, const LineStyle& line) {
  return {{{{x, x}, {low, high}, {}, {}}}, line};
}

void add_response(const std::vector<double>& x, const std::vector<double>& y, const std::string& legend,
                  std::size_t run, PlotBuilder& plot) {
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (x.size() != y.size() || std::ranges::none_of(y, is_finite)) return;
  for (const double value : x) plot.x.add(value);
  for (const double value : y) plot.y.add(value);
  plot.add(LineMark{{{x, y, {}, {}}}, {curve_color(run), 1.8}, 0.0, legend});
}

/// Writes a text beside the line of a margin. A falling curve is at the right of the line below its point
/// there, and at the left above it: the other side is free, unless the picture ends there.
void add_text(const std::string& text, double x, double y, bool below_curve, PlotBuilder& plot) {
  const double part = std::log(x / plot.x.low) / std::log(plot.x.high / plot.x.low);
  const bool left = part > 0.8 || (below_curve && part > 0.2);
  plot.spec.texts.push_back({.text = text,
                             .x = x,
                             .y = y,
                             .align = left ? TextMark::Align::right : TextMark::Align::left,
                             .offset = {left ? -0.6 : 0.6, 0.0},
                             .size = 12.0,
                             .color = "#d11a1a",
                             .rim = true});
}

/// Returns the first tick distance with at most 8 ticks; std::nullopt beyond the last.
std::optional<double> tick_step(double range, std::initializer_list<double> distances) {
  for (const double distance : distances)
    if (range <= 8.0 * distance) return distance;
  return std::nullopt;
}

/// Completes the plot, with frequencies as far as either panel has rows.
void finish(const char* label, const char* unit, double level, std::initializer_list<double> distances,
            PlotBuilder& plot) {
  name_axis(plot.spec.x, "frequency", "rad/s");
  name_axis(plot.spec.y, label, unit);
  if (plot.x.empty()) return;
  plot.add_below(LineMark{{{{plot.x.low, plot.x.high}, {level, level}, {}, {}}}, zero_border});
  plot.y.add(level);
  plot.spec.y.step = tick_step(plot.y.high - plot.y.low, distances);
  plot.range("x", plot.x);
  plot.range("y", plot.y.padded(0.06));
  plot.height = 0.45 * plot.width;
}

void draw_magnitude(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const LinearRows rows(panel, recordings);
  for (std::size_t run = 0; run < rows.runs(); ++run) {
    add_response(rows.list("frequency", run), each(rows.list("gain", run), decibels), rows.label(run), run,
                 plot);
    const double margin = rows.number("margin.gain_db", run), at = rows.number("margin.gain_frequency", run);
    if (rows.runs() > 1 || !std::isfinite(margin) || !(at > 0.0) || std::isinf(at)) continue;
    plot.add(segment(at, -margin, 0.0, margin_line));
    add_text(fmt::format("{} dB", query::short_number(margin, 3)), at, -0.5 * margin, margin < 0.0, plot);
  }
  finish("gain", "dB", 0.0, {1.0, 2.0, 5.0, 10.0, 20.0, 40.0, 60.0, 100.0}, plot);
}

void draw_phase(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const LinearRows rows(panel, recordings);
  double level = -180.0;
  for (std::size_t run = 0; run < rows.runs(); ++run) {
    const std::vector<double> frequency = rows.list("frequency", run);
    const std::vector<double> phase =
        each(rows.list("phase", run), [](double angle) { return per_degree * angle; });
    add_response(frequency, phase, rows.label(run), run, plot);
    const double margin = per_degree * rows.number("margin.phase", run);
    const double at = rows.number("margin.phase_frequency", run);
    if (rows.runs() > 1 || !std::isfinite(margin) || !std::isfinite(at)) continue;
    // The phase may have wrapped since, so the border is that of the turn at the margin.
    std::size_t row = 0;
    while (row + 1 < frequency.size() && frequency[row] < at) ++row;
    level += 360.0 * std::round((phase[row] - margin - level) / 360.0);
    plot.add(segment(at, level, level + margin, margin_line));
    add_text(fmt::format("{} deg", query::short_number(margin, 3)), at, level + 0.5 * margin, margin > 0.0,
             plot);
  }
  finish("phase", "deg", level, {1.0, 5.0, 15.0, 45.0, 90.0, 180.0, 360.0, 720.0, 3600.0}, plot);
}

}  // namespace

PlotKind bode_plot() {
  PlotKind kind{"bode", "gain and phase of an analysis over frequency, with its margins, in two panels",
                {},     {analysis_key()},
                true,   draw_magnitude};
  kind.lacks = {KeyNeeds::rows, KeyNeeds::color_bar, KeyNeeds::scale};
  return kind;
}

const PlotKind& bode_phase_plot() {
  static const PlotKind kind{"bode", "", {}, {}, true, draw_phase};
  return kind;
}

}  // namespace stepwire::plot
