#include "engine/view/plot/ticks.hpp"
#include "engine/view/render/render.hpp"

#include <catch2/catch.hpp>
#include <regex>

#include "engine/view/geometry/grid.hpp"
#include "engine/view/render/gnuplot.hpp"
#include "engine/view/render/gnuplot_text.hpp"
#include "engine/view/svg/svg.hpp"
#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::plot {
using namespace testing;
using Catch::Contains;

namespace {

std::string drawn(const std::string& text) {
  const auto read = figures_of(text);
  INFO(read.faults);
  REQUIRE(read.faults.empty());
  return render::draw(read.figures.at(0), sample_recordings({0.1, 0.2}, 200)).svg;
}

/// The texts of a picture with their places: "<text>TEXT</text>" behind "translate(X,Y)".
struct Text {
  double x, y;
  std::string words;
};

std::vector<Text> texts(const std::string& svg) {
  static const std::regex text("translate\\(([-\\d.]+),([-\\d.]+)\\)[^>]*>\\s*<text>([^<]*)</text>");
  std::vector<Text> found;
  for (std::sregex_iterator match(svg.begin(), svg.end(), text), none; match != none; ++match)
    found.push_back({std::stod(match->str(1)), std::stod(match->str(2)), match->str(3)});
  return found;
}

/// The least room between numbers beside each other at the x axis, which is that of the lowest numbers, if a
/// digit is 0.56 of its size wide as in Helvetica.
double min_room(const std::string& svg) {
  std::vector<Text> labels;
  for (const Text& text : texts(svg))
    if (text.words.find_first_not_of("−-0123456789.") == std::string::npos) labels.push_back(text);
  double lowest = 0.0, least = 1e9;
  for (const Text& label : labels) lowest = std::max(lowest, label.y);
  const Text* before = nullptr;
  const auto half = [](const Text& label) {
    return 0.5 * 13.0 * 0.56 * static_cast<double>(label.words.size());
  };
  for (const Text& label : labels) {
    if (label.y < lowest - 1.0) continue;
    if (before) least = std::min(least, label.x - half(label) - before->x - half(*before));
    before = &label;
  }
  return least;
}

}  // namespace

TEST_CASE("numbers at an axis do not touch in small panels") {
  if (!render::has_gnuplot()) return;
  const std::string wide = "{plot: lines, x: time in ms, y: rig.x in mm, x_range: [0 s, 1.2 s]}";
  const std::string panels = "{columns: 4, size: [800, 200], panels: [" + wide + "]}";
  CHECK(min_room(drawn(panels)) > 3.0);
  const std::string negative = "{plot: xy, x: rig.x in um, y: rig.v in mm/s, x_range: [-1000 um, 900 um]}";
  CHECK(min_room(drawn("{columns: 3, size: [600, 200], panels: [" + negative + "]}")) > 3.0);
  const std::string named =
      "{plot: lines, x: time in ms, x_range: [-0.16 s, 0.16 s], y: [rig.x, rig.x, rig.x, rig.x, rig.x], "
      "legend: "
      "[current = 0 A, current = 0.1 A, current = 0.2 A, current = 0.3 A, current = 0.35 A]}";
  CHECK(min_room(drawn("{columns: 2, size: [1040, 400], panels: [" + named + ", " + named + "]}")) > 3.0);
}

TEST_CASE("ticks are as far apart as gnuplot has them, and farther where there is no room") {
  const auto steps = [](const AxesSize& size) {
    PlotSpec plot;
    plot.x.range = {-20.0, 20.0};
    plot.y.range = {0.0, 1.0};
    set_steps(plot, size);
    return std::pair(plot.x.step.value(), plot.y.step.value());
  };
  CHECK(steps({600.0, 400.0}) == std::pair(5.0, 0.2));
  CHECK(steps({150.0, 400.0}) == std::pair(10.0, 0.2));
  CHECK(steps({600.0, 60.0}) == std::pair(5.0, 0.5));
}

TEST_CASE("a title that is too wide is smaller, and then has two lines") {
  CHECK(render::fitted_title("force", 300.0) == "'force'");
  CHECK_THAT(render::fitted_title("the force of the damper at the pin", 220.0), Contains("' font ',1"));
  const std::string two =
      render::fitted_title("the \"force\" of the left damper and of the right damper at the pin", 250.0);
  CHECK_THAT(two, Contains("\\n") && Contains(", 'the \"force\" of"));
}

TEST_CASE("texts are as wide as in DejaVu Sans at most") {
  CHECK(svg::text_width("") == 0.0);
  CHECK(svg::text_width("i") == Approx(0.278));
  CHECK(svg::text_width("Wi") == Approx(0.989 + 0.278));
  CHECK(svg::text_width("µ") == Approx(0.8));
  CHECK(svg::fitted_size("WWWW", 10.0, 100.0) == 10.0);
  CHECK(svg::fitted_size("WWWW", 10.0, 20.0) == Approx(20.0 / (4 * 0.989)));
}

TEST_CASE("a map is cut at the frame, cell by cell") {
  geometry::Grid grid{0.5, 0.5, 1.0, 1.0, 4, 4, {}};
  for (int i = 0; i < 16; ++i) grid.values.push_back(i);
  const geometry::Grid same = geometry::within(grid, {0.0, 4.0}, {0.0, 4.0});
  CHECK(same.columns == 4);
  const geometry::Grid cut = geometry::within(grid, {0.5, 3.5}, {1.0, 4.0});
  CHECK(cut.x - 0.5 * cut.dx == Approx(0.5));
  CHECK(cut.x + (static_cast<double>(cut.columns) - 0.5) * cut.dx == Approx(3.5));
  CHECK(cut.y - 0.5 * cut.dy == Approx(1.0));
  CHECK(cut.at(0, 0) == 4.0);
  CHECK(cut.at(cut.columns - 1, cut.rows - 1) == 15.0);
  CHECK(cut.at(cut.columns / 2 - 1, 0) == 5.0);
}

TEST_CASE("a signal without a label is named in words, without hints of gnuplot") {
  if (!render::has_gnuplot()) return;
  const std::string svg = drawn("{plot: lines, x: time in s, y: push.force}");
  CHECK_THAT(
      svg, Contains(">force of push [N]<") && !Contains("push.force") && !Contains("gnuplot_plot_1</title>"));
  CHECK_THAT(svg, Contains("prefers-color-scheme: dark"));
}

}  // namespace stepwire::plot
