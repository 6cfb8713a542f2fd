#include <fmt/format.h>

#include "engine/figure/plot_tools.hpp"
#include "engine/statistics/quartiles.hpp"

namespace stepwire {
namespace {

/// Samples that stand side by side above one label.
struct Group {
  std::string label;
  std::vector<std::vector<double>> samples;  ///< one for each kind
};

/// What a box plot shows: groups along the axis, and in each of them one box of each kind.
struct Boxes {
  std::vector<Group> groups;
  std::vector<double> kinds;            ///< values of `beside`, ascending
  std::vector<std::string> kind_names;  ///< empty where there is no `beside`
};

std::vector<double> values_of(const std::vector<Curve>& curves, std::size_t column) {
  std::vector<double> values;
  for (const Curve& curve : curves)
    values.insert(values.end(), curve.columns[column].begin(), curve.columns[column].end());
  return values;
}

/// The kinds of all y, before their samples are sorted into them.
Boxes kinds_of(const Panel& panel, const std::vector<Curves>& all, std::span<const Recording> recordings) {
  Boxes boxes;
  const Series* beside = panel.find("beside");
  if (beside == nullptr) {
    boxes.kinds = {0.0};
    return boxes;
  }
  for (const Curves& curves : all) {
    const auto values = values_of(curves.curves, 1);
    boxes.kinds.insert(boxes.kinds.end(), values.begin(), values.end());
  }
  std::sort(boxes.kinds.begin(), boxes.kinds.end());
  boxes.kinds.erase(std::unique(boxes.kinds.begin(), boxes.kinds.end()), boxes.kinds.end());
  boxes.kind_names = labels_of(*beside, boxes.kinds, recording_of(panel, recordings));
  return boxes;
}

void add_curve(Group& group, const Curve& curve, const std::vector<double>& kinds) {
  for (std::size_t row = 0; row < curve.size(); ++row) {
    const auto kind = curve.columns.size() < 2
                          ? kinds.begin()
                          : std::lower_bound(kinds.begin(), kinds.end(), curve.columns[1][row]);
    group.samples[static_cast<std::size_t>(kind - kinds.begin())].push_back(curve.columns[0][row]);
  }
}

Boxes boxes_of(const Panel& panel, std::span<const Recording> recordings) {
  const auto& all_y = panel.series.at("y");
  std::vector<Curves> all;
  for (std::size_t i = 0; i < all_y.size(); ++i) {
    std::vector<const Series*> channels{&all_y[i]};
    if (const Series* beside = panel.find("beside")) channels.push_back(beside);
    all.push_back(gather(panel, recording_of(panel, recordings, i), channels));
  }
  Boxes boxes = kinds_of(panel, all, recordings);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < all[i].groups.size(); ++k) {
      Group group{all[i].labels.empty() ? all_y[i].label : all[i].labels[k],
                  std::vector<std::vector<double>>(boxes.kinds.size())};
      if (all_y.size() > 1 && !all[i].labels.empty()) group.label = all_y[i].label + ", " + group.label;
      for (const Curve& curve : all[i].curves)
        if (curve.group == k) add_curve(group, curve, boxes.kinds);
      boxes.groups.push_back(std::move(group));
    }
  for (std::size_t i = 0; i < std::min(boxes.groups.size(), panel.legend.size()); ++i)
    boxes.groups[i].label = panel.legend[i];
  return boxes;
}

std::string tics(const std::vector<Group>& groups) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < groups.size(); ++i)
    list.push_back(fmt::format("{} {}", quoted_tic(groups[i].label), i + 1));
  // Many or long labels would run into each other.
  std::size_t letters = 0;
  for (const Group& group : groups) letters += group.label.size() + 2;
  return fmt::format("set xtics {} ({})", letters > 75 ? "rotate by -35" : "norotate", fmt::join(list, ", "));
}

/// The boxes of one kind: place, ends of the whiskers and the box, median, mean; and the values beyond.
struct Kind {
  Curve boxes{std::vector<std::vector<double>>(7), 0};
  Curve beyond{std::vector<std::vector<double>>(2), 0};
};

void append(Curve& curve, std::initializer_list<double> row) {
  std::size_t column = 0;
  for (const double value : row) curve.columns[column++].push_back(value);
}

/// Part of a group's room that a box and its neighbours take.
double slot(const Boxes& boxes) {
  return boxes.kinds.size() == 1 ? 0.5 : 0.84 / static_cast<double>(boxes.kinds.size());
}

Kind kind_of(const Boxes& boxes, std::size_t index, Whiskers whiskers) {
  Kind kind;
  const double aside =
      slot(boxes) * (static_cast<double>(index) - 0.5 * static_cast<double>(boxes.kinds.size() - 1));
  for (std::size_t i = 0; i < boxes.groups.size(); ++i) {
    const auto& sample = boxes.groups[i].samples[index];
    if (sample.empty()) continue;
    const double at = static_cast<double>(i + 1) + aside;
    const BoxSummary box = box_summary(sample, whiskers);
    append(kind.boxes, {at, box.low_whisker, box.lower, box.median, box.upper, box.high_whisker, box.mean});
    for (const double value : box.beyond) append(kind.beyond, {at, value});
  }
  return kind;
}

/// Every box first, so that no box covers the marks of another; marks have their text once.
void draw_kinds(const Boxes& boxes, Whiskers whiskers, Script& script) {
  const double half = boxes.kinds.size() == 1 ? 0.25 : 0.43 * slot(boxes);
  std::vector<Curve> all, beyond;
  for (std::size_t i = 0; i < boxes.kinds.size(); ++i) {
    const Kind kind = kind_of(boxes, i, whiskers);
    if (kind.boxes.size() == 0) continue;
    script.plot(
        fmt::format("{} using 1:3:2:6:5:({}) with candlesticks fs solid 0.2 border lc rgb '{}' fc rgb "
                    "'{}' lc rgb '{}' lw 1.3",
                    script.data({kind.boxes}), 2.0 * half, curve_color(i), curve_color(i), curve_color(i)),
        boxes.kind_names.empty() ? "" : boxes.kind_names[i], " whiskerbars 0.5");
    all.push_back(kind.boxes);
    if (kind.beyond.size() > 0) beyond.push_back(kind.beyond);
  }
  const std::string block = script.data(all);
  script.plot(fmt::format("{} using ($1-{}):4:({}):(0) with vectors nohead lc rgb '#111111' lw 2.4", block,
                          half, 2.0 * half),
              "median");
  // Beside coloured boxes an asterisk has none of their colours.
  const std::string color = boxes.kinds.size() == 1 ? "#D55E00" : "#111111";
  script.plot(fmt::format("{} using 1:7 with points pt 3 ps 0.9 lw 1.5 lc rgb '{}'", block, color), "mean");
  if (!beyond.empty())
    script.plot(script.data(beyond) + " using 1:2 with points pt 6 ps 0.6 lw 1.2 lc rgb '#666666'",
                "beyond the whiskers");
}

void draw_boxes(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  const Boxes boxes = boxes_of(panel, recordings);
  Series y = panel.series.at("y").front();
  if (panel.series.at("y").size() > 1) y.label = "";
  script.label("y", y);
  if (const Series* by = panel.find("by"))
    script.set("set xlabel " +
               quoted(panel.words.contains("x_label") ? panel.words.at("x_label") : by->label));
  if (boxes.groups.empty()) return;
  script.x = {0.4, static_cast<double>(boxes.groups.size()) + 0.6};
  for (const Group& group : boxes.groups)
    for (const auto& sample : group.samples)
      for (const double value : sample) script.y.add(value);
  script.range("x", script.x);
  script.range("y", script.y.padded(0.06));
  script.set(tics(boxes.groups));
  script.set("set grid nox");
  const auto whiskers = panel.words.find("whiskers");
  draw_kinds(boxes,
             whiskers != panel.words.end() && whiskers->second == "tukey" ? Whiskers::tukey : Whiskers::range,
             script);
}

}  // namespace

PlotKind box_plot() {
  return {
      "box",
      "box plots: median, mean (asterisk), quartiles after Hazen, whiskers over the full range",
      {{"y", "the values; one expression or a list of them", true, true},
       {"by", "one box for each value of this"},
       {"beside", "boxes for each value of this stand side by side, each in its colour"}},
      {{"whiskers",
        "range (over all values), or tukey: to the last value within 1.5 interquartile ranges of the box; "
        "those beyond are drawn",
        "",
        false,
        {"range", "tukey"}}},
      false,
      draw_boxes};
}

}  // namespace stepwire
