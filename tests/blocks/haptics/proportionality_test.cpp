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

TEST_CASE("A diagram chooses the proportionality law by its name") {
  const Table table = run_text(R"(
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
