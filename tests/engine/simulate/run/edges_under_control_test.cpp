// Error control of plants that follow sources: edges that are known beforehand, and fast plants on slow
// inputs.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

double last(const std::string& yaml, const std::string& name) {
  return column(result_of(yaml).recordings.front().table, name).back();
}

}  // namespace

TEST_CASE("steps end at the edges of a source, and few are rejected") {
  // 65 edges of the pulse in 10 s. A solver that is restarted at each needs one to three steps between two.
  for (const char* solver : {"dormand_prince", "dop853", "radau"}) {
    INFO(solver);
    const RunResult result = result_of(
        fmt::format("step: 10 s\nstop: 10 s\nevents: locate\nsolver: {{name: {}, relative: 1e-6}}\nblocks:\n"
                    "  p: {{block: Pulse, period: 0.31 s, delay: 0.05 s}}\n"
                    "  y: {{block: Lag, u: p, tau: 0.5 s}}\nrecord: [y]\n",
                    solver));
    CHECK(result.steps.accepted > 65);
    CHECK(result.steps.accepted < 300);
    CHECK(result.steps.rejected < 10);
  }
}

TEST_CASE("jumps of a held record are exact under error control") {
  const Scratch scratch;
  const std::string file = scratch.file(
      "rec.csv", "time,x\n0,0\n0.13,1\n0.13,-2\n0.4,0.5\n0.4,0.5\n0.77,3\n0.77,0\n1.0,0\n1.0,4\n2,4\n");
  for (const char* solver : {"dormand_prince", "dop853", "radau"}) {
    INFO(solver);
    // -2 from 0.13 s to 0.4 s, 0.5 to 0.5 s.
    CHECK(last(fmt::format("step: 0.5 s\nstop: 0.5 s\nevents: locate\n"
                           "solver: {{name: {}, relative: 1e-10, absolute: 1e-12}}\nblocks:\n"
                           "  f: {{block: FromFile, file: \"{}\", column: x, interpolation: hold}}\n"
                           "  i: {{block: Integrator, u: f}}\nrecord: [i]\n",
                           solver, file),
               "i") == Approx(-2.0 * 0.27 + 0.5 * 0.1).margin(1e-13));
  }
}

TEST_CASE("a fast plant that follows a slow input has the digits that were asked for, but for 1.6") {
  // y' = -k (y - 2 - sin t) + cos t has the solution 2 + sin t (Prothero and Robinson 1974).
  for (const char* solver : {"auto", "radau", "rodas"})
    for (const double fast : {1e3, 1e5})
      for (const double relative : {1e-6, 1e-8}) {
        INFO(solver << " " << fast << " " << relative);
        const double y =
            last(fmt::format("step: 10 s\nstop: 10 s\nsolver: {{name: {}, relative: {}, absolute: {}}}\n"
                             "blocks:\n  t: {{block: Clock}}\n"
                             "  d: {{block: Expression, u: [y, t], expression: "
                             "\"-{}*(u1 - (2 + sin(u2))) + cos(u2)\"}}\n"
                             "  y: {{block: Integrator, u: d, initial: 2}}\nrecord: [y]\n",
                             solver, relative, 1e-3 * relative, fast),
                 "y");
        CHECK(y == Approx(2.0 + std::sin(10.0)).epsilon(0.0).margin(40.0 * relative));
      }
}

}  // namespace stepwire::run
