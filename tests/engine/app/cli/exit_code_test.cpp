#include <catch2/catch.hpp>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

}  // namespace

TEST_CASE("a run whose claims hold ends with 0 and says so on standard output only") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const Done done = run_program(folder, {"run", "lag.yaml"});
  CHECK(done.code == 0);
  CHECK(done.err.empty());
  CHECK_THAT(done.out,
             Contains("A lag follows a constant") && Contains("ok") && Contains("the lag gets there"));
}

TEST_CASE("a claim that fails ends with 1 and is visible with its value") {
  const Scratch folder;
  folder.file("lag.yaml", replaced(lag_yaml, "at_least: 0.9", "at_least: 2"));
  const Done done = run_program(folder, {"run", "lag.yaml"});
  CHECK(done.code == 1);
  CHECK_THAT(done.out, Contains("FAIL the lag gets there: 0.993"));
}

TEST_CASE("what is wrong in the call ends with 2 and one line on standard error") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& part) {
    const Done done = run_program(folder, arguments);
    INFO(done.err);
    CHECK(done.code == 2);
    CHECK(done.out.empty());
    CHECK(lines_of(done.err).size() == 1);
    CHECK_THAT(done.err, Contains(part));
  };
  refused({}, "subcommand");
  refused({"chek"},
          "there is no 'chek'; did you mean 'check'? There are: run, studio, fit, tune, study, statistics, "
          "linearize, trim, collect, job, check, ");
  refused({"run", "lag.yaml", "--engine", "fast"},
          "--engine: does not take 'fast'. It takes: auto, compiled, interpreted");
  refused({"loop", "lag.yaml", "--rate", "0"}, "--rate 0: must be from 1 Hz to 1 MHz");
  refused({"blocks", "Foo"},
          "there is no block 'Foo', and no page has this word. 'stepwire blocks' lists them");
  refused({"format", "calims"}, "there is no section 'calims'; did you mean 'claims'?");
  refused({"format", "results.fitt"}, "did you mean 'results.fit'?");
  refused({"format", "--python", "--typescript"}, "excludes");
  refused({"format", "results.fit", "--python"}, "excludes");
  refused({"run"}, "FILE");
  refused({"run", "lag.yaml", "--fast"}, "--fast");
  refused({"run", "lag.yaml", "--stop"}, "--stop");
  refused({"run", "lag.yaml", "--out", ""}, "--out");
  refused({"run", "none.yaml"}, "none.yaml: no such file");
  refused({"run", "."}, "this is a folder");
  refused({"run", "lag.yaml", "--set", "tau"}, "name=value");
  refused({"run", "lag.yaml", "--set", "=3"}, "name=value");
  refused({"run", "lag.yaml", "--set", "tau="}, "name=value");
  refused({"run", "lag.yaml", "--set", "taw=1s"},
          "--set taw=1s: there is no parameter 'taw'; did you mean 'tau'?");
  refused({"run", "lag.yaml", "--set", "tau=[1"}, "--set tau=[1: tau: ");
  refused({"run", "lag.yaml", "--set", "tau=1kg"}, "--set tau=1kg: ");
  refused({"run", "lag.yaml", "--set", "lag.tau=-1s"}, "lag.tau: -1s is not allowed");
  refused({"run", "lag.yaml", "--stop", "0.5ms"}, "--stop 0.5ms: stop: ");
  refused({"run", "lag.yaml", "--stop", "-1s"}, "--stop -1s: stop: -1s is not allowed");
  refused({"run", "lag.yaml", "--stop", "soon"}, "--stop soon: stop: ");
  refused({"thesis", "--only", "fig99"}, "begins with fig99");
}

TEST_CASE("all faults that one pass finds are told, one line each with its place, in order") {
  const Scratch folder;
  folder.file("a.yaml",
              "stepwire: 1\nstep: 1 ms\nstop: 1 s\ntitel: x\nblocks:\n  a: {block: Gian, u: b}\n  b: {block: "
              "Lag, u: c, tau: -1}\n");
  const Done done = run_program(folder, {"check", "a.yaml"});
  CHECK(done.code == 2);
  const auto lines = lines_of(done.err);
  REQUIRE(lines.size() >= 4);
  CHECK_THAT(lines[0], Contains("a.yaml:4:1: ") && Contains("did you mean 'title'"));
  CHECK_THAT(lines[1], Contains("a.yaml:6:14: a: there is no block 'Gian'; did you mean 'Gain'?"));
  for (const std::string& line : lines) CHECK_THAT(line, Catch::StartsWith("a.yaml:"));
}

TEST_CASE("a value that stops being finite ends with 2, told once, with block, port and time") {
  const Scratch folder;
  folder.file("a.yaml",
              replaced(replaced(lag_yaml, "{block: Lag, u: reference, tau: $tau}",
                                "{block: Integrator, u: grow}\n  grow: {block: Gain, gain: 1e300, u: lag}"),
                       "parameters:\n  tau: {value: 0.1 s, doc: time constant}\n", ""));
  folder.file("b.yaml",
              "stepwire: 1\ntitle: b\nstep: 1 ms\nstop: 1 s\nblocks:\n  t: {block: Clock}\n  over: {block: "
              "Divide, num: 1, den: t}\n");
  const Done done = run_program(folder, {"run", "a.yaml", "--set", "lag.initial=1"});
  INFO(done.err);
  CHECK(done.code == 2);
  CHECK(lines_of(done.err).size() == 1);
  CHECK_THAT(done.err, Contains("a.yaml:") && Contains("became") && Contains(" s; the run ends here"));
  CHECK_THAT(done.out, Contains("FAIL the lag gets there") && Contains("the run ended early"));
}

TEST_CASE("the worst of several files decides, and the others are run all the same") {
  const Scratch folder;
  folder.file("good.yaml", lag_yaml);
  folder.file("fails.yaml", replaced(lag_yaml, "at_least: 0.9", "at_least: 2"));
  folder.file("bad.yaml", "stepwire: 1\n");
  const Done done = run_program(folder, {"run", "bad.yaml", "fails.yaml", "good.yaml"});
  CHECK(done.code == 2);
  CHECK_THAT(done.out, Contains("fails.yaml") && Contains("good.yaml"));
  CHECK(run_program(folder, {"run", "good.yaml", "fails.yaml"}).code == 1);
}

TEST_CASE("check finds what run would find before its first step") {
  const Scratch folder;
  const auto refused = [&](const std::string& yaml, const std::string& part) {
    folder.file("a.yaml", yaml);
    const Done done = run_program(folder, {"check", "a.yaml"});
    INFO(done.err);
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Contains(part));
  };
  refused(replaced(lag_yaml, "final: lag", "final: lug"), "a.yaml:14:");
  refused(replaced(lag_yaml, "y: lag", "y: lug"), "a.yaml:12:");
  refused(replaced(lag_yaml, "[reference, lag]", "[reference, lug]"), "a.yaml:11:");
  refused(lag_yaml + "sweep: {tau: {values: [0.1 s, -1 s]}}\n",
          "lag.tau: -1 s is not allowed; it must be above 0 (in the run with tau=-1 s)");
  refused(lag_yaml + "sweep: {taw: {values: [0.1 s, 1 s]}}\n", "there is no parameter 'taw'");
  folder.file("a.yaml", lag_yaml);
  const Done done = run_program(folder, {"check", "a.yaml"});
  CHECK(done.code == 0);
  CHECK(lines_of(done.out).size() == 1);
}

TEST_CASE("the help of each verb shows an example") {
  const Scratch folder;
  for (const std::string verb : {"run", "check", "thesis", "blocks", "format", "schema"}) {
    const Done done = run_program(folder, {verb, "--help"});
    CHECK(done.code == 0);
    CHECK(done.err.empty());
    CHECK_THAT(done.out, Contains("Example:\n  stepwire " + verb));
  }
  CHECK(run_program(folder, {"--help"}).code == 0);
  CHECK_THAT(run_program(folder, {"--version"}).out, Catch::StartsWith("stepwire "));
}
