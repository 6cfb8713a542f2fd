#include "engine/view/render/picture.hpp"

#include <fmt/format.h>

#include "engine/view/render/subscripts.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::render {
namespace {

constexpr const char* style = R"(reset
set border 3 lc rgb '#8a8a8a' lw 0.8
set tics nomirror out scale 0.6 textcolor rgb '#333333'
set grid back lt 1 lc rgb '#e4e4e4' lw 0.7
set format '%h'
set xlabel textcolor rgb '#111111'
set ylabel textcolor rgb '#111111'
set zlabel textcolor rgb '#111111'
set cblabel textcolor rgb '#111111' offset 1.2,0
set title textcolor rgb '#111111' font ',14'
set minussign
set key noenhanced samplen 2.2 spacing 1.15 textcolor rgb '#222222' font ',12'
set colorbox noborder
set clip two
)";

/// Removes the titles that gnuplot gives its plots, "gnuplot_plot_1", which browsers show as tooltips.
void remove_hints(std::string& svg) {
  const std::string begin = "<title>gnuplot_plot_", end = "</title>";
  for (std::size_t at = 0; (at = svg.find(begin, at)) != std::string::npos;)
    svg.erase(at, svg.find(end, at) + end.size() - at);
}

}  // namespace

std::string picture_style() {
  return style;
}

std::string picture_terminal(double width, double height) {
  return fmt::format(
      "set encoding utf8\nset terminal svg size {:.0f},{:.0f} noenhanced rounded font 'Helvetica,13' "
      "background '#ffffff'\n",
      width, height);
}

std::string finished_picture(std::string svg, const std::string& title, bool has_color_scale) {
  text::replace_all(svg, "font-family=\"Helvetica\"", "font-family=\"Helvetica, Arial, sans-serif\"");
  text::replace_all(svg, "stroke=\"none\" fill=\"rgb(16,16,16)\"",
                    "stroke=\"#ffffff\" stroke-width=\"3\" style=\"paint-order:stroke\" fill=\"#101010\"");
  text::replace_all(svg, "<image ", "<image style='image-rendering:pixelated' ");
  remove_hints(svg);
  set_subscripts(svg);
  text::replace_all(svg, "<title>Gnuplot</title>",
                    "<title>" + svg::markup_escaped(title) + "</title>" +
                        (has_color_scale ? svg::dimmed_style : svg::dark_style));
  return svg;
}

}  // namespace stepwire::render
