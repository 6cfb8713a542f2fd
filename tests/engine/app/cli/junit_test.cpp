#include <catch2/catch.hpp>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

TEST_CASE("run --junit has a suite for each diagram, with the sentence of a claim that fails") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  folder.file("bad.yaml", "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n  x: {block: Nothing}\n");
  folder.file(
      "fails.yaml",
      "stepwire: 1\nstep: 1 ms\nstop: 1 s\nblocks:\n  one: {block: Constant, value: 1 N}\nrecord: [one]\n"
      "claims:\n  - {that: \"it is < 0.5 N & more\", max: one, at_most: 0.5 N}\n"
      "  - {that: known, max: one, at_most: 0.5 N, disagrees: measured otherwise}\n");
  const Done done =
      run_program(folder, {"run", "lag.yaml", "bad.yaml", "fails.yaml", "--junit", "out/c.xml"});
  CHECK(done.code == 2);
  const std::string xml = content_of(folder.path("out/c.xml"));
  INFO(xml);
  CHECK_THAT(xml, Contains("<testsuite name=\"lag.yaml\" tests=\"1\" failures=\"0\" errors=\"0\""));
  CHECK_THAT(
      xml, Contains("<testsuite name=\"fails.yaml\" tests=\"2\" failures=\"1\" errors=\"0\" skipped=\"1\""));
  CHECK_THAT(xml, Contains("it is &lt; 0.5 N &amp; more: does not hold: 1 N (max one &lt;= 0.5 N)"));
  CHECK_THAT(xml, Contains("bad.yaml:5:"));
}

TEST_CASE("compare --junit has a test case for each signal") {
  const Scratch folder;
  folder.file("a.csv", "time [s],f [N],g\n0,1,1\n1,2,1\n");
  folder.file("b.csv", "time [s],f [N],g\n0,1,1\n1,3,1\n");
  CHECK(run_program(folder, {"compare", "a.csv", "b.csv", "--junit", "c.xml"}).code == 1);
  const std::string xml = content_of(folder.path("c.xml"));
  CHECK_THAT(xml, Contains("tests=\"2\" failures=\"1\""));
  CHECK_THAT(xml, Contains("f: differs by 1 N (50 %) at 1 s"));
}
