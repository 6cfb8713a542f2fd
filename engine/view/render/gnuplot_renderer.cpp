#include "engine/view/render/gnuplot_renderer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/view/render/gnuplot.hpp"
#include "engine/view/render/gnuplot_axes.hpp"
#include "engine/view/render/gnuplot_marks.hpp"
#include "engine/view/render/gnuplot_text.hpp"
#include "engine/view/render/picture.hpp"
#include "engine/view/svg/text_width.hpp"

namespace stepwire::render {
namespace {

/// Returns the margins. Panels above each other have equal ones, and a colour bar leaves the axes as wide as
/// those without one.
std::string margins(const plot::FigureSpec& figure) {
  if (!figure.aligned) return {};
  const bool colored = std::ranges::any_of(figure.panels, [](const plot::PanelSpec& panel) {
    return std::get<plot::PlotSpec>(panel.content).color.has_value();
  });
  return fmt::format("set lmargin 10\nset rmargin {}\n{}", colored ? 15 : 3,
                     "set colorbox user origin graph 1.02, graph 0 size graph 0.035, graph 1\n");
}

std::string place(const plot::FigureSpec& figure, const plot::PanelSpec& panel, bool equal) {
  return fmt::format("set origin {:.6f},{:.6f}\nset size {}{:.6f},{:.6f}\n", panel.left / figure.width,
                     1.0 - (panel.top + panel.height) / figure.height, equal ? "ratio -1 " : "",
                     panel.width / figure.width, panel.height / figure.height);
}

std::string frame_of(const plot::FigureSpec& figure, const plot::PlotSpec& plot) {
  if (!plot.frame) return {};
  const auto [left, top, width, height] = *plot.frame;
  return fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset tmargin at screen {:.6f}\nset bmargin "
      "at screen {:.6f}\n",
      left / figure.width, (left + width) / figure.width, 1.0 - top / figure.height,
      1.0 - (top + height) / figure.height);
}

std::string title_of(const plot::FigureSpec& figure) {
  return fmt::format(
      "set label {} at screen 0.5, screen {:.6f} center font ',{:.3g}' textcolor rgb '#111111'\n",
      quoted(figure.title), 1.0 - 18.0 / figure.height,
      svg::fitted_size(figure.title, 15.0, figure.width - 20.0));
}

std::string panel_title(const std::string& title, double width) {
  constexpr double aside = 70.0;  // a title is centred above the axes, which are not in the middle
  return title.empty() ? "" : "set title " + fitted_title(title, width - aside) + "\n";
}

std::string marks_of(const plot::PlotSpec& plot, std::size_t panel) {
  GnuplotMarks marks(fmt::format("p{}d", panel));
  for (const plot::PlotMark& mark : plot.marks) std::visit(marks, mark);
  return marks.text(plot.view.has_value());
}

}  // namespace

std::string gnuplot_script(const plot::FigureSpec& figure) {
  std::string script = picture_terminal(figure.width, figure.height) + "set multiplot\n";
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const plot::PanelSpec& panel = figure.panels[i];
    const auto& plot = std::get<plot::PlotSpec>(panel.content);
    script += picture_style() + palette_command(plot) + margins(figure) + place(figure, panel, plot.equal) +
              frame_of(figure, plot);
    if (i == 0 && !figure.title.empty()) script += title_of(figure);
    script += panel_title(plot.title, panel.width) + axes_commands(plot) + text_commands(plot);
    script += marks_of(plot, i);
  }
  return script + "unset multiplot\n";
}

Drawing render_gnuplot(const plot::FigureSpec& figure) {
  GnuplotAnswer answer = run_gnuplot(gnuplot_script(figure));
  const bool has_color_scale = std::ranges::any_of(figure.panels, [](const plot::PanelSpec& panel) {
    return std::get<plot::PlotSpec>(panel.content).color.has_value();
  });
  return {finished_picture(std::move(answer.output), figure.title, has_color_scale),
          std::move(answer.complaints)};
}

}  // namespace stepwire::render
