#include <catch2/catch.hpp>

#include "engine/view/plot/bar_chart.hpp"
#include "engine/view/render/gnuplot.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::plot {

TEST_CASE("a bar chart names its bars and kinds, says how long each bar is, and draws the same each time") {
  if (!render::has_gnuplot()) {
    WARN("gnuplot is not installed; nothing was drawn");
    return;
  }
  const BarChart chart{"two <and> a rest",
                       "share [%]",
                       {{"first", "#0072B2"}, {"second", "#D55E00"}},
                       {{"it is a", {12.5, 30.0}}, {"b", {0.0, 0.0}}, {"rest", {0.0, 7.5}, true}}};
  const std::string svg = render::render(figure_of(chart)).svg;
  for (const std::string text : {"it is a", ">b<", "rest", "share [%]", "first", "second", "42.5", "7.5",
                                 "<title>two &lt;and&gt; a rest</title>"})
    CHECK_THAT(svg, Catch::Contains(text));
  CHECK(render::render(figure_of(chart)).svg == svg);
}

TEST_CASE("a bar chart without bars is a picture all the same") {
  if (!render::has_gnuplot()) return;
  CHECK_THAT(render::render(figure_of(BarChart{"none", "s", {{"kind", "#0072B2"}}, {}})).svg,
             Catch::Contains("</svg>"));
}

}  // namespace stepwire::plot
