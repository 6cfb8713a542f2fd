#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

struct BoxOptions {
  bool tukey_whiskers = false;  ///< true for Tukey whiskers, else they extend to the extremes
};

/// Samples side by side above one label.
struct Group {
  std::string label;
  std::vector<std::vector<double>> samples;  ///< one for each kind
};

/// Groups along the axis, each with one box of each kind.
struct Boxes {
  std::vector<Group> groups;
  std::vector<double> kinds;            ///< Values of `beside`, ascending.
  std::vector<std::string> kind_names;  ///< Names of the kinds; empty without `beside`.
};

std::vector<double> values_of(const std::vector<geometry::Curve>& curves, std::size_t column) {
  std::vector<double> values;
  for (const geometry::Curve& curve : curves)
    values.insert(values.end(), curve.columns[column].begin(), curve.columns[column].end());
  return values;
}

/// Returns the kinds of all y, before the samples are sorted into them.
Boxes kinds_of(const Panel& panel, const std::vector<geometry::Curves>& all,
               std::span<const record::Recording> recordings) {
  Boxes boxes;
  const query::Series* beside = panel.find("beside");
  if (beside == nullptr) {
    boxes.kinds = {0.0};
    return boxes;
  }
  for (const geometry::Curves& curves : all) {
    const auto values = values_of(curves.curves, 1);
    boxes.kinds.insert(boxes.kinds.end(), values.begin(), values.end());
  }
  std::sort(boxes.kinds.begin(), boxes.kinds.end());
  boxes.kinds.erase(std::unique(boxes.kinds.begin(), boxes.kinds.end()), boxes.kinds.end());
  boxes.kind_names = labels_of(*beside, boxes.kinds, recording_of(panel, recordings), true);
  return boxes;
}

void add_curve(Group& group, const geometry::Curve& curve, const std::vector<double>& kinds) {
  for (std::size_t row = 0; row < curve.size(); ++row) {
    const auto kind = curve.columns.size() < 2
                          ? kinds.begin()
                          : std::lower_bound(kinds.begin(), kinds.end(), curve.columns[1][row]);
    group.samples[static_cast<std::size_t>(kind - kinds.begin())].push_back(curve.columns[0][row]);
  }
}

Boxes boxes_of(const Panel& panel, std::span<const record::Recording> recordings) {
  const auto& all_y = panel.series.at("y");
  std::vector<geometry::Curves> all;
  for (std::size_t i = 0; i < all_y.size(); ++i) {
    std::vector<const query::Series*> channels{&all_y[i]};
    if (const query::Series* beside = panel.find("beside")) channels.push_back(beside);
    all.push_back(gather(panel, recording_of(panel, recordings, i), channels));
  }
  Boxes boxes = kinds_of(panel, all, recordings);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < all[i].groups.size(); ++k) {
      Group group{all[i].labels.empty() ? all_y[i].label : all[i].labels[k],
                  std::vector<std::vector<double>>(boxes.kinds.size())};
      if (all_y.size() > 1 && !all[i].labels.empty()) group.label = all_y[i].label + ", " + group.label;
      for (const geometry::Curve& curve : all[i].curves)
        if (curve.group == k) add_curve(group, curve, boxes.kinds);
      boxes.groups.push_back(std::move(group));
    }
  for (std::size_t i = 0; i < std::min(boxes.groups.size(), panel.legend.size()); ++i)
    boxes.groups[i].label = panel.legend[i];
  return boxes;
}

void name_groups(const std::vector<Group>& groups, PlotAxis& axis) {
  std::size_t letters = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    axis.named_ticks.push_back({static_cast<double>(i + 1), groups[i].label});
    letters += groups[i].label.size() + 2;
  }
  // Many or long labels would overlap.
  if (letters > 75) axis.label_angle = -35.0;
}

/// Boxes of one kind with their marks.
struct Kind {
  BoxesMark boxes;
  VectorsMark medians;
  MarkRows means, beyond;
};

void append(const MarkRows& from, MarkRows& to) {
  to.x.insert(to.x.end(), from.x.begin(), from.x.end());
  to.y.insert(to.y.end(), from.y.begin(), from.y.end());
}

void append(const statistics::BoxSummary& box, double at, Kind& kind) {
  BoxesMark& boxes = kind.boxes;
  boxes.x.push_back(at);
  boxes.low_whisker.push_back(box.low_whisker);
  boxes.lower.push_back(box.lower);
  boxes.upper.push_back(box.upper);
  boxes.high_whisker.push_back(box.high_whisker);
  append({{at}, {box.mean}, {}, {}}, kind.means);
  for (const double value : box.beyond) append({{at}, {value}, {}, {}}, kind.beyond);
}

/// Returns the share of a group's width for a box and its neighbours.
double slot(const Boxes& boxes) {
  return boxes.kinds.size() == 1 ? 0.5 : 0.84 / static_cast<double>(boxes.kinds.size());
}

void append_median(double at, double median, double width, VectorsMark& medians) {
  medians.x.push_back(at);
  medians.y.push_back(median);
  medians.dx.push_back(width);
  medians.dy.push_back(0.0);
}

/// Adds the boxes of one kind; collects medians, means and outliers for all kinds.
void draw_kind(const Boxes& boxes, std::size_t index, statistics::Whiskers whiskers, Kind& all,
               PlotBuilder& plot) {
  const double aside =
      slot(boxes) * (static_cast<double>(index) - 0.5 * static_cast<double>(boxes.kinds.size() - 1));
  Kind kind;
  kind.boxes.width = 2.0 * (boxes.kinds.size() == 1 ? 0.25 : 0.43 * slot(boxes));
  kind.boxes.color = curve_color(index);
  if (!boxes.kind_names.empty()) kind.boxes.legend = boxes.kind_names[index];
  for (std::size_t i = 0; i < boxes.groups.size(); ++i) {
    const auto& sample = boxes.groups[i].samples[index];
    if (sample.empty()) continue;
    const double at = static_cast<double>(i + 1) + aside;
    const statistics::BoxSummary box = statistics::box_summary(sample, whiskers);
    append(box, at, kind);
    append_median(at, box.median, kind.boxes.width, all.medians);
  }
  append(kind.means, all.means);
  append(kind.beyond, all.beyond);
  if (!kind.boxes.x.empty()) plot.add(std::move(kind.boxes));
}

/// Draws all boxes first, so that no box covers the marks of another; marks have their text once.
void draw_kinds(const Boxes& boxes, statistics::Whiskers whiskers, PlotBuilder& plot) {
  Kind all;
  for (std::size_t i = 0; i < boxes.kinds.size(); ++i) draw_kind(boxes, i, whiskers, all, plot);
  all.medians.line = {"#111111", 2.4};
  all.medians.pivot = 0.5;
  all.medians.legend = "median";
  plot.add(std::move(all.medians));
  // A dark asterisk differs from all coloured boxes.
  const std::string color = boxes.kinds.size() == 1 ? "#D55E00" : "#111111";
  using Symbol = PointsMark::Symbol;
  plot.add(PointsMark{all.means, Symbol::asterisk, 8.775, 1.5, color, "mean"});
  if (!all.beyond.x.empty())
    plot.add(PointsMark{all.beyond, Symbol::ring, 5.85, 1.2, "#666666", "beyond the whiskers"});
}

/// Returns a dashed line across the box of each y at its first reference value.
LineMark references_of(const Panel& panel, std::span<const record::Recording> recordings,
                       std::size_t groups) {
  LineMark lines{.line = {"#111111", 1.8, {4.0, 3.0}}};
  const auto given = panel.series.find("reference");
  if (given == panel.series.end() || panel.find("by")) return lines;
  const query::Series& first = given->second.front();
  lines.legend = first.label == first.formula.text ? "reference" : first.label;
  for (std::size_t i = 0; i < std::min(given->second.size(), groups); ++i) {
    const geometry::Curve all =
        joined(gather(panel, recording_of(panel, recordings, i), {&given->second[i]}));
    if (all.size() == 0) continue;
    const double at = static_cast<double>(i + 1), value = all.columns[0].front();
    lines.curves.push_back({{at - 0.42, at + 0.42}, {value, value}, {}, {}});
  }
  return lines;
}

void draw_boxes(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const Boxes boxes = boxes_of(panel, recordings);
  query::Series y = panel.series.at("y").front();
  if (panel.series.at("y").size() > 1) y.label = "";
  plot.label("y", y);
  if (const query::Series* by = panel.find("by"))
    plot.spec.x.label = panel.x.label.empty() ? by->label : panel.x.label;
  if (boxes.groups.empty()) return;
  plot.x = {0.4, static_cast<double>(boxes.groups.size()) + 0.6};
  for (const Group& group : boxes.groups)
    for (const auto& sample : group.samples)
      for (const double value : sample) plot.y.add(value);
  LineMark references = references_of(panel, recordings, boxes.groups.size());
  for (const MarkRows& line : references.curves) plot.y.add(line.y.front());
  plot.range("x", plot.x);
  plot.range("y", plot.y.padded(0.06));
  plot.spec.x.grid = false;
  name_groups(boxes.groups, plot.spec.x);
  draw_kinds(
      boxes,
      panel.options<BoxOptions>().tukey_whiskers ? statistics::Whiskers::tukey : statistics::Whiskers::range,
      plot);
  if (!references.curves.empty()) plot.add(std::move(references));
}

}  // namespace

PlotKind box_plot() {
  PlotKind kind{
      "box",
      "box plots: median, mean (asterisk), quartiles after Hazen, whiskers over the full range",
      {{"y", "the values; one expression or a list of them", true, true},
       {"by", "one box for each value of this"},
       {"reference", "for each y a value to hold it against, drawn dashed across its box; not beside `by`",
        false, true},
       {"beside", "boxes for each value of this stand side by side, each in its colour"}},
      {option_key(
          "whiskers",
          "range (over all values), or tukey: to the last value within 1.5 interquartile ranges of the "
          "box; those beyond are drawn",
          yaml::form::word({"range", "tukey"}), &BoxOptions::tukey_whiskers)},
      false,
      draw_boxes};
  kind.lacks = {KeyNeeds::across, KeyNeeds::color_bar};
  return kind;
}

}  // namespace stepwire::plot
