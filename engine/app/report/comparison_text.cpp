#include "engine/app/report/comparison_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/view/geometry/thinning.hpp"
#include "engine/view/plot/figure_spec.hpp"

namespace stepwire::report {

namespace {

constexpr std::size_t points = 2000;  // of a curve

std::string method_text(const comparison::SignalDifference& signal) {
  switch (signal.method) {
    case comparison::Method::linear:
      return "; B by straight lines between its rows";
    case comparison::Method::hold:
      return "; B by the value of its last row";
    case comparison::Method::rows:
      break;
  }
  return "";
}

plot::LineMark line_of(const std::vector<double>& x, const std::vector<double>& y, const std::string& color,
                       std::vector<double> dash, std::string legend) {
  const geometry::Curve curve = geometry::decimate({{x, y}}, points);
  return {
      {{curve.columns[0], curve.columns[1], {}, {}}}, {color, 1.6, std::move(dash)}, 0.0, std::move(legend)};
}

void cover(plot::PlotBuilder& plot, const std::vector<double>& x, const std::vector<double>& y) {
  plot.cover({geometry::Curve{{x, y}}});
}

/// Draws both curves of a signal.
void draw_both(const comparison::DifferenceCurves& curves, plot::PlotBuilder& plot) {
  cover(plot, curves.time, curves.a);
  cover(plot, curves.time, curves.b);
  plot.add(line_of(curves.time, curves.a, plot::curve_color(0), {}, "A"));
  plot.add(line_of(curves.time, curves.b, plot::curve_color(1), {3.0, 3.0}, "B"));
}

/// Draws the difference between two lines at the tolerance.
void draw_difference(const comparison::DifferenceCurves& curves, double tolerance, plot::PlotBuilder& plot) {
  cover(plot, curves.time, curves.difference);
  for (const double limit : {-tolerance, tolerance}) {
    const std::vector<double> ends{curves.time.front(), curves.time.back()}, at(2, limit);
    cover(plot, ends, at);
    plot.add(line_of(ends, at, "#777777", {2.0, 3.0}, limit > 0.0 ? "tolerance" : ""));
  }
  plot.add(line_of(curves.time, curves.difference, plot::curve_color(2), {}, "A - B"));
  plot.spec.x.zero_line = true;
}

void finish(const std::string& label, const std::string& unit, plot::PlotBuilder& plot) {
  plot.spec.x.label = "time";
  plot.spec.x.unit = "s";
  plot.spec.y.label = label;
  plot.spec.y.unit = unit;
  plot.plane(0.04);
}

}  // namespace

std::string comparison_text(const comparison::RecordingDifference& difference) {
  std::string text = fmt::format("A {}, B {}\n", difference.a, difference.b);
  for (const comparison::SignalDifference& signal : difference.signals)
    text += fmt::format("  {} {}{}\n", signal.agrees ? "ok  " : "FAIL", comparison::difference_text(signal),
                        method_text(signal));
  for (const std::string& name : difference.only_in_a) text += fmt::format("  FAIL {}: only in A\n", name);
  for (const std::string& name : difference.only_in_b) text += fmt::format("  FAIL {}: only in B\n", name);
  return text;
}

std::string results_text(const session::ResultComparison& results) {
  std::string text = "results\n";
  for (const comparison::SignalDifference& signal : results.signals.signals)
    if (!signal.agrees) text += fmt::format("  ~ {}\n", comparison::difference_text(signal));
  for (const std::string& name : results.signals.only_in_b) text += fmt::format("  + {} is recorded\n", name);
  for (const std::string& name : results.signals.only_in_a)
    text += fmt::format("  - {} is no longer recorded\n", name);
  for (const session::ChangedVerdict& claim : results.claims)
    text += fmt::format("  ~ claim '{}': {} -> {}\n", claim.that, claim.before, claim.after);
  if (results.agrees()) text += "  all recorded signals and all verdicts are the same\n";
  return text;
}

plot::FigureSpec comparison_figure(const session::ComparedRuns& runs, std::size_t signals) {
  const auto a = session::tables_of(runs.a), b = session::tables_of(runs.b);
  std::vector<std::pair<const comparison::SignalDifference*, comparison::DifferenceCurves>> shown;
  for (const bool agrees : {false, true})  // what differs comes first
    for (const comparison::SignalDifference& signal : runs.difference.signals) {
      if (signal.agrees != agrees || shown.size() >= signals) continue;
      auto curves = comparison::curves_of(a, b, signal, runs.tolerances);
      if (!curves.time.empty()) shown.emplace_back(&signal, std::move(curves));
    }
  plot::FigureBuilder builder(
      {.title = fmt::format("A {}, B {}", runs.difference.a, runs.difference.b), .height = 0},
      2 * shown.size());
  for (const auto& [signal, curves] : shown) {
    plot::PlotBuilder& both = builder.add({.title = signal->name});
    draw_both(curves, both);
    finish(signal->name, signal->unit, both);
    plot::PlotBuilder& difference = builder.add({});
    draw_difference(curves, signal->tolerance, difference);
    finish("A - B", signal->unit, difference);
  }
  return builder.finished();
}

}  // namespace stepwire::report
