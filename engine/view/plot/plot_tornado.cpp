#include <cmath>
#include <map>

#include "engine/model/diagram/sweep.hpp"
#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

constexpr double tornado_row = 44.0, tornado_frame = 130.0;  // [pixels]
constexpr double half_tornado_bar = 0.36;                    // [rows]

/// Value of a parameter, and the resulting outcome.
struct Setting {
  std::string text;
  double outcome = 0.0;
};

/// Effect of one unknown on the outcome.
struct Swing {
  std::string name;
  std::vector<Setting> settings;  ///< in the order of the file
};

/// Mean over the rows of one setting, such as several experiments.
struct Mean {
  std::string of, to;
  double sum = 0.0, count = 0.0;

  double value() const { return sum / count; }
};

/// Returns the last row of each run among those that `where` selects.
std::vector<std::size_t> final_rows(const Panel& panel, const record::Recording& recording) {
  const std::size_t rows = recording.table.rows();
  const std::vector<double> where =
      panel.where ? query::evaluate(*panel.where, recording) : std::vector<double>(rows, 1.0);
  std::vector<std::size_t> last;
  for (std::size_t run = 0; run < recording.starts.size(); ++run) {
    const std::size_t end = run + 1 < recording.starts.size() ? recording.starts[run + 1] : rows;
    for (std::size_t row = end; row-- > recording.starts[run];)
      if (where[row] != 0.0 && !std::isnan(where[row])) {
        last.push_back(row);
        break;
      }
  }
  return last;
}

/// Returns the outcome of each setting, in the order of the sweep.
std::vector<Mean> means_of(const Panel& panel, const record::Recording& recording) {
  const query::Series &x = *panel.find("x"), &by = *panel.find("by"), &to = *panel.find("to");
  const auto outcome = query::evaluate(x.formula, recording), of = query::evaluate(by.formula, recording),
             what = query::evaluate(to.formula, recording);
  std::vector<Mean> means;
  std::map<std::pair<double, double>, std::size_t> known;
  for (const std::size_t row : final_rows(panel, recording)) {
    const double value = x.unit.from_si(outcome[row]);
    if (!std::isfinite(value)) continue;
    const auto [at, is_new] = known.try_emplace({of[row], what[row]}, means.size());
    if (is_new)
      means.push_back(
          {labels_of(by, {of[row]}, recording).front(), labels_of(to, {what[row]}, recording).front()});
    means[at->second].sum += value;
    means[at->second].count += 1.0;
  }
  return means;
}

geometry::Extent reach(const Swing& swing, double base) {
  geometry::Extent extent{base, base};
  for (const Setting& setting : swing.settings) extent.add(setting.outcome);
  return extent;
}

/// Returns the swings, widest first; in the order of the file for equal widths.
std::vector<Swing> swings_of(const std::vector<Mean>& means, double base) {
  std::vector<Swing> swings;
  for (const Mean& mean : means) {
    if (mean.of == diagram::nothing_differs) continue;
    if (swings.empty() || swings.back().name != mean.of) swings.push_back({mean.of, {}});
    swings.back().settings.push_back({mean.to, mean.value()});
  }
  std::ranges::stable_sort(swings, std::ranges::greater{},
                           [&](const Swing& swing) { return reach(swing, base).width(); });
  return swings;
}

/// Returns the text of a value at the end of its bar.
TextMark end_text(const Setting& setting, double base, double y) {
  const bool left = setting.outcome < base;
  return {.text = setting.text,
          .x = setting.outcome,
          .y = y,
          .align = left ? TextMark::Align::right : TextMark::Align::left,
          .offset = {left ? -0.6 : 0.6, 0.0},
          .size = 11.0,
          .color = "#333333"};
}

/// Draws a swing. Each value has its share of the row's height, so that no bar hides another one.
void draw_swing(const Swing& swing, double row, double base, std::vector<RectanglesMark>& bars,
                PlotBuilder& plot) {
  const double height = 2.0 * half_tornado_bar / static_cast<double>(swing.settings.size());
  for (std::size_t i = 0; i < swing.settings.size(); ++i) {
    const Setting& setting = swing.settings[i];
    RectanglesMark& bar = bars[i == 0 ? 0 : i + 1 == swing.settings.size() ? 1 : 2];
    const double top = row - half_tornado_bar + static_cast<double>(i) * height;
    bar.x_low.push_back(std::min(base, setting.outcome));
    bar.x_high.push_back(std::max(base, setting.outcome));
    bar.y_low.push_back(top);
    bar.y_high.push_back(top + height);
    plot.spec.texts.push_back(end_text(setting, base, top + 0.5 * height));
  }
}

void name_rows(const std::vector<Swing>& swings, const Panel& panel, PlotAxis& axis) {
  const auto rows = static_cast<double>(swings.size());
  axis = {.range = {{rows - 0.4, -0.6}}, .line = false, .tick_marks = false, .grid = false};
  for (std::size_t i = 0; i < swings.size(); ++i) {
    const auto given = panel.names.find(swings[i].name);
    axis.named_ticks.push_back(
        {static_cast<double>(i), given == panel.names.end() ? swings[i].name : given->second});
  }
}

void draw_swings(const std::vector<Swing>& swings, double base, PlotBuilder& plot) {
  std::vector<RectanglesMark> bars{{.color = curve_color(0), .legend = "first of its values"},
                                   {.color = curve_color(1), .legend = "last of its values"},
                                   {.color = "#999999", .legend = "between"}};
  for (std::size_t i = 0; i < swings.size(); ++i)
    draw_swing(swings[i], static_cast<double>(i), base, bars, plot);
  for (RectanglesMark& bar : bars)
    if (!bar.x_low.empty()) plot.add(std::move(bar));
  plot.add(LineMark{{{{base, base}, {-0.6, static_cast<double>(swings.size()) - 0.4}, {}, {}}},
                    {"#111111", 2.0},
                    0.0,
                    "the file's values"});
}

void draw_tornado(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  plot.label("x", *panel.find("x"));
  const std::vector<Mean> means = means_of(panel, recording_of(panel, recordings));
  const auto base = std::ranges::find(means, std::string(diagram::nothing_differs), &Mean::of);
  if (base == means.end()) return;
  const std::vector<Swing> swings = swings_of(means, base->value());
  geometry::Extent extent{base->value(), base->value()};
  for (const Swing& swing : swings)
    for (const Setting& setting : swing.settings) extent.add(setting.outcome);
  plot.range("x", extent.padded(0.2));  // space for the texts of the values
  name_rows(swings, panel, plot.spec.y);
  plot.height = tornado_frame + tornado_row * static_cast<double>(swings.size());
  draw_swings(swings, base->value(), plot);
}

}  // namespace

PlotKind tornado_plot() {
  PlotKind kind{
      "tornado",
      "what each unknown does to an outcome, the widest bar on top: one parameter at a time differs from "
      "the file's value, by `sweep: {one_at_a_time: ..}`. An outcome is the last row of a run, of several "
      "experiments their mean",
      {{"x", "the outcome", true},
       {"by", "which parameter differs", false, false, diagram::differs_label},
       {"to", "its value", false, false, diagram::differs_to_label}},
      {{"names", "what the parameters are called: {half_width: width of the corridor}",
        yaml::form::names(yaml::form::text(), 1),
        [](Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
          for (const yaml::Entry& entry : node.entries)
            panel.names[entry.key] = yaml::below(read, entry.key).text(entry.value);
        }}},
      false,
      draw_tornado};
  kind.last_rows = true;
  kind.lacks = {KeyNeeds::rows, KeyNeeds::legend, KeyNeeds::up, KeyNeeds::color_bar};
  return kind;
}

}  // namespace stepwire::plot
