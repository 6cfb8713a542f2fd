// Texts that are written for gnuplot; drawing_test.cpp checks that gnuplot draws them.
#include "engine/view/render/gnuplot_renderer.hpp"
#include "engine/view/render/render.hpp"

#include <regex>

#include "engine/view/render/gnuplot.hpp"
#include "engine/view/render/gnuplot_text.hpp"
#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::render {
using namespace testing;
using Catch::Contains;

namespace {

plot::FigureSpec figure_of(plot::PlotSpec plot) {
  return {"", 600.0, 400.0, false, {{0.0, 0.0, 600.0, 400.0, std::move(plot)}}};
}

/// The places of a text's left ends in a picture.
std::vector<double> places_of(const std::string& svg, const std::string& text) {
  const std::regex place(R"(translate\(([0-9.]+),[^>]*>\s*<text>)" + text + "</text>");
  std::vector<double> places;
  for (std::sregex_iterator match(svg.begin(), svg.end(), place), none; match != none; ++match)
    places.push_back(std::stod((*match)[1]));
  return places;
}

}  // namespace

TEST_CASE("a legend above rows with long names stays in the picture") {
  if (!has_gnuplot()) return;
  plot::PlotSpec plot{
      .x = {.range = {{0.0, 1.0}}},
      .y = {.range = {{1.6, -0.6}}, .named_ticks = {{0.0, "an unknown with a name of many words"}}},
      .legend = plot::PlotSpec::Legend::above};
  for (const char* legend : {"first of its values", "last of its values", "all of the file"})
    plot.marks.push_back(plot::LineMark{{{{0.0, 1.0}, {0.0, 1.0}, {}, {}}}, {"#123456"}, 0.0, legend});
  const std::string svg = render(figure_of(std::move(plot))).svg;
  const std::vector<double> last = places_of(svg, "all of the file");
  REQUIRE(last.size() == 1);
  CHECK(last[0] + 6.0 * 15.0 < 600.0);  // letters of a font of 12 px
  CHECK(places_of(svg, "first of its values").at(0) > 0.0);
}

TEST_CASE("a mark that is put together by hand is drawn with its numbers, colour and dash") {
  const plot::LineMark line{{{{0.0, 1.0}, {2.0, 0.5}, {}, {}}}, {"#123456", 1.5, {2.5, 4.0}}, 0.0, "it's"};
  const std::string script =
      gnuplot_script(figure_of({.x = {.range = {{0.0, 1.0}}, .step = 0.5}, .marks = {line}}));
  CHECK_THAT(script,
             Contains("$p0d0 << EOD\n0 2\n1 0.5\nEOD\n") &&
                 Contains("plot $p0d0 using 1:2 with lines lw 1.5 dt (5,8) lc rgb '#123456' title 'it’s'") &&
                 Contains("set xrange [0:1]\nset xtics 0.5\n"));
}

TEST_CASE(
    "panels above each other have a margin for the longest number, so that labels beside it are whole") {
  const auto margin = [](double low, double high) {
    plot::FigureSpec figure = figure_of({.x = {.range = {{0.0, 1.0}}}, .y = {.range = {{low, high}}}});
    figure.aligned = true;
    const std::string script = gnuplot_script(figure);
    const std::size_t at = script.find("set lmargin ");
    REQUIRE(at != std::string::npos);
    return std::stoi(script.substr(at + 12));
  };
  CHECK(margin(0.0, 0.07) == 10);      // 0.01, 0.02, ..
  CHECK(margin(-0.024, 0.013) == 11);  // -0.02, -0.015, ..
  CHECK(margin(-20.0, 20.0) == 10);
  CHECK(margin(1.6, -0.6) == 10);  // from top to bottom
  CHECK(margin(0.0, 0.0) == 10);
  CHECK(margin(123456.0, 123460.0) == 11);
}

TEST_CASE("a line in space is drawn over a surface") {
  if (!has_gnuplot()) return;
  const std::vector<double> ends{0.0, 1.0};
  const plot::SurfaceMark surface{
      {{ends, {0.0, 0.0}, ends, {1.0, 2.0}}, {ends, {1.0, 1.0}, ends, {3.0, 4.0}}}};
  const plot::LineMark line{{{ends, {0.5, 0.5}, ends, {}}}, {"#123456"}};
  plot::PlotSpec plot{.z = plot::PlotAxis{.range = {{0.0, 1.0}}},
                      .view = plot::SpaceView{60.0, 30.0},
                      .marks = {surface, line}};
  plot.x.range = plot.y.range = {{0.0, 1.0}};
  const std::string svg = render(figure_of(std::move(plot))).svg;
  const std::size_t piece = svg.find("<polygon"), drawn = svg.find("rgb( 18,  52,  86)");
  REQUIRE(piece != std::string::npos);
  REQUIRE(drawn != std::string::npos);
  CHECK(piece < drawn);
}

TEST_CASE("texts, labels and colours never become commands, not even in titles that are too wide") {
  const std::string bad =
      "a long title `touch no` that breaks in two \"lines\" 'here' and \\there, $(touch no) or not at all";
  plot::PlotSpec plot{.title = bad, .x = {.label = bad, .range = {{0.0, 1.0}}, .named_ticks = {{0.5, bad}}}};
  plot.texts.push_back({.text = bad});
  plot.marks.push_back(plot::LineMark{{{{0.0, 1.0}, {0.0, 1.0}, {}, {}}}, {"'; system 'touch no"}, 0.0, bad});
  plot::FigureSpec figure = figure_of(std::move(plot));
  figure.panels.front().width = 200.0;
  const std::string script = gnuplot_script(figure);
  // In single quotes nothing has a meaning but the quote itself, of which none is left inside.
  std::string outside;
  bool quoted = false;
  for (const char c : script) {
    if (c == '\'') quoted = !quoted;
    if (!quoted) outside += c;
  }
  CHECK_THAT(outside, !Contains("touch") && !Contains("`"));
  CHECK_THAT(script, Contains("set title sprintf(\"%s\\n%s\", 'a long title `touch no`"));
  std::get<plot::LineMark>(std::get<plot::PlotSpec>(figure.panels.front().content).marks.front()).line.color =
      "#123456";
  if (has_gnuplot()) CHECK_THAT(render(figure).svg, Contains("`touch no`"));
}

TEST_CASE("on a dark screen a picture with a scale of colours keeps them, and another one is turned round") {
  if (!has_gnuplot()) return;
  plot::PlotSpec plot{.x = {.range = {{0.0, 1.0}}}, .y = {.range = {{0.0, 1.0}}}};
  plot.marks.push_back(plot::LineMark{{{{0.0, 1.0}, {0.0, 1.0}, {}, {}}}, {"#123456"}, 0.0, ""});
  CHECK_THAT(render(figure_of(plot)).svg, Contains("prefers-color-scheme: dark") && Contains("invert("));
  plot.color = {.range = {{0.0, 1.0}}};
  CHECK_THAT(render(figure_of(plot)).svg, Contains("prefers-color-scheme: dark") && !Contains("invert("));
}

TEST_CASE("one row of cells is drawn as two halves of it, which gnuplot does not refuse") {
  const plot::ImageMark image{0.5, 0.5, 1.0, 1.0, 2, 1, {7.0, 8.0}};
  CHECK_THAT(gnuplot_script(figure_of({.marks = {image}})),
             Contains("0.5 0.25 7\n1.5 0.25 8\n0.5 0.75 7\n1.5 0.75 8\n"));
}

}  // namespace stepwire::render
