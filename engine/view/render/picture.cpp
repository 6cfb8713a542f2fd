#include "engine/view/render/picture.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cstddef>

#include "engine/view/svg/svg.hpp"

namespace stepwire::render {
namespace {

/// Begin of the text after an index. Without the second attribute librsvg drops a leading blank.
constexpr const char* back = "<tspan dy=\"-3\" xml:space=\"preserve\">";

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

bool is_capital(char c) {
  return c >= 'A' && c <= 'Z';
}

/// Returns the length of the index after the underscore at `at`; 0 if it is not in a quantity.
std::size_t index_length(const std::string& label, std::size_t at) {
  std::size_t start = at;
  while (start > 0 && is_word(label[start - 1])) --start;
  const std::size_t letters = at - start;
  if (letters < 1 || letters > 2 || !is_capital(label[start]) || !is_capital(label[at - 1])) return 0;
  std::size_t end = at + 1;
  while (end < label.size() && is_word(label[end])) ++end;
  const std::size_t length = end - at - 1;
  return length >= 1 && length <= 3 && label.find_first_of("_.", at + 1) >= end ? length : 0;
}

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

std::string with_subscripts(const std::string& label) {
  for (std::size_t at = label.find('_'); at != std::string::npos; at = label.find('_', at + 1)) {
    const std::size_t length = index_length(label, at);
    if (length == 0) continue;
    const std::string rest = label.substr(at + 1 + length);
    return label.substr(0, at) + "<tspan dy=\"3\" font-size=\"0.75em\">" + label.substr(at + 1, length) +
           "</tspan>" + (rest.empty() ? "" : back + with_subscripts(rest) + "</tspan>");
  }
  return label;
}

void set_subscripts(std::string& svg) {
  const std::string begin = "<text>", end = "</text>";
  for (std::size_t at = 0; (at = svg.find(begin, at)) != std::string::npos;) {
    at += begin.size();
    const std::size_t length = svg.find(end, at) - at;
    const std::string label = svg.substr(at, length), set = with_subscripts(label);
    if (set != label) svg.replace(at, length, set);
    at += set.size();
  }
}

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
