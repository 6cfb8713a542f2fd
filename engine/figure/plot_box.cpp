#include <fmt/format.h>

#include "engine/figure/plot_tools.hpp"
#include "engine/statistics/quartiles.hpp"

namespace stepwire {
namespace {

/// Samples of one box and what stands below it.
struct Sample {
  std::string label;
  std::vector<double> values;
};

std::vector<Sample> samples_of(const Panel& panel, std::span<const Recording> recordings) {
  std::vector<Sample> samples;
  const auto& all_y = panel.series.at("y");
  for (std::size_t i = 0; i < all_y.size(); ++i) {
    const Curves all = gather(panel, recording_of(panel, recordings, i), {&all_y[i]});
    for (std::size_t group = 0; group < all.groups.size(); ++group) {
      Sample sample{all.labels.empty() ? all_y[i].label : all.labels[group], {}};
      if (all_y.size() > 1 && !all.labels.empty()) sample.label = all_y[i].label + ", " + sample.label;
      for (const Curve& curve : all.curves)
        if (curve.group == group)
          sample.values.insert(sample.values.end(), curve.columns[0].begin(), curve.columns[0].end());
      samples.push_back(std::move(sample));
    }
  }
  for (std::size_t i = 0; i < std::min(samples.size(), panel.legend.size()); ++i)
    samples[i].label = panel.legend[i];
  return samples;
}

std::string tics(const std::vector<Sample>& samples) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < samples.size(); ++i)
    list.push_back(fmt::format("{} {}", quoted(samples[i].label), i + 1));
  // Many or long labels would run into each other.
  std::size_t letters = 0;
  for (const Sample& sample : samples) letters += sample.label.size() + 2;
  return fmt::format("set xtics {} ({})", letters > 75 ? "rotate by -35" : "norotate", fmt::join(list, ", "));
}

/// Place, minimum, lower quartile, median, upper quartile, maximum, mean.
Curve boxes_of(const std::vector<Sample>& samples) {
  Curve boxes{std::vector<std::vector<double>>(7), 0};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const BoxSummary box = box_summary(samples[i].values);
    const double row[] = {
        static_cast<double>(i + 1), box.min, box.lower, box.median, box.upper, box.max, box.mean};
    for (std::size_t column = 0; column < 7; ++column) boxes.columns[column].push_back(row[column]);
  }
  return boxes;
}

void draw_boxes(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  const auto samples = samples_of(panel, recordings);
  Series y = panel.series.at("y").front();
  if (panel.series.at("y").size() > 1) y.label = "";
  script.label("y", y);
  if (const Series* by = panel.find("by"))
    script.set("set xlabel " +
               quoted(panel.words.contains("x_label") ? panel.words.at("x_label") : by->label));
  if (samples.empty()) return;
  script.x = {0.4, static_cast<double>(samples.size()) + 0.6};
  for (const Sample& sample : samples)
    for (const double value : sample.values) script.y.add(value);
  script.range("x", script.x);
  script.range("y", script.y.padded(0.06));
  script.set(tics(samples));
  script.set("set boxwidth 0.5\nset style fill solid 1.0 border lc rgb '#0072B2'\nset grid nox");
  const std::string block = script.data({boxes_of(samples)});
  script.plot(block + " using 1:3:2:6:5 with candlesticks fc rgb '#cfe3f1' lc rgb '#0072B2' lw 1.3", {},
              " whiskerbars 0.5");
  script.plot(block + " using ($1-0.25):4:(0.5):(0) with vectors nohead lc rgb '#111111' lw 2.4", "median");
  script.plot(block + " using 1:7 with points pt 3 ps 0.9 lw 1.5 lc rgb '#D55E00'", "mean");
}

}  // namespace

PlotKind box_plot() {
  return {"box",
          "box plots: median, mean (asterisk), quartiles after Hazen, whiskers over the full range",
          {{"y", "the values; one expression or a list of them", true, true},
           {"by", "one box for each value of this"}},
          {},
          false,
          draw_boxes};
}

}  // namespace stepwire
