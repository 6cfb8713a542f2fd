#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// A pin on its way at 10 mm/s through (0, 0), (30, 0) and back, between two layers that give 1 N and 5 N.
table::Table on_its_way(const std::string& switches, const std::string& more = "",
                        const std::string& speed = "10 mm/s") {
  return run_text(
      "step: 1 ms\nstop: 7 s\nblocks:\n  way: {block: Pusher, points: [[0, 0], [30 mm, 0], [0, 0]], speed: " +
      speed +
      R"(, highest_acceleration: 100 m/s2}
  area:   {block: Region, shape: {center: [20 mm, 0 mm], radius: 5 mm}, position: way.position}
  layers: {block: LayerActivator, u: [1 N, 5 N, 7 N], position: way.position, regions: area.distance, blend: 0.2 s, switches: )" +
      switches + more +
      "}\nrecord: [layers.y, layers.layer, layers.switched, layers.weights, way.position]\n");
}

/// Times at which the active layer changes.
std::vector<double> changes(const table::Table& table) {
  std::vector<double> at;
  const auto& layer = column(table, "layers.layer");
  for (std::size_t k = 1; k < layer.size(); ++k)
    if (layer[k] != layer[k - 1]) at.push_back(column(table, "time")[k]);
  return at;
}

void check_times(const std::vector<double>& are, const std::vector<double>& expected) {
  REQUIRE(are.size() == expected.size());
  for (std::size_t k = 0; k < are.size(); ++k) CHECK(are[k] == Approx(expected[k]).margin(2.5e-3));
}

}  // namespace

TEST_CASE("A point is passed as soon as the way comes within its radius, and a layer gives way once") {
  check_times(changes(on_its_way("[{from: 1, to: 2, when: {pass: [10 mm, 3 mm], within: 5 mm}}]")), {0.6});
  CHECK(changes(on_its_way("[{from: 1, to: 2, when: {pass: [10 mm, 3 mm], within: 2.9 mm}}]")).empty());
}

TEST_CASE("A point is passed also between two ticks") {
  const table::Table table = on_its_way(
      "[{from: 1, to: 2, when: {pass: [10.02 mm, 0.01 mm], within: 0.02 mm}}]", ", every: 100 ms", "50 mm/s");
  CHECK(changes(table).size() == 1);
}

TEST_CASE("Entering and leaving a region are events") {
  check_times(changes(on_its_way("[{from: 1, to: 2, when: {enter: 1}}, {from: 2, to: 1, when: {leave: 1}}]")),
              {1.5, 2.5, 3.5, 4.5});
}

TEST_CASE("A line is crossed between its ends, and to the side that is meant") {
  const auto crossing = [](const std::string& line) {
    return changes(on_its_way("[{from: 1, to: 2, when: {cross: " + line + "}}]"));
  };
  check_times(crossing("[[10 mm, -5 mm], [10 mm, 5 mm]], toward: right"), {1.0});
  check_times(crossing("[[10 mm, -5 mm], [10 mm, 5 mm]], toward: left"), {5.0});
  check_times(crossing("[[10 mm, 5 mm], [10 mm, -5 mm]], toward: left"), {1.0});
  CHECK(crossing("[[10 mm, 1 mm], [10 mm, 5 mm]], toward: right").empty());
}

TEST_CASE("Time elapses from when the layer became active, and from the last event of a sequence") {
  check_times(
      changes(on_its_way("[{from: 1, to: 2, when: {after: 1 s}}, {from: 2, to: 3, when: {after: 2 s}}]")),
      {1.0, 3.0});
  check_times(
      changes(on_its_way("[{from: 1, to: 2, when: [{pass: [10 mm, 0 mm], within: 1 mm}, {after: 0.7 s}]}]")),
      {1.6});
}

TEST_CASE("The events of a sequence count in their order only, and while their layer is active") {
  // (5, 0) is passed at 0.5 s, before (25, 0), and again at 5.5 s
  check_times(changes(on_its_way("[{from: 1, to: 2, when: [{pass: [25 mm, 0 mm], within: 0.01 mm}, {pass: [5 "
                                 "mm, 0 mm], within: 0.01 mm}]}]")),
              {5.5});
  // the first event of the second switch happens while layer 1 is active and is forgotten
  check_times(changes(on_its_way(
                  "[{from: 1, to: 2, when: {pass: [20 mm, 0 mm], within: 0.01 mm}}, "
                  "{from: 2, to: 1, when: [{pass: [10 mm, 0 mm], within: 0.01 mm}, {after: 0.1 s}]}]")),
              {2.0, 5.1});
}

TEST_CASE("Of two switches at one tick the first of the file counts") {
  const table::Table table =
      on_its_way("[{from: 1, to: 3, when: {after: 1 s}}, {from: 1, to: 2, when: {after: 1 s}}]");
  CHECK(column(table, "layers.layer").back() == 3.0);
  CHECK(column(table, "layers.switched").back() == 1.0);
}

TEST_CASE(
    "A switch never moves the force from tick to tick by more than its stated bound, also one upon another") {
  const table::Table table = on_its_way(
      "[{from: 1, to: 2, when: {after: 1 s}}, {from: 2, to: 3, when: {after: 0.05 s}}, {from: 3, to: 1, "
      "when: {after: 0.1 s}}]");
  const auto& y = column(table, "layers.y");
  double steepest = 0.0;
  for (std::size_t k = 1; k < y.size(); ++k) {
    steepest = std::max(steepest, std::abs(y[k] - y[k - 1]));
    double sum = 0.0;
    for (const std::string i : {"1", "2", "3"}) sum += column(table, "layers.weights." + i)[k];
    REQUIRE(sum == Approx(1.0).epsilon(1e-12));
  }
  CHECK(steepest <= 1e-3 / 0.2 * (7.0 - 1.0) + 1e-12);
  CHECK(steepest > 0.01);
  CHECK(y[1010] > 1.0);
  CHECK(y[900] == 1.0);
}

TEST_CASE("With no blend time the new layer counts at once, and the first layer may be another one") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 2 s
blocks:
  layers: {block: LayerActivator, u: [[1 N, 2 N], [5 N, 6 N]], position: [0, 0], initial: 2, blend: 0 s,
           switches: [{from: 2, to: 1, when: {after: 1 s}}]}
record: [layers.y]
)");
  CHECK(column(table, "layers.y.2")[998] == 6.0);
  CHECK(column(table, "layers.y.1")[1002] == 1.0);
  CHECK(column(table, "layers.y.2")[1002] == 2.0);
}

TEST_CASE("What is no switch or no event is refused, with what would be one") {
  const auto refused = [](const std::string& switches) {
    return error_of(
        "step: 1 ms\nstop: 1 s\nblocks:\n  l: {block: LayerActivator, u: [1 N, 2 N], position: [0, 0], "
        "switches: " +
        switches + "}\n");
  };
  CHECK_THAT(refused("[]"), Catch::Contains("l.switches") && Catch::Contains("list of switches"));
  CHECK_THAT(refused("[{from: 1, to: 3, when: {after: 1 s}}]"),
             Catch::Contains("'to' must be a whole number from 1 to 2"));
  CHECK_THAT(refused("[{from: 1, to: 1, when: {after: 1 s}}]"), Catch::Contains("to another one"));
  CHECK_THAT(refused("[{from: 1, to: 2}]"), Catch::Contains("'when' is missing"));
  CHECK_THAT(refused("[{from: 1, to: 2, when: {enter: 1}}]"), Catch::Contains("input 'regions'"));
  CHECK_THAT(refused("[{from: 1, to: 2, when: {after: 3 mm}}]"), Catch::Contains("a number in s"));
  CHECK_THAT(refused("[{from: 1, to: 2, when: {pass: [0, 0]}}]"), Catch::Contains("within"));
  CHECK_THAT(refused("[{from: 1, to: 2, when: {touch: 1}}]"), Catch::Contains("{after: 2 s}"));
  CHECK_THAT(refused("[{from: 1, to: 2, when: {after: 1 s, pass: [0, 0]}}]"),
             Catch::Contains("there is no 'after' here"));
  CHECK_THAT(refused("[{from: 1, to: 2, when: {cross: [[0, 0], [1, 0]], toward: up}}]"),
             Catch::Contains("left or right"));
}
