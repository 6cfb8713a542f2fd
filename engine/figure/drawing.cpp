#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/gnuplot.hpp"
#include "engine/figure/grid.hpp"
#include "engine/figure/mark_drawing.hpp"
#include "engine/figure/motion_drawing.hpp"
#include "engine/figure/number.hpp"
#include "engine/figure/picture.hpp"
#include "engine/figure/plot_kind.hpp"
#include "engine/figure/region_drawing.hpp"
#include "engine/figure/rose_drawing.hpp"
#include "engine/figure/run_rows.hpp"
#include "engine/figure/script.hpp"
#include "engine/figure/text_width.hpp"
#include "engine/figure/ticks.hpp"

namespace stepwire {
namespace {

/// What the variables of a formula are in the first row that the panel selects, 0 for what is no column; none
/// where no row is selected.
std::optional<std::vector<double>> first_row(const Formula& formula, const Panel& panel,
                                             std::span<const Recording> recordings) {
  std::vector<double> values(formula.columns.size(), 0.0);
  if (std::ranges::all_of(formula.columns, [](const auto& name) { return name == "x" || name == "y"; }))
    return values;
  const Recording& recording = recordings[formula.recording.value_or(0)];
  const RunRows rows = rows_of_run(panel.where, recording);
  if (rows.none()) return std::nullopt;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const Column* column = recording.table.find(formula.columns[i]))
      values[i] = column->values[rows.first];
  return values;
}

/// Tells the value of the panel's note in its upper left corner.
void draw_note(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  const Series* note = panel.find("note");
  if (!note) return;
  const auto values = first_row(note->formula, panel, recordings);
  if (!values) return;
  const double value = note->unit.from_si(note->formula.expression(*values));
  const bool has_unit = !note->unit_text.empty() && note->unit_text != "1";
  script.set(
      fmt::format("set label {} at graph 0.03, graph 0.95 left front textcolor rgb '#111111' font ',13'",
                  quoted(fmt::format("{} {}{}{}", note->label, short_number(value), has_unit ? " " : "",
                                     has_unit ? note->unit_text : ""))));
}

/// Curves where the boundaries of the panel are zero, over the plane that is shown.
void draw_boundaries(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  constexpr std::size_t cells = 240;
  const Series *across = panel.find("x"), *up = panel.find("y");
  if (script.x.empty() || script.y.empty()) return;
  for (const Formula& boundary : panel.boundaries) {
    Grid grid{script.x.low,
              script.y.low,
              (script.x.high - script.x.low) / (cells - 1),
              (script.y.high - script.y.low) / (cells - 1),
              cells,
              cells,
              std::vector<double>(cells * cells)};
    auto row_values = first_row(boundary, panel, recordings);
    if (!row_values) continue;
    std::vector<double>& values = *row_values;
    for (std::size_t row = 0; row < cells; ++row)
      for (std::size_t column = 0; column < cells; ++column) {
        const double x = grid.x + static_cast<double>(column) * grid.dx;
        const double y = grid.y + static_cast<double>(row) * grid.dy;
        for (std::size_t i = 0; i < values.size(); ++i) {
          if (boundary.columns[i] == "x") values[i] = across ? across->unit.to_si(x) : x;
          if (boundary.columns[i] == "y") values[i] = up != nullptr ? up->unit.to_si(y) : y;
        }
        grid.at(column, row) = boundary.expression(values);
      }
    const auto curves = contour(grid, 0.0);
    if (!curves.empty()) script.plot(script.data(curves) + " using 1:2 with lines lc rgb '#111111' lw 1.6");
  }
}

constexpr std::size_t most_above = 4;

/// The legend stands above the axes while it is short, else beside them: it never covers a curve.
std::string legend_place(std::size_t titles) {
  if (titles == 0) return "set key off\n";
  return titles <= most_above ? "set key outside top center horizontal Left reverse\n"
                              : "set key outside right center vertical Left reverse\n";
}

struct DrawnPanel {
  Script script;
  std::string commands;
  double height = 0.0;  ///< pixels
  std::size_t titles = 0;
};

/// Pixels for labels and a colour bar beside the axes, and for labels below and above them.
constexpr double room_across = 150.0, room_up = 80.0;
/// A title is centred above the axes, which are not in the middle of the panel.
constexpr double title_aside = 70.0;

double wanted_height(const Script& script, double width) {
  if (script.height > 0.0) return script.height;
  if (script.space) return 0.8 * width;
  if (!script.panel().equal || script.x.empty() || script.y.empty()) return 0.66 * width;
  const double ratio = (script.y.high - script.y.low) / (script.x.high - script.x.low);
  return std::clamp((width - room_across) * ratio + room_up, 0.3 * width, 1.2 * width);
}

DrawnPanel draw_panel(const Figure& figure, std::span<const Recording> recordings, std::size_t index,
                      double width) {
  const Panel& panel = figure.panels[index];
  Script script(panel, fmt::format("p{}d", index));
  script.share = 1.0 / static_cast<double>(figure.panels.size());
  const auto title = panel.words.find("title");
  if (title != panel.words.end()) script.set("set title " + fitted_title(title->second, width - title_aside));
  cover_regions(panel, script);
  cover_marks(panel, script);
  cover_motions(panel, recordings, script);
  cover_roses(panel, script);
  panel.kind->draw(panel, recordings, script);
  draw_boundaries(panel, recordings, script);
  draw_note(panel, recordings, script);
  draw_motions(panel, recordings, script);
  draw_regions(panel, script);
  draw_roses(panel, recordings, script);
  const double height = wanted_height(script, width);
  draw_marks(panel, {width - room_across, height - room_up}, script);
  draw_texts(panel, script);
  std::string commands = legend_place(script.titles()) + script.text();
  const std::size_t titles = script.titles();
  return {std::move(script), std::move(commands), height, titles};
}

/// Rows of panels, each as high as its highest panel.
struct Layout {
  double width = 0.0, height = 0.0, head = 0.0;
  std::vector<double> heights;
};

Layout lay_out(const Figure& figure, const std::vector<DrawnPanel>& panels, double panel_width) {
  Layout layout{panel_width * figure.columns, 0.0, figure.title.empty() ? 0.0 : 34.0, {}};
  for (std::size_t i = 0; i < panels.size(); i += static_cast<std::size_t>(figure.columns)) {
    double height = 0.0;
    for (std::size_t j = i; j < std::min(panels.size(), i + static_cast<std::size_t>(figure.columns)); ++j)
      height = std::max(height, panels[j].height);
    layout.heights.push_back(height);
    layout.height += height;
  }
  if (figure.height > 0) {
    const double scale = (figure.height - layout.head) / layout.height;
    for (double& height : layout.heights) height *= scale;
    layout.height = figure.height - layout.head;
  }
  layout.height += layout.head;
  return layout;
}

/// Panels above each other have their axes in line; not where a legend stands beside one of them.
std::string margins(const Figure& figure, const std::vector<DrawnPanel>& panels) {
  if (figure.columns != 1 || panels.size() < 2) return {};
  bool colored = false;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (panels[i].titles > most_above || figure.panels[i].kind->name == "3d") return {};
    colored = colored || figure.panels[i].find("color") != nullptr;
  }
  // A colour bar of its own place leaves the axes as wide as those without one.
  return fmt::format("set lmargin 10\nset rmargin {}\n{}", colored ? 15 : 3,
                     "set colorbox user origin graph 1.02, graph 0 size graph 0.035, graph 1\n");
}

std::string place_panel(const Figure& figure, const Layout& layout, std::size_t index) {
  const auto columns = static_cast<std::size_t>(figure.columns);
  double top = layout.head;
  for (std::size_t row = 0; row < index / columns; ++row) top += layout.heights[row];
  const double height = layout.heights[index / columns];
  const double left = static_cast<double>(index % columns) / static_cast<double>(columns);
  return fmt::format("set origin {:.6f},{:.6f}\nset size {}{:.6f},{:.6f}\n", left,
                     1.0 - (top + height) / layout.height, figure.panels[index].equal ? "ratio -1 " : "",
                     1.0 / static_cast<double>(columns), height / layout.height);
}

}  // namespace

Drawing draw(const Figure& figure, std::span<const Recording> recordings) {
  if (!figure.panels.empty() && figure.panels.front().picture)
    return {figure.panels.front().picture(recordings), ""};
  const double usual = figure.columns == 1 ? 680.0 : figure.columns == 2 ? 520.0 : 400.0;
  const double panel_width = figure.width > 0 ? static_cast<double>(figure.width) / figure.columns : usual;
  std::vector<DrawnPanel> panels;
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    panels.push_back(draw_panel(figure, recordings, i, panel_width));
  const Layout layout = lay_out(figure, panels, panel_width);
  std::string script = picture_terminal(layout.width, layout.height) + "set multiplot\n";
  for (std::size_t i = 0; i < panels.size(); ++i) {
    script += picture_style() + margins(figure, panels) + place_panel(figure, layout, i);
    if (i == 0 && !figure.title.empty())
      script += fmt::format(
          "set label {} at screen 0.5, screen {:.6f} center font ',{:.3g}' textcolor rgb '#111111'\n",
          quoted(figure.title), 1.0 - 18.0 / layout.height,
          fitted_size(figure.title, 15.0, layout.width - 20.0));
    const double height = layout.heights[i / static_cast<std::size_t>(figure.columns)];
    script += ticks_apart(panels[i].script, axes_size(panels[i].script, panel_width, height));
    script += panels[i].commands;
  }
  const GnuplotAnswer answer = run_gnuplot(script + "unset multiplot\n");
  return {finished_picture(answer.output, figure.title), answer.complaints};
}

}  // namespace stepwire
