#include "blocks/haptics/proportionality.hpp"

#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("P1 is zero inside, jumps to its offset on the boundary and rises with its slope") {
  Proportionality law;
  law.offset = 5.0;
  law.slope = 1e3;
  CHECK(law.magnitude(-1e-12) == 0.0);
  CHECK(law.magnitude(0.0) == 5.0);
  CHECK(law.magnitude(17e-3) == Approx(22.0));
}

TEST_CASE("P2 rises from W to its maximum on the boundary and keeps it") {
  Proportionality law;
  law.law = Proportionality::Law::P2;
  law.W = -8e-3;
  law.maximum = 20.0;
  CHECK(law.magnitude(-9e-3) == 0.0);
  CHECK(law.magnitude(-8e-3) == 0.0);
  CHECK(law.magnitude(-2e-3) == Approx(15.0));
  CHECK(law.magnitude(0.0) == 20.0);
  CHECK(law.magnitude(0.1) == 20.0);
}

TEST_CASE(
    "A piecewise law goes straight from value to value, keeps the last ones and jumps where points are the "
    "same") {
  Proportionality law;
  law.law = Proportionality::Law::piecewise;
  law.points = {-4e-3, 0.0, 0.0, 10e-3};
  law.values = {1.0, 3.0, 5.0, 25.0};
  CHECK(law.magnitude(-9e-3) == 1.0);
  CHECK(law.magnitude(-2e-3) == Approx(2.0));
  CHECK(law.magnitude(-1e-9) == Approx(3.0).margin(1e-5));
  CHECK(law.magnitude(0.0) == 5.0);
  CHECK(law.magnitude(2.5e-3) == Approx(10.0));
  CHECK(law.magnitude(10e-3) == 25.0);
  CHECK(law.magnitude(1.0) == 25.0);
}

TEST_CASE("P1 and P2 are piecewise laws, too") {
  Proportionality p1, p2, same;
  p1.offset = 5.0;
  p1.slope = 1e3;
  p2.law = Proportionality::Law::P2;
  p2.W = -8e-3;
  p2.maximum = 20.0;
  same.law = Proportionality::Law::piecewise;
  for (double error = -12e-3; error < 20e-3; error += 0.37e-3) {
    same.points = {-1.0, 0.0, 0.0, 0.03};
    same.values = {0.0, 0.0, 5.0, 35.0};
    CHECK(same.magnitude(error) == Approx(p1.magnitude(error)).margin(1e-12));
    same.points = {-8e-3, 0.0};
    same.values = {0.0, 20.0};
    CHECK(same.magnitude(error) == Approx(p2.magnitude(error)).margin(1e-12));
  }
}

TEST_CASE("A piecewise law whose points fall or lack values is refused") {
  const auto refused = [](const std::string& law) {
    return error_of("step: 1 ms\nstop: 1 s\nblocks:\n  p: {block: Proportionality, law: piecewise, u: 0 m, " +
                    law + "}\n");
  };
  CHECK_THAT(refused("points: [1 mm, 0 mm], values: [1 N, 2 N]"),
             Catch::Contains("p.points") && Catch::Contains("must not fall"));
  CHECK_THAT(refused("points: [1 mm], values: [1 N, 2 N]"), Catch::Contains("there is 1 point and 2 values"));
}

TEST_CASE("A diagram chooses the proportionality law by its name") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 10 ms
blocks:
  p1: {block: Proportionality, law: P1, u: 2 mm, offset: 5 N, slope: 1 N/mm}
  p2: {block: Proportionality, law: P2, u: -2 mm, W: -8 mm, maximum: 20 N}
record: [p1, p2]
)");
  CHECK(column(table, "p1").back() == Approx(7.0));
  CHECK(column(table, "p2").back() == Approx(15.0));
}

TEST_CASE("P2 with a start of its rise outside the boundary is refused") {
  CHECK_THAT(
      error_of("step: 1 ms\nstop: 1 s\nblocks:\n  p: {block: Proportionality, law: P2, u: 0 m, W: 1 mm}\n"),
      Catch::Contains("p.W") && Catch::Contains("inside the boundary"));
}
