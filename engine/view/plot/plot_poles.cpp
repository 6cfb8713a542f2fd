#include <cmath>
#include <map>
#include <numbers>

#include "engine/view/plot/linear_rows.hpp"
#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

const LineStyle pole_border{"#888888", 1.2, {4.0, 3.0}};
constexpr double most_shown = 2.5;  // of a Nyquist curve, which may diverge

/// Points of the complex plane.
struct Places {
  std::vector<double> x, y;
};

/// Returns the points without the padding of the list.
Places places_of(const LinearRows& rows, const std::string& name, std::size_t run) {
  Places all{rows.list(name + ".real", run), rows.list(name + ".imaginary", run)};
  while (all.x.size() > 1 && all.y.size() == all.x.size() && all.x.back() == all.x[all.x.size() - 2] &&
         all.y.back() == all.y[all.y.size() - 2]) {
    all.x.pop_back();
    all.y.pop_back();
  }
  return all;
}

void cover(const Places& all, PlotBuilder& plot) {
  for (std::size_t i = 0; i < all.x.size(); ++i) {
    if (!std::isfinite(all.x[i]) || !std::isfinite(all.y[i])) continue;
    plot.x.add(all.x[i]);
    plot.y.add(all.y[i]);
  }
}

void add_points(const Places& all, PointsMark::Symbol symbol, double size, const std::string& color,
                const std::string& legend, PlotBuilder& plot) {
  if (all.x.empty()) return;
  cover(all, plot);
  plot.add(PointsMark{{all.x, all.y, {}, {}}, symbol, size, 1.8, color, legend});
}

void add_circle(PlotBuilder& plot) {
  MarkRows circle;
  for (int k = 0; k <= 120; ++k) {
    circle.x.push_back(std::cos(2.0 * std::numbers::pi * k / 120.0));
    circle.y.push_back(std::sin(2.0 * std::numbers::pi * k / 120.0));
  }
  cover({circle.x, circle.y}, plot);
  plot.add_below(LineMark{{circle}, pole_border});
}

void finish(const char* unit, PlotBuilder& plot) {
  name_axis(plot.spec.x, "real part", unit);
  name_axis(plot.spec.y, "imaginary part", unit);
  if (plot.x.empty()) return;
  plot.x.add(0.0);
  plot.y.add(0.0);
  plot.spec.x.zero_line = plot.spec.y.zero_line = true;
  plot.plane(0.08);
}

const char* unit_of(const LinearRows& rows) {
  return rows.runs() > 0 && !rows.sampled(0) ? "1/s" : "";
}

void draw_poles(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const LinearRows rows(panel, recordings);
  for (std::size_t run = 0; run < rows.runs(); ++run) {
    const std::string label = rows.label(run);
    const bool one = rows.runs() == 1;
    add_points(places_of(rows, "pole", run), PointsMark::Symbol::asterisk, 9.0, curve_color(run),
               one ? "poles" : label, plot);
    add_points(places_of(rows, "zero", run), PointsMark::Symbol::ring, 9.0, curve_color(run),
               one ? "zeros" : "", plot);
  }
  if (!plot.spec.marks.empty() && rows.sampled(0)) add_circle(plot);
  finish(unit_of(rows), plot);
}

/// Adds the branches of one run: rows with the same number.
void add_branches(const LinearRows& rows, std::size_t run, PlotBuilder& plot) {
  const Places all = places_of(rows, "locus", run);
  const std::vector<double> branch = rows.list("locus.branch", run);
  std::map<double, MarkRows> branches;
  for (std::size_t i = 0; i < branch.size() && i < all.x.size(); ++i) {
    branches[branch[i]].x.push_back(all.x[i]);
    branches[branch[i]].y.push_back(all.y[i]);
  }
  std::vector<MarkRows> curves;
  for (auto& [number, curve] : branches) curves.push_back(std::move(curve));
  if (!curves.empty()) plot.add(LineMark{curves, {curve_color(run), 1.6}});
}

/// Draws the locus. The range contains the poles, the zeros and the closed loop, with a margin for the
/// branches.
void draw_locus(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const LinearRows rows(panel, recordings);
  for (std::size_t run = 0; run < rows.runs(); ++run) {
    const bool one = rows.runs() == 1;
    add_branches(rows, run, plot);
    add_points(places_of(rows, "pole", run), PointsMark::Symbol::asterisk, 9.0, curve_color(run),
               one ? "poles, gain 0" : rows.label(run), plot);
    add_points(places_of(rows, "zero", run), PointsMark::Symbol::ring, 9.0, curve_color(run),
               one ? "zeros" : "", plot);
    add_points(places_of(rows, "closed_pole", run), PointsMark::Symbol::disc, 8.0, "#d11a1a",
               run == 0 ? "closed loop, gain 1" : "", plot);
  }
  const double room = 0.5 * std::max(plot.x.width(), plot.y.width());
  if (!plot.spec.marks.empty() && rows.sampled(0)) {
    add_circle(plot);
  } else if (!plot.x.empty()) {
    for (geometry::Extent* extent : {&plot.x, &plot.y})
      *extent = {extent->low - (extent == &plot.x ? 0.0 : room), extent->high + room};
  }
  finish(unit_of(rows), plot);
}

/// Adds the rows near -1, with those of negative frequencies.
void add_nyquist(const LinearRows& rows, std::size_t run, PlotBuilder& plot) {
  const Places all{rows.list("real", run), rows.list("imaginary", run)};
  MarkRows above, below;
  for (std::size_t i = 0; i < all.x.size() && i < all.y.size(); ++i) {
    if (!(std::hypot(all.x[i], all.y[i]) < most_shown)) continue;
    above.x.push_back(all.x[i]);
    above.y.push_back(all.y[i]);
    below.x.push_back(all.x[i]);
    below.y.push_back(-all.y[i]);
  }
  if (above.x.empty()) return;
  cover({above.x, above.y}, plot);
  cover({below.x, below.y}, plot);
  plot.add(LineMark{{below}, {curve_color(run), 1.2, {4.0, 3.0}}});
  plot.add(LineMark{{above}, {curve_color(run), 1.8}, 0.0, rows.label(run)});
}

/// Marks where the curve crosses the real axis and the unit circle.
void add_margins(const LinearRows& rows, PlotBuilder& plot) {
  const double gain = rows.number("margin.gain", 0), phase = rows.number("margin.phase", 0);
  Places crossings;
  if (std::isfinite(gain) && gain != 0.0) crossings = {{-1.0 / gain}, {0.0}};
  if (std::isfinite(phase)) {
    crossings.x.push_back(-std::cos(phase));
    crossings.y.push_back(-std::sin(phase));
  }
  add_points(crossings, PointsMark::Symbol::disc, 8.0, "#d11a1a", "margins", plot);
}

void draw_nyquist(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const LinearRows rows(panel, recordings);
  for (std::size_t run = 0; run < rows.runs(); ++run) add_nyquist(rows, run, plot);
  if (!plot.spec.marks.empty()) {
    add_circle(plot);
    plot.spec.texts.push_back({.text = "-1", .x = -1.0, .y = 0.0, .offset = {-0.9, 0.7}, .dot = 6.0});
  }
  if (rows.runs() == 1) add_margins(rows, plot);
  finish("", plot);
}

/// Removes the end of a curve that looks like its last value.
void shorten(Places& curve) {
  constexpr double seen = 1e-3, beyond = 1.15;  // shares of the height and of the time
  const auto [low, high] = std::ranges::minmax_element(curve.y);
  const double least = seen * (*high - *low), last = curve.y.back();
  std::size_t i = curve.y.size();
  while (i > 0 && std::abs(curve.y[i - 1] - last) <= least) --i;
  if (i == 0) return;
  const auto end = std::ranges::upper_bound(curve.x, beyond * curve.x[i - 1]);
  curve.y.resize(static_cast<std::size_t>(end - curve.x.begin()));
  curve.x.erase(end, curve.x.end());
}

void draw_step(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const LinearRows rows(panel, recordings);
  for (std::size_t run = 0; run < rows.runs(); ++run) {
    Places curve{rows.list("step.time", run), rows.list("step.response", run)};
    if (curve.x.empty() || curve.x.size() != curve.y.size()) continue;
    if (!panel.x.range) shorten(curve);
    cover(curve, plot);
    plot.add(LineMark{{{curve.x, curve.y, {}, {}}}, {curve_color(run), 1.8}, 0.0, rows.label(run)});
  }
  name_axis(plot.spec.x, "time", "s");
  name_axis(plot.spec.y, "response to a step of 1", "");
  if (plot.x.empty()) return;
  plot.y.add(0.0);
  set_line_ranges(plot);
}

}  // namespace

PlotKind poles_plot() {
  PlotKind kind{"poles", "poles and zeros of an analysis; of a sampled one about the unit circle",
                {},      {analysis_key()},
                true,    draw_poles};
  kind.lacks = {KeyNeeds::rows, KeyNeeds::color_bar, KeyNeeds::scale};
  return kind;
}

PlotKind root_locus_plot() {
  PlotKind kind{
      "root_locus",
      "where the poles of the closed loop go as the loop of an analysis is multiplied by a gain from 0 up",
      {},
      {analysis_key()},
      true,
      draw_locus};
  kind.lacks = {KeyNeeds::rows, KeyNeeds::color_bar, KeyNeeds::scale};
  return kind;
}

PlotKind nyquist_plot() {
  PlotKind kind{"nyquist", "the loop of an analysis in the plane of complex numbers, with its margins",
                {},        {analysis_key()},
                true,      draw_nyquist};
  kind.lacks = {KeyNeeds::ratio, KeyNeeds::rows, KeyNeeds::color_bar, KeyNeeds::scale};
  return kind;
}

PlotKind step_response_plot() {
  PlotKind kind{"step_response", "what an analysis puts out after a step of 1", {}, {analysis_key()}, true,
                draw_step};
  kind.lacks = {KeyNeeds::rows, KeyNeeds::color_bar, KeyNeeds::scale};
  return kind;
}

}  // namespace stepwire::plot
