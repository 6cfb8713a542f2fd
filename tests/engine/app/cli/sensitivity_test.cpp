#include <catch2/catch.hpp>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

/// A lag of two drawn parameters by a design, and outcomes of its runs.
std::string drawn_yaml(const std::string& design, const std::string& outcomes, const std::string& more = "") {
  return "stepwire: 1\ntitle: a drawn lag\nstep: 10 ms\nstop: 0.1 s\nsolver: rk4\n"
         "parameters: {tau: {value: 0.1 s, above: 0 s, doc: x}, k: {value: 1, doc: x}}\n"
         "sweep:\n  design: {kind: " +
         design +
         ", samples: 64, seed: 1}\n"
         "  tau: {uniform: [0.1 s, 0.2 s]}\n  k: {uniform: [1, 2]}\n" +
         more + "sensitivity: {of: {" + outcomes +
         "}}\nblocks: {lag: {block: Lag, u: 1, tau: $tau, gain: $k}}\nrecord: [lag]\n";
}

}  // namespace

TEST_CASE("a sensitivity of an outcome that is the same in all runs says so in a sentence") {
  const std::string design = GENERATE(as<std::string>(), "random", "saltelli", "morris");
  INFO(design);
  const Scratch folder;
  folder.file("a.yaml", drawn_yaml(design, "last: final(lag), none: 0*max(lag)"));
  const Done done = run_program(folder, {"run", "a.yaml"});
  INFO(done.out << done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, !Contains("nan"));
  CHECK_THAT(done.out, Contains("'none' is 0 in all ") &&
                           Contains(" runs: no parameter changes it, and none has a share of it"));
  CHECK_THAT(done.out, !Contains("'last' is"));
}

TEST_CASE("a correlation that is not a number is told as such, and not by the shape of its matrix") {
  const Scratch folder;
  folder.file("a.yaml", drawn_yaml("random", "last: final(lag)", "  correlation: [[1, nan], [0.5, 1]]\n"));
  const Done done = run_program(folder, {"check", "a.yaml"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("'nan' is not a finite number") && !Contains("symmetric"));
}
