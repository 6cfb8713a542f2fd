#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/cli/loop_report.hpp"
#include "engine/document/document.hpp"
#include "engine/figure/figure.hpp"

namespace stepwire {

namespace {

constexpr double bins_per_decade = 20.0;
constexpr double below_axis = 0.1, axis = 0.7;
constexpr double ns = 1e-9;

/// How often times fell between powers of ten in 20 parts, which can be seen where the bins of a histogram
/// are too narrow.
class Coarse {
 public:
  Coarse(std::string name, const Histogram& times) : name(std::move(name)) {
    for (std::size_t bin = 0; bin + 1 < Histogram::bins(); ++bin)
      add(0.5 * static_cast<double>(Histogram::begin_of(bin) + Histogram::begin_of(bin + 1)),
          times.count_in(bin));
  }
  Coarse(std::string name, const CyclictestHistogram& times) : name(std::move(name)) {
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

/// What is counted, with the bounds of the axes.
struct Counted {
  std::vector<Coarse> all;
  std::size_t first = std::numeric_limits<std::size_t>::max(), end = 0;
  double most = 1.0;
};

Counted counted(const LoopOutcome& outcome) {
  const Measurements& measured = outcome.loop.measurements();
  Counted counted{
      {{"wake_up", measured.wake_up()}, {"response", measured.response()}, {"step", measured.step()}}};
  if (outcome.baseline) counted.all.emplace_back("cyclictest", outcome.baseline->histogram());
  for (const Coarse& coarse : counted.all) {
    counted.first = std::min(counted.first, coarse.begin());
    counted.end = std::max(counted.end, coarse.end());
    counted.most = std::max(counted.most, coarse.most());
  }
  counted.first -= std::min<std::size_t>(counted.first, 1);
  return counted;
}

/// A staircase for each; what was never counted lies below the axis.
Recording staircases(const Counted& counted) {
  Recording recording;
  auto& columns = recording.table.columns;
  columns.push_back({"duration", "s", {}});
  for (const Coarse& coarse : counted.all) columns.push_back({coarse.name, "", {}});
  for (std::size_t bin = counted.first; bin <= counted.end; ++bin)
    for (const std::size_t at : {bin, bin + 1}) {
      columns[0].values.push_back(ns * edge(at));
      for (std::size_t i = 0; i < counted.all.size(); ++i)
        columns[i + 1].values.push_back(std::max(below_axis, counted.all[i][bin]));
    }
  return recording;
}

Recording worst_over_time(const LoopOutcome& outcome) {
  Recording recording;
  auto& columns = recording.table.columns;
  for (const char* name : {"time", "worst_wake_up", "worst_response", "worst_step"})
    columns.push_back({name, "s", {}});
  const double stretch = outcome.settings.duration / static_cast<double>(Measurements::worst_count);
  const auto& all = outcome.loop.measurements().worst();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].wake_up == 0 && all[i].response == 0) continue;  // no deadline, or not reached
    columns[0].values.push_back(stretch * (static_cast<double>(i) + 0.5));
    columns[1].values.push_back(ns * static_cast<double>(all[i].wake_up));
    columns[2].values.push_back(ns * static_cast<double>(all[i].response));
    columns[3].values.push_back(ns * static_cast<double>(all[i].step));
  }
  return recording;
}

Names names_of(const std::vector<Recording>& recordings) {
  Names names{"loop.svg", {}, {}};
  for (std::size_t i = 0; i < recordings.size(); ++i)
    for (const Column& column : recordings[i].table.columns)
      names.columns.push_back(
          {column.name,
           column.unit.empty() ? std::nullopt : std::optional(parse_unit(column.unit)->dimension), i});
  return names;
}

/// The two panels, as a diagram file would ask for them.
std::string panels(const LoopOutcome& outcome, const Counted& counted) {
  const std::string baseline = outcome.baseline ? ", cyclictest" : "";
  return fmt::format(
      "panels:\n"
      "  - {{plot: xy, x: duration in µs, y: [wake_up, response, step{baseline}], log: [x, y], x_label: "
      "time,\n"
      "     y_label: deadlines, legend: [wake-up latency, response, cost of a step{baseline}],\n"
      "     x_range: [{low:.6g} us, {high:.6g} us], y_range: [{axis}, {most:.6g}]}}\n"
      "  - {{plot: lines, x: time in s, y: [worst_wake_up in µs, worst_response in µs, worst_step in µs],\n"
      "     log: y, y_label: longest in {stretch:.4g} s, legend: [wake-up latency, response, cost of a "
      "step],\n"
      "     x_range: [0 s, {duration:.9g} s]}}\n",
      fmt::arg("baseline", baseline), fmt::arg("low", 1e-3 * edge(counted.first)),
      fmt::arg("high", 1e-3 * edge(counted.end + 1)), fmt::arg("axis", axis),
      fmt::arg("most", 2.0 * counted.most),
      fmt::arg("stretch", outcome.settings.duration / static_cast<double>(Measurements::worst_count)),
      fmt::arg("duration", outcome.settings.duration));
}

}  // namespace

std::string loop_figure(const LoopOutcome& outcome) {
  const Counted all = counted(outcome);
  const std::vector<Recording> recordings{staircases(all), worst_over_time(outcome)};
  Faults faults;
  auto figures =
      read_figures(parse_document(panels(outcome, all), "loop.svg").root, names_of(recordings), faults);
  faults.throw_if_any();
  const Diagram& diagram = outcome.loop.simulation().plan().diagram;
  figures.front().title =
      fmt::format("{}: {:.6g} Hz, {}", diagram.title.empty() ? diagram.file : diagram.title,
                  outcome.settings.rate, outcome.served.policy);
  return draw(figures.front(), recordings).svg;
}

}  // namespace stepwire
