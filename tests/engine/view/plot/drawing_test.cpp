#include <catch2/catch.hpp>
#include <cstdlib>

#include "engine/base/io/environment_error.hpp"
#include "engine/view/render/gnuplot.hpp"
#include "engine/view/render/render.hpp"
#include "tests/engine/view/plot/every_kind.hpp"

namespace stepwire::plot {
using namespace testing;

namespace {

bool gnuplot_is_missing() {
  if (render::has_gnuplot()) return false;
  WARN("gnuplot is not installed; nothing was drawn");
  return true;
}

std::string drawn(const std::string& text, int rows = 200) {
  const auto read = figures_of(text);
  INFO(read.faults);
  REQUIRE(read.faults.empty());
  const render::Drawing drawing = render::draw(read.figures.at(0), sample_recordings({0.1, 0.2, 0.3}, rows));
  CHECK(drawing.warnings == "");
  return drawing.svg;
}

/// Whether a text is XML: read by the document's own parser, since every element is opened and closed.
bool is_well_formed(const std::string& svg) {
  std::vector<std::string> open;
  for (std::size_t at = 0; (at = svg.find('<', at)) != std::string::npos; ++at) {
    if (svg.compare(at, 4, "<!--") == 0) {
      at = svg.find("-->", at);
      continue;
    }
    const std::size_t end = svg.find('>', at);
    if (end == std::string::npos) return false;
    if (svg[at + 1] == '?' || svg[at + 1] == '!' || svg[end - 1] == '/') continue;
    const bool closes = svg[at + 1] == '/';
    const std::size_t start = at + (closes ? 2 : 1);
    const std::string name = svg.substr(start, svg.find_first_of(" \t\n>", start) - start);
    if (!closes)
      open.push_back(name);
    else if (open.empty() || open.back() != name)
      return false;
    else
      open.pop_back();
  }
  return open.empty() && svg.find("</svg>") != std::string::npos;
}

}  // namespace

TEST_CASE("every kind of plot is a well-formed picture with the units of its axes") {
  if (gnuplot_is_missing()) return;
  for (const auto& text : every_kind) {
    INFO(text);
    const std::string svg = drawn(text);
    CHECK(is_well_formed(svg));
    CHECK(svg.size() < 500'000);
    if (text.find("current, y") == std::string::npos) CHECK_THAT(svg, Catch::Contains("[mm]"));
  }
}

TEST_CASE("final rows keep their points where these lie on a straight line") {
  if (gnuplot_is_missing()) return;
  const std::string svg = drawn("{plot: lines, x: current, y: push.force, rows: final}");
  std::size_t points = 0;
  for (std::size_t at = 0;
       (at = svg.find("<use xlink:href='#gpPt6' transform='translate", at)) != std::string::npos; ++at)
    ++points;
  CHECK(points == 3);
}

TEST_CASE("every kind of plot is drawn where no row is left, or a single one") {
  if (gnuplot_is_missing()) return;
  for (const std::string where : {"time < 0", "time == 0", "time == 0 && current < 0.15"})
    for (auto text : every_kind) {
      text.insert(text.size() - 1, ", where: \"" + where + "\"");
      INFO(text);
      CHECK(is_well_formed(drawn(text)));
    }
}

TEST_CASE("boxes side by side are named in the legend, and values beyond the whiskers have their mark") {
  if (gnuplot_is_missing()) return;
  const std::string whiskers =
      "{plot: box, y: \"rig.x*rig.x*rig.x*rig.x*rig.x*rig.x*rig.x\", by: current, beside: {signal: rig.v > "
      "0, "
      "label: forth}, whiskers: ";
  const std::string tukey = drawn(whiskers + "tukey}"), range = drawn(whiskers + "range}");
  for (const std::string text : {"forth 0", "forth 1", "median", "mean"})
    CHECK_THAT(range, Catch::Contains("<text>" + text + "</text>"));
  CHECK_THAT(tukey, Catch::Contains("beyond the whiskers"));
  CHECK_THAT(range, !Catch::Contains("beyond the whiskers"));
}

TEST_CASE("the same data give the same bits") {
  if (gnuplot_is_missing()) return;
  for (const auto& text : every_kind) CHECK(drawn(text) == drawn(text));
}

TEST_CASE("texts are shown as they are written") {
  if (gnuplot_is_missing()) return;
  const std::string svg = drawn(
      "{plot: lines, x: time, y: {signal: rig.x, label: \"a_b^2 {x} <&>\"}, title: \"it's `date` $HOME "
      "@x\"}");
  CHECK_THAT(svg, Catch::Contains("a_b^2 {x} &lt;&amp;> [m]"));
  CHECK_THAT(svg, Catch::Contains("`date` $HOME @x"));
}

TEST_CASE("a logarithmic axis of less than two decades has more labels than its powers of ten") {
  if (gnuplot_is_missing()) return;
  const std::string svg = drawn("{plot: lines, x: time, y: rig.x, x_range: [0.1, 0.3], log: x}");
  CHECK_THAT(svg, Catch::Contains("<text>0.1</text>") && Catch::Contains("<text>0.2</text>"));
}

TEST_CASE("panels share a picture, each with its title") {
  if (gnuplot_is_missing()) return;
  const std::string svg = drawn(
      "{title: all, columns: 2, panels: [{plot: lines, x: time, y: rig.x, title: left one}, {plot: strip, x: "
      "rig.x in "
      "mm, color: push.force, title: right one}, {plot: box, y: rig.v, title: last one}]}");
  for (const std::string text : {">all<", ">left one<", ">right one<", ">last one<"})
    CHECK_THAT(svg, Catch::Contains(text));
}

TEST_CASE("a large record gives a small picture", "[full]") {
  if (gnuplot_is_missing()) return;
  CHECK(drawn("{plot: lines, x: time, y: \"rig.x*sin(1e7*time*time)\"}", 100'000).size() < 500'000);
  CHECK(drawn("{plot: path, x: time, y: rig.x, color: \"sin(1e7*time*time)\"}", 100'000).size() < 500'000);
}

TEST_CASE("what gnuplot complains of is told") {
  if (gnuplot_is_missing()) return;
  CHECK_THROWS_WITH(render::run_gnuplot("plot nonsense of mine\n"), Catch::Contains("gnuplot failed: "));
  CHECK(render::run_gnuplot("printerr 'careful'\n").complaints == "careful");
  CHECK(render::run_gnuplot("print 'x'\n").output.empty());
}

TEST_CASE("a missing gnuplot is a fault of the surroundings that names the package") {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nonexistent", 1);
  CHECK_FALSE(render::has_gnuplot());
  CHECK_THROWS_AS(render::run_gnuplot(""), io::EnvironmentError);
  CHECK_THROWS_WITH(render::run_gnuplot(""),
                    "gnuplot is not installed; on Debian it is the package gnuplot-nox");
  ::setenv("PATH", path.c_str(), 1);
}

TEST_CASE("a boundary takes what is recorded from the first row that is selected") {
  if (gnuplot_is_missing()) return;
  const std::string plot =
      "{plot: path, x: time, y: rig.x, color: rig.v, where: current > 0.15 A, boundary: ";
  CHECK(drawn(plot + "x - 0.1*current/0.2 A}") == drawn(plot + "x - 0.1}"));
  CHECK(drawn(plot + "x - 0.1*current/0.3 A}") != drawn(plot + "x - 0.1}"));
}

TEST_CASE("a note tells a value of the first row that is selected, in its unit") {
  if (gnuplot_is_missing()) return;
  const std::string svg = drawn(
      "{plot: lines, x: time, y: rig.x, where: current > 0.15 A, note: {signal: current in mA, label: at}}");
  CHECK(svg.find("at 200 mA") != std::string::npos);
}

TEST_CASE("a reference is dashed, and has the unit of its axis") {
  if (gnuplot_is_missing()) return;
  const std::string plot = "{plot: lines, x: time, y: rig.x in mm";
  CHECK(drawn(plot + ", reference: 1 mm}").find("stroke-dasharray") != std::string::npos);
  CHECK(drawn(plot + "}").find("stroke-dasharray") == std::string::npos);
  CHECK(figures_of(plot + ", reference: push.force}").faults.find("one axis has one unit") !=
        std::string::npos);
}

}  // namespace stepwire::plot
