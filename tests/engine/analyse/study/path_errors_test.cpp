#include "engine/analyse/study/path_errors.hpp"
#include "engine/view/render/render.hpp"

#include <catch2/catch.hpp>

#include "engine/analyse/statistics/statistics_error.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/render/gnuplot.hpp"
#include "tests/engine/analyse/study/samples.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::study {
using namespace testing;
using Catch::Matchers::Contains;

namespace {

std::vector<Trial> drawings() {
  return {circle_drawing("a", "NO", 0.0, 4 * mm), circle_drawing("a", "V", 1 * mm, 0.0),
          circle_drawing("b", "NO", 5 * mm, 2 * mm), circle_drawing("b", "V", 5 * mm, 1 * mm)};
}

}  // namespace

TEST_CASE("a drawing scores the squares of its distances from the circle of the drawing without feedback") {
  const PathErrors errors = circle_errors(drawings(), circle);
  REQUIRE(errors.rows.size() == 4);
  const double expected[] = {100 * 16.0, 100 * 1.0, 100 * 4.0, 100 * 1.0};  // [mm^2]
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(errors.rows[i].error == Approx(expected[i] * mm * mm).epsilon(1e-6));
    CHECK(errors.rows[i].normalised == Approx(expected[i] / 1600.0).epsilon(1e-6));
    CHECK(errors.rows[i].deviation == Approx(std::sqrt(expected[i] / 100.0) * mm).epsilon(1e-6));
  }
  CHECK(errors.circles.at("a").radius == Approx(50 * mm));
  CHECK(errors.circles.at("b").radius == Approx(55 * mm));
  CHECK(errors.circles.at("b").centre.x() == Approx(20 * mm));
  CHECK(errors.rows[0].duration == Approx(24.75));
  CHECK_THAT(errors.rule, Contains("fitted to the drawing NO (geometric fit)"));
}

TEST_CASE("another fit may be asked for, and is told") {
  CHECK_THAT(circle_errors(drawings(), {"1", "NO", statistics::CircleFit::taubin}).rule,
             Contains("(Taubin fit)"));
}

TEST_CASE("a straight return scores its length times its angle, over the largest") {
  const std::vector<Trial> trials{straight_return("a", "V", 60 * degree),
                                  straight_return("a", "H", 30 * degree),
                                  circle_drawing("a", "NO", 0.0, 1 * mm)};
  const PathErrors errors = return_errors(trials, to_half_plane, way_back);
  REQUIRE(errors.rows.size() == 2);
  CHECK(errors.rows[0].error == Approx(30 * mm * 60 * degree));
  CHECK(errors.rows[1].normalised == Approx(0.5));
  CHECK(errors.rows[1].deviation == Approx(30 * degree));
  CHECK_THAT(errors.rule, Contains("resampled by arc length in steps of 2 mm"));
}

TEST_CASE("what comes behind the first point inside counts in no number of a return") {
  Trial longer = straight_return("a", "V", 60 * degree);
  const PathErrors before = return_errors({longer}, to_half_plane, way_back);
  const Eigen::Index points = longer.points.cols();
  longer.points.conservativeResize(Eigen::NoChange, points + 200);
  for (Eigen::Index i = 0; i < 200; ++i) {  // further in, and out again
    longer.points.col(points + i) = longer.points.col(points - 1) + Eigen::Vector2d(0.0, 1e-4 * (100 - i));
    longer.time.push_back(longer.time.back() + 1.0);
  }
  const PathErrors after = return_errors({longer}, to_half_plane, way_back);
  CHECK(after.rows[0].error == before.rows[0].error);
  CHECK(after.rows[0].length == before.rows[0].length);
  CHECK(after.rows[0].duration == before.rows[0].duration);
  CHECK(after.warnings == before.warnings);
}

TEST_CASE("a trial that lasted too long is scored, and named") {
  const PathErrors errors = circle_errors(drawings(), {"1", "NO", statistics::CircleFit::geometric, 20.0});
  REQUIRE(errors.warnings.size() == 4);
  CHECK(errors.warnings[1] ==
        "subject a, task 1, condition V lasted 24.8 s; the thesis repeats trials that last longer than 20 s");
  CHECK(errors.rows.size() == 4);
  CHECK(circle_errors(drawings(), circle).warnings.empty());
}

TEST_CASE("what cannot be scored names its trial") {
  const std::vector<Trial> without{circle_drawing("Ann", "V", 0.0, 1 * mm)};
  CHECK_THROWS_WITH(
      circle_errors(without, circle),
      "subject Ann, task 1, condition V: there is no drawing under 'NO' to which a circle could be "
      "fitted");
  Trial away = straight_return("Bo", "H", 0.2);
  away.points.row(0).array() += 1.0;
  CHECK_THROWS_WITH(return_errors({away}, to_half_plane, way_back),
                    "subject Bo, task 2, condition H: the path never gets into the region");
  CHECK_THROWS_WITH(return_errors(without, to_half_plane, way_back), "there are no trials of task '2'");
}

TEST_CASE("the table of errors is written with names and units, and read back") {
  table::ColumnWords words;
  const table::Table table = error_table(circle_errors(drawings(), circle), words);
  const std::string text = table::csv_text(table, words);
  CHECK_THAT(text,
             Catch::StartsWith("subject,condition,error [mm^2],normalised,raw [mm^2],deviation [mm],length "
                               "[mm],duration [s],points\na,NO,"));
  const Scratch scratch;
  table::ColumnWords again{{"subject", {}}, {"condition", {}}};
  CHECK(table::read_csv(scratch.file("errors.csv", text), again).find("error")->values[1] == Approx(100.0));
  CHECK(again["condition"] == std::vector<std::string>{"NO", "V"});
}

TEST_CASE("conditions become the factors of the analysis") {
  const statistics::Observations two =
      observations(errors_of("1", {{"NO", 4}, {"H", 3}, {"V", 2}, {"HV", 1}}), six_conditions());
  CHECK(two.factors.size() == 4);  // haptic, visual, condition, subject
  CHECK(two.factor("haptic").levels == std::vector<std::string>{"absent", "present"});
  CHECK(two.factor("visual").level[3] == 1);
  const statistics::Observations three =
      observations(errors_of("2", {{"H", 3}, {"V", 2}, {"V_gp", 1}}), six_conditions());
  CHECK(three.factor("guiding path").level[2] == 1);
  CHECK(three.factor("subject").subject);
  CHECK_THROWS_WITH(observations(errors_of("1", {{"no", 1}}), six_conditions()),
                    "subject 1: 'no' is no condition; there are: NO, H, V, HV, V_gp, HV_gp");
}

TEST_CASE("figures read the errors, with the words of their conditions") {
  const record::Recording recording = error_recording(circle_errors(drawings(), circle));
  CHECK(recording.table.rows() == 4);
  CHECK(recording.table.find("normalised")->values[0] == 1.0);
  REQUIRE(recording.categories.size() == 2);
  CHECK(recording.categories[1].texts == std::vector<std::string>{"NO", "V"});
  if (!render::has_gnuplot()) return;
  const query::SymbolTable names{"d.yaml",
                                 {{"condition", unit::Dimension{}, 0}, {"normalised", unit::Dimension{}, 0}}};
  yaml::Faults faults;
  const auto document = yaml::parse_document("{plot: box, y: normalised, by: condition}", "d.yaml");
  const auto figures = plot::read_figures(document.root, names, faults);
  REQUIRE(faults.empty());
  CHECK_THAT(render::draw(figures[0], std::vector{recording}).svg, Contains(">NO<") && Contains(">median<"));
}

}  // namespace stepwire::study
