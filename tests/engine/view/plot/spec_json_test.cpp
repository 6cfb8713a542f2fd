#include <fstream>
#include <sstream>

#include "engine/view/plot/bar_chart.hpp"
#include "engine/view/plot/matrix_chart.hpp"
#include "engine/view/render/gnuplot.hpp"
#include "engine/view/render/gnuplot_renderer.hpp"
#include "tests/engine/view/plot/every_kind.hpp"
#include "tests/engine/view/plot/spec_reader.hpp"

namespace stepwire::plot {
using namespace testing;
using Catch::Contains;

namespace {

std::string text_of(const FigureSpec& figure) {
  return figure_json(figure).text(-1);
}

/// Appends the names of the fields that a struct lists.
template <class Struct>
void gather_fields(std::vector<std::string>& names) {
  std::apply([&](const auto&... all) { (names.push_back(all.name), ...); }, Struct::fields());
}

template <class... Marks>
std::vector<std::string> names_in_json(const std::variant<Marks...>&) {
  std::vector<std::string> names{Marks::name...};
  (gather_fields<Marks>(names), ...);
  for (const auto gather :
       {gather_fields<MarkRows>, gather_fields<LineStyle>, gather_fields<TextMark>, gather_fields<PlotSpec>,
        gather_fields<PlotAxis>, gather_fields<AxisTick>, gather_fields<ColorStop>, gather_fields<SpaceView>})
    gather(names);
  return names;
}

}  // namespace

TEST_CASE(
    "a figure that is read back from its JSON is drawn the same: nothing is drawn that it does not hold") {
  for (const std::string& text : every_kind) {
    INFO(text);
    const FigureSpec figure = figure_spec_of(text, {0.1, 0.2, 0.3}, 200);
    CHECK(render::gnuplot_script(figure_of_json(text_of(figure))) == render::gnuplot_script(figure));
  }
}

TEST_CASE("what lies over a plot, panels and charts are drawn the same from their JSON") {
  const std::string plane = "plot: xy, x: rig.x in mm, y: rig.v in mm/s";
  const std::string over =
      "{" + plane +
      ", region: map, region_line: dashes, marks: {A: [0 mm, 0 mm/s]}, texts: {here: [1 mm, 1 "
      "mm/s]}, motion: {x: rig.x, y: rig.v}, rose: {x: rig.x, y: rig.v, angle: time*6, value: push.force in "
      "N, radius: 2 mm, at: [3 mm, 3 mm/s]}, note: {signal: current in mA, label: at}}";
  const MatrixChart matrix{"m", {"a", "b"}, {{1.0, -0.25}, {query::nothing, 1.0}}};
  const BarChart bars{"b", "share [%]", {{"first", "#0072B2"}}, {{"it is a", {12.5}}, {"rest", {7.5}, true}}};
  for (const FigureSpec& figure :
       {figure_spec_of(over), figure_of(matrix), figure_of(bars),
        figure_spec_of("{title: two, panels: [" + over + ", {plot: lines, x: time, y: rig.x}]}"),
        figure_spec_of("{plot: lines, x: time, y: rig.x, where: time < 0}")})
    CHECK(render::gnuplot_script(figure_of_json(text_of(figure))) == render::gnuplot_script(figure));
}

TEST_CASE("what stands at its default is left out, and numbers of columns have seven digits") {
  const nlohmann::json figure =
      nlohmann::json::parse(text_of(figure_spec_of("{plot: lines, x: time, y: rig.x in mm}", {0.0}, 3)));
  const nlohmann::json& panel = figure.at("panels").at(0);
  CHECK(panel.at("panel") == "plot");
  CHECK(panel.at("y").at("label") == "x of rig");
  CHECK(panel.at("y").at("unit") == "mm");
  CHECK_FALSE(panel.contains("equal"));
  CHECK_FALSE(panel.at("y").contains("log"));
  const nlohmann::json& line = panel.at("marks").at(0);
  CHECK(line.at("mark") == "line");
  CHECK(line.at("curves").at(0).at("y").at(1) == 0.8660254);
  CHECK_FALSE(line.at("line").contains("dash"));
}

TEST_CASE("cells of an image that were not measured are null") {
  ImageMark image{0.0, 0.0, 1.0, 1.0, 2, 1, {1.5, query::nothing}};
  const FigureSpec figure{"", 10.0, 10.0, false, {{0.0, 0.0, 10.0, 10.0, PlotSpec{.marks = {image}}}}};
  const nlohmann::json values =
      nlohmann::json::parse(text_of(figure)).at("panels").at(0).at("marks").at(0).at("values");
  CHECK(values == nlohmann::json::array({1.5, nullptr}));
}

TEST_CASE("tables, diagrams and scenes are panels of their own") {
  const auto panel = [](auto content) {
    return nlohmann::json::parse(text_of({"", 0.0, 0.0, false, {{0.0, 0.0, 0.0, 0.0, std::move(content)}}}))
        .at("panels")
        .at(0);
  };
  const nlohmann::json table = panel(text::TextTable{"t", {"of", "found"}, {{"a", "1 mm"}}, {"a note"}});
  CHECK(table.at("panel") == "table");
  CHECK(table.at("rows") == nlohmann::json::array({nlohmann::json::array({"a", "1 mm"})}));
  const nlohmann::json graph =
      panel(DrawnGraph{DrawnGraph::Kind::rig, stepwire::json::Json::object().set("title", "r")});
  CHECK(graph.at("panel") == "rig");
  CHECK(graph.at("graph").at("title") == "r");
}

TEST_CASE("the page of protocols names every mark and every field") {
  std::ifstream file(STEPWIRE_SOURCE_DIR "/engine/app/studio/protocol.md");
  std::stringstream page;
  page << file.rdbuf();
  for (const std::string& name : names_in_json(PlotMark{}))
    CHECK_THAT(page.str(), Contains("`" + name + "`"));
}

}  // namespace stepwire::plot
