#include <catch2/catch.hpp>
#include <cmath>

#include "tests/blocks/records/played.hpp"
#include "tests/engine/base/table/scratch.hpp"

using namespace stepwire;

namespace {

void check_near(const std::vector<double>& values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(values[i] == Approx(expected[i]).margin(1e-12));
}

/// y = 1, 3, 2, 6 mm at 0, 0.1, 0.2 and 0.3 s.
std::string four_rows(const Scratch& scratch) {
  return scratch.file("four.csv", "time [s],y [mm]\n0,1\n0.1,3\n0.2,2\n0.3,6\n");
}

double speed_of_wave(double t) {
  return 2.0 * M_PI * std::cos(2.0 * M_PI * t);
}

}  // namespace

TEST_CASE("an offset is the mean, the first row, or what is told with its unit") {
  const Scratch scratch;
  const std::string file = four_rows(scratch);
  const auto prepared = [&](const std::string& offset) {
    return played(file, "prepare: [{remove: " + offset + "}]", "0.1 s", "0.3 s");
  };
  check_near(prepared("mean"), {-2e-3, 0.0, -1e-3, 3e-3});
  check_near(prepared("first"), {0.0, 2e-3, 1e-3, 5e-3});
  check_near(prepared("1.5 mm"), {-0.5e-3, 1.5e-3, 0.5e-3, 4.5e-3});
}

TEST_CASE("steps are done in the order in which they stand") {
  const Scratch scratch;
  const std::string file = four_rows(scratch);
  check_near(played(file, "prepare: [{remove: 1 mm}, {remove: mean}]", "0.1 s", "0.3 s"),
             {-2e-3, 0.0, -1e-3, 3e-3});
  check_near(played(file, "prepare: [{remove: mean}, {remove: 1 mm}]", "0.1 s", "0.3 s"),
             {-3e-3, -1e-3, -2e-3, 2e-3});
}

TEST_CASE("uneven rows are made even by straight lines") {
  const Scratch scratch;
  const std::string file = scratch.file("uneven.csv", "time [s],y [mm]\n1,0\n1.3,3\n1.4,1\n1.75,8\n");
  check_near(played(file, "prepare: [{resample: 0.1 s}], interpolation: hold", "0.1 s", "0.7 s"),
             {0.0, 1e-3, 2e-3, 3e-3, 1e-3, 3e-3, 5e-3, 7e-3});
}

TEST_CASE("a smooth record is resampled between its rows as its signal without fast content") {
  const Scratch scratch;
  const auto wave = [](double t) { return std::sin(2.0 * M_PI * t) + 3.0 * t + 2.0; };
  const std::string file = scratch.file("wave.csv", record_text(21, 0.1, wave));
  const auto y =
      played(file, "prepare: [{resample: 25 ms, method: band_limited}], interpolation: hold", "25 ms", "2 s");
  for (std::size_t i = 0; i < y.size(); ++i)
    CHECK(y[i] == Approx(1e-3 * wave(static_cast<double>(i) * 0.025)).margin(1e-12));
}

TEST_CASE("a trimmed record goes from the first to the last movement, and its time begins there") {
  const Scratch scratch;
  const auto rests = [](double t) { return t < 0.95 ? 0.0 : t > 2.05 ? 40.0 : 100.0 * (t - 0.9); };
  const std::string file = scratch.file("rests.csv", record_text(31, 0.1, rests));
  const std::string cut = "after_end: hold, interpolation: hold, prepare: [{trim: y, threshold: 5 %";
  const auto y = played(file, cut + "}]", "0.1 s", "2 s");
  CHECK(y.front() == Approx(10e-3));  // the row at 1 s, the first that is not 0
  CHECK(y.at(10) == Approx(110e-3));  // the one at 2 s, the last that is not 40
  CHECK(y.back() == Approx(110e-3));
  CHECK(played(file, cut + ", margin: 0.2 s}]", "0.1 s", "2 s").at(2) == Approx(10e-3));
  CHECK(played(file, cut + ", margin: -0.2 s}]", "0.1 s", "2 s").front() == Approx(30e-3));
}

TEST_CASE("columns of one file are cut alike by the movement of one of them, whatever is done before") {
  const Scratch scratch;
  const std::string file =
      scratch.file("two.csv", "time,y,F\n0,0,5\n1,0,6\n2,9,7\n3,1,8\n4,9,9\n5,4,10\n6,4,11\n7,4,12\n");
  const table::Table table =
      run_text("step: 1 s\nstop: 2 s\nblocks:\n  y: {block: FromFile, file: '" + file +
               "', column: y, prepare: [{remove: first}, {differentiate: 1}, {trim: y}]}\n"
               "  F: {block: FromFile, file: '" +
               file + "', column: F, prepare: [{trim: y}]}\nrecord: [y, F]\n");
  check_near(column(table, "F"), {7.0, 8.0, 9.0});
  check_near(column(table, "y"), {0.5, 0.0, 1.5});
}

TEST_CASE("derivatives are exact for a parabola up to the ends") {
  const Scratch scratch;
  const std::string file =
      scratch.file("parabola.csv", record_text(11, 0.1, [](double t) { return 5.0 * t * t - 2.0 * t; }));
  const auto slope = played(file, "prepare: [{differentiate: 1}]", "0.1 s", "1 s");
  for (std::size_t i = 0; i < slope.size(); ++i)
    CHECK(slope[i] == Approx(1e-3 * (static_cast<double>(i) - 2.0)).margin(1e-12));
  for (const double bend : played(file, "prepare: [{differentiate: 2}]", "0.1 s", "1 s"))
    CHECK(bend == Approx(10e-3).epsilon(1e-9));
}

TEST_CASE("a filtered and differentiated record has no lag") {
  const Scratch scratch;
  const std::string file =
      scratch.file("wave.csv", record_text(4001, 1e-3, [](double t) { return std::sin(2.0 * M_PI * t); }));
  const auto speed =
      played(file, "prepare: [{low_pass: 20 Hz, order: 4}, {differentiate: 1}]", "1 ms", "4 s");
  for (std::size_t i = 500; i < 3500; ++i)
    REQUIRE(speed[i] == Approx(1e-3 * speed_of_wave(static_cast<double>(i) * 1e-3)).margin(1e-7));
}

TEST_CASE("a derivative has its unit: a speed is no length") {
  const Scratch scratch;
  const std::string file = four_rows(scratch);
  const auto mass = [&](const std::string& steps) {
    return error_of("step: 0.1 s\nstop: 0.1 s\nblocks:\n  y: {block: FromFile, file: '" + file +
                    "', column: y, prepare: " + steps +
                    "}\n  sum: {block: Sum, u: [y, length]}\n  length: {block: Constant, value: 1 m}\n");
  };
  CHECK(mass("[{remove: mean}]").empty());
  CHECK_THAT(mass("[{differentiate: 1}]"), Catch::Contains("m/s"));
  CHECK_THAT(mass("[{differentiate: 2}]"), Catch::Contains("m/s"));
}

TEST_CASE("a step takes parameters of the diagram") {
  const Scratch scratch;
  const std::string file = four_rows(scratch);
  const table::Table table = run_text(
      "step: 0.1 s\nstop: 0.3 s\nparameters:\n  rest: {value: 1 mm}\nblocks:\n  y: {block: "
      "FromFile, file: '" +
      file + "', column: y, prepare: [{remove: $rest}]}\nrecord: [y]\n");
  check_near(column(table, "y"), {0.0, 2e-3, 1e-3, 5e-3});
}
