#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/app/session/loop_files.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::session {

namespace {

constexpr double bins_per_decade = 20.0;
constexpr double below_axis = 0.1, axis = 0.7;

/// Histogram with 20 logarithmic bins per decade. The bins of the measured histograms are too narrow for a
/// picture.
class Coarse {
 public:
  Coarse(std::string name, const realtime::Histogram& times) : name(std::move(name)) {
    for (std::size_t bin = 0; bin + 1 < realtime::Histogram::bins(); ++bin)
      add(0.5 * static_cast<double>(realtime::Histogram::begin_of(bin) +
                                    realtime::Histogram::begin_of(bin + 1)),
          times.count_in(bin));
  }
  Coarse(std::string name, const realtime::CyclictestHistogram& times) : name(std::move(name)) {
    for (std::size_t us = 0; us < times.counts().size(); ++us)
      add(1e3 * (static_cast<double>(us) + 0.5), times.counts()[us]);
  }

  double operator[](std::size_t index) const { return index < counts_.size() ? counts_[index] : 0.0; }
  std::size_t begin() const {
    std::size_t index = 0;
    while (index < counts_.size() && counts_[index] == 0.0) ++index;
    return index;
  }
  std::size_t end() const { return counts_.size(); }
  double most() const { return counts_.empty() ? 0.0 : *std::max_element(counts_.begin(), counts_.end()); }

  std::string name;

 private:
  void add(double time, std::int64_t count) {
    if (count == 0) return;
    const auto index = static_cast<std::size_t>(bins_per_decade * std::log10(std::max(1.0, time)));
    counts_.resize(std::max(counts_.size(), index + 1));
    counts_[index] += static_cast<double>(count);
  }

  std::vector<double> counts_;
};

double edge(std::size_t index) {
  return std::pow(10.0, static_cast<double>(index) / bins_per_decade);
}

/// Histograms, with the bounds of the axes.
struct Counted {
  std::vector<Coarse> all;
  std::size_t first = std::numeric_limits<std::size_t>::max(), end = 0;
  double most = 1.0;
};

Counted counted(const LoopOutcome& outcome) {
  const realtime::Measurements& measured = outcome.loop.measurements();
  Counted counted{{{"wake-up latency", measured.wake_up()},
                   {"response", measured.response()},
                   {"cost of a step", measured.step()}}};
  if (outcome.baseline) counted.all.emplace_back("cyclictest", outcome.baseline->histogram());
  for (const Coarse& coarse : counted.all) {
    counted.first = std::min(counted.first, coarse.begin());
    counted.end = std::max(counted.end, coarse.end());
    counted.most = std::max(counted.most, coarse.most());
  }
  counted.first -= std::min<std::size_t>(counted.first, 1);
  return counted;
}

/// Returns a histogram as a step curve. Empty bins are below the axis.
plot::NumberCurve staircase(const Counted& counted, const Coarse& coarse) {
  plot::NumberCurve curve{{}, {}, coarse.name};
  for (std::size_t bin = counted.first; bin <= counted.end; ++bin)
    for (const std::size_t at : {bin, bin + 1}) {
      curve.x.push_back(1e-3 * edge(at));
      curve.y.push_back(std::max(below_axis, coarse[bin]));
    }
  return curve;
}

void draw_counts(const Counted& counted, plot::PlotBuilder& plot) {
  plot::name_axis(plot.spec.x, "time", "µs");
  plot::name_axis(plot.spec.y, "deadlines", "");
  std::vector<plot::NumberCurve> curves;
  for (const Coarse& coarse : counted.all) curves.push_back(staircase(counted, coarse));
  plot::draw_curves(curves, plot);
  plot.plane(0.05);
}

double stretch_of(const LoopOutcome& outcome) {
  return outcome.settings.duration / static_cast<double>(realtime::Measurements::worst_count);
}

/// Returns the longest times in each interval of the run.
std::vector<plot::NumberCurve> worst_over_time(const LoopOutcome& outcome) {
  std::vector<plot::NumberCurve> curves{
      {{}, {}, "wake-up latency"}, {{}, {}, "response"}, {{}, {}, "cost of a step"}};
  const auto& all = outcome.loop.measurements().worst();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].wake_up == 0 && all[i].response == 0) continue;  // no deadline, or not reached
    const auto add = [&](plot::NumberCurve& curve, std::int64_t longest) {
      curve.x.push_back(stretch_of(outcome) * (static_cast<double>(i) + 0.5));
      curve.y.push_back(1e-3 * static_cast<double>(longest));
    };
    add(curves[0], all[i].wake_up);
    add(curves[1], all[i].response);
    add(curves[2], all[i].step);
  }
  return curves;
}

void draw_worst(const LoopOutcome& outcome, plot::PlotBuilder& plot) {
  plot::name_axis(plot.spec.x, "time", "s");
  plot::name_axis(plot.spec.y, fmt::format("longest in {:.4g} s", stretch_of(outcome)), "µs");
  plot::draw_curves(worst_over_time(outcome), plot);
  plot::set_line_ranges(plot);
}

}  // namespace

plot::FigureSpec loop_figure(const LoopOutcome& outcome) {
  const Counted all = counted(outcome);
  const diagram::Diagram& diagram = outcome.loop.simulation().plan().diagram;
  plot::FigureBuilder figure(
      {.title = fmt::format("{}: {:.6g} Hz, {}", diagram.title.empty() ? diagram.file : diagram.title,
                            outcome.settings.rate, outcome.served.policy),
       .columns = 2},
      2);
  draw_counts(all,
              figure.add({.x = {.range = {{1e-3 * edge(all.first), 1e-3 * edge(all.end + 1)}}, .log = true},
                          .y = {.range = {{axis, 2.0 * all.most}}, .log = true}}));
  draw_worst(outcome, figure.add({.x = {.range = {{0.0, outcome.settings.duration}}}, .y = {.log = true}}));
  return figure.finished();
}

}  // namespace stepwire::session
