#include "engine/figure/plot_tools.hpp"

#include <fmt/format.h>

namespace stepwire {
namespace {

constexpr double picture_budget = 14000.0;  ///< of a picture, so that it stays below some 300 kB
constexpr std::size_t most_in_legend = 8;

std::string legend_text(const Panel& panel, const Series& y, const Curves& curves, std::size_t group,
                        std::size_t entry) {
  if (entry < panel.legend.size()) return panel.legend[entry];
  const bool several = panel.series.at("y").size() > 1;
  if (curves.labels.empty()) return several ? y.label : "";
  return several ? y.label + ", " + curves.labels[group] : curves.labels[group];
}

/// One line under which all y can stand.
Series common_label(const std::vector<Series>& all) {
  Series common = all.front();
  for (const Series& series : all) {
    if (common.unit_text.empty()) common.unit_text = series.unit_text;
    if (&series != &all.front()) common.label += ", " + series.label;
  }
  if (common.label.size() > 44) common.label = "";
  return common;
}

/// How gnuplot draws the curve of this entry in the style that the file gives; empty without one.
std::string styled(const Panel& panel, std::size_t entry) {
  const auto styles = panel.word_lists.find("style");
  if (styles == panel.word_lists.end() || entry >= styles->second.size()) return {};
  const std::string& style = styles->second[entry];
  if (style == "dots") return "with lines dt (0.5,3.5) lw 3.4";
  return style == "dashes" ? "with lines dt (8,5) lw 1.4" : "with lines lw 1.6";
}

/// A later curve is thinner, so that one that lies below it is still seen.
std::string look(const Panel& panel, std::size_t entry) {
  if (const std::string style = styled(panel, entry); !style.empty()) return style;
  const std::string width = entry == 0 && panel.series.at("y").size() > 1 ? "2.4" : "1.6";
  const std::string with = panel.final_rows ? "linespoints pt 7 ps 0.5" : "lines";
  return fmt::format("with {} lw {}", with, width);
}

Curve with_group_value(Curve curve, const Curves& all) {
  curve.columns.emplace_back(curve.size(), all.groups[curve.group]);
  return curve;
}

std::size_t rows_for(const Script& script, std::size_t parts) {
  return static_cast<std::size_t>(picture_budget * script.share / static_cast<double>(parts));
}

/// The rows of a group that are drawn: each one where it has a point, else as many as its line needs.
std::vector<Curve> drawn(const Panel& panel, const Curves& all, std::size_t group, std::size_t budget) {
  return panel.final_rows ? cut(all, group, budget) : thinned(all, group, budget);
}

/// Many groups: the value of `by` is shown as a colour.
void draw_by_color(const Panel& panel, const Curves& all, Script& script) {
  for (std::size_t group = 0; group < all.groups.size(); ++group) {
    auto curves = drawn(panel, all, group, rows_for(script, all.groups.size()));
    script.cover(curves);
    for (Curve& curve : curves) curve = with_group_value(std::move(curve), all);
    script.plot(script.data(curves) + " using 1:2:3 " + look(panel, 1) + " lc palette");
  }
  script.color_bar(*panel.find("by"), extent_of(all.groups));
}

void draw_in_legend(const Panel& panel, const Series& y, const Curves& all, std::size_t& entry,
                    Script& script) {
  for (std::size_t group = 0; group < all.groups.size(); ++group, ++entry) {
    const auto curves =
        drawn(panel, all, group, rows_for(script, panel.series.at("y").size() * all.groups.size()));
    script.cover(curves);
    script.plot(fmt::format("{} using 1:2 {} lc rgb '{}'", script.data(curves), look(panel, entry),
                            curve_color(entry)),
                legend_text(panel, y, all, group, entry));
  }
}

}  // namespace

Curve joined(const Curves& all) {
  Curve result;
  for (const Curve& curve : all.curves) {
    result.columns.resize(curve.columns.size());
    for (std::size_t i = 0; i < curve.columns.size(); ++i)
      result.columns[i].insert(result.columns[i].end(), curve.columns[i].begin(), curve.columns[i].end());
  }
  return result;
}

Extent extent_of(const std::vector<double>& values) {
  Extent extent;
  for (const double value : values) extent.add(value);
  return extent;
}

void draw_curves(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  const auto &all_x = panel.series.at("x"), &all_y = panel.series.at("y");
  std::size_t entry = 0;
  for (std::size_t i = 0; i < all_y.size(); ++i) {
    const Series& x = all_x[std::min(i, all_x.size() - 1)];
    const Curves all = gather(panel, recording_of(panel, recordings, i), {&x, &all_y[i]});
    if (all.groups.size() > most_in_legend && all_y.size() == 1 && panel.legend.empty())
      draw_by_color(panel, all, script);
    else
      draw_in_legend(panel, all_y[i], all, entry, script);
  }
  script.label("x", common_label(all_x));
  script.label("y", common_label(all_y));
}

const Recording& recording_of(const Panel& panel, std::span<const Recording> recordings, std::size_t index) {
  return recordings[panel.recordings[std::min(index, panel.recordings.size() - 1)]];
}

double number_or(const Panel& panel, const std::string& key, double otherwise) {
  const auto found = panel.numbers.find(key);
  return found == panel.numbers.end() ? otherwise : found->second;
}

}  // namespace stepwire
