// Errors of the everyday kind, word by word.
#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::diagram {

namespace {

const std::string head =
    "stepwire: 1\ntitle: A lag follows a constant\nstep: 1 ms\nstop: 5 s\nsolver: rk4\nparameters:\n"
    "  tau: {value: 0.5 s, doc: time constant of the lag}\nblocks:\n  reference: {block: Constant, value: "
    "1.0}\n";

std::vector<std::string> faults_with_lag(const std::string& lag) {
  const DiagramFolder folder;
  folder.write("lag_step.yaml",
               head + "  error:     {block: Sum, signs: \"+-\", u: [reference, lag]}\n" + lag + "\n");
  return folder.faults("lag_step.yaml");
}

}  // namespace

TEST_CASE("a value out of its range is refused at the value") {
  CHECK(faults_with_lag("  lag:       {block: Lag, u: error, tau: -0.5 s}") ==
        std::vector<std::string>{"lag_step.yaml:11:42: lag.tau: -0.5 s is not allowed; it must be above 0"});
}

TEST_CASE("a key that a block has not is refused at the key, with the nearest and all that it has") {
  CHECK(
      faults_with_lag("  lag:       {block: Lag, u: error,  tua: 0.5 s}") ==
      std::vector<std::string>{"lag_step.yaml:11:38: lag: Lag has no 'tua'; did you mean 'tau'? It has: tau, "
                               "gain, trigger, u, reset, value, initial, enable"});
}

TEST_CASE("a block of no known kind is the only fault, whatever is wired to it") {
  CHECK(faults_with_lag("  lag:       {block: Leg, u: error, tau: 0.5 s}") ==
        std::vector<std::string>{"lag_step.yaml:11:22: lag: there is no block 'Leg'; did you mean 'Lag'? "
                                 "'stepwire blocks' lists them"});
}

TEST_CASE("everything that one pass finds is reported at once, in the order of the file") {
  const auto refused = faults_of(R"(parameters: {bad: = 2 * (, good: 3}
blocks:
  a: {block: Gian, u: b}
  b: {block: Gain, gain: $bad, u: a}
  c: {block: Gain, gain: $god, u: [a, b]}
  d: {block: Gain, u: nowhere}
  e: {block: Gain}
  f: {u: 1}
record: [a, b, g]
)");
  CHECK(refused ==
        std::vector<std::string>{
            "test.yaml:1:26: bad: a value is missing at the end",
            "test.yaml:3:14: a: there is no block 'Gian'; did you mean 'Gain'? 'stepwire blocks' lists them",
            "test.yaml:5:26: c.gain: there is no parameter 'god'; did you mean 'good'?",
            "test.yaml:5:35: c.u: takes one signal, not a list; join signals with a Mux",
            "test.yaml:6:23: d.u: there is no block 'nowhere'",
            "test.yaml:7:6: e: the input 'u' is missing (signal)",
            "test.yaml:8:6: f: needs either 'block:' (a type), 'diagram:' (a file) or 'fields:' (of a bus)",
            "test.yaml:9:16: record: there is no block 'g'"});
}

TEST_CASE("double keys, unknown head keys and an empty file are refused where they are") {
  CHECK(faults_of("blocks:\n  a: {block: Gain, u: 1, u: 2}\n") ==
        std::vector<std::string>{"test.yaml:2:26: 'u' is given twice, first at 2:20; leave one out"});
  const auto unknown = faults_of("sovler: rk4\nblocks:\n  a: {block: Gain, u: 1}\n");
  REQUIRE(unknown.size() == 1);
  CHECK_THAT(unknown[0],
             Catch::StartsWith(
                 "test.yaml:1:1: a diagram has no 'sovler'; did you mean 'solver'? It has: stepwire, "));
  const DiagramFolder folder;
  folder.write("empty.yaml", "");
  const auto empty = folder.faults("empty.yaml");
  REQUIRE(empty.size() == 1);
  CHECK_THAT(empty[0], Catch::StartsWith("empty.yaml:1:1: this is no diagram"));
}

TEST_CASE("times of the head must be there, above 0, and times") {
  const DiagramFolder folder;
  folder.write("a.yaml", "stepwire: 1\nstep: -1 ms\nblocks:\n  a: {block: Gain, u: 1}\n");
  CHECK(folder.faults("a.yaml") ==
        std::vector<std::string>{
            "a.yaml:1:1: 'stop' is missing (end of the run, a whole multiple of the step: 5 s)",
            "a.yaml:2:7: step: -1 ms is not allowed; it must be above 0"});
  CHECK(faults_of("step: 1 mm\nblocks:\n  a: {block: Gain, u: 1}\n") ==
        std::vector<std::string>{"test.yaml:1:7: step: '1 mm' is in m; it must be in s"});
}

TEST_CASE("numbers that are not finite are refused wherever they stand") {
  for (const std::string text : {".nan", ".inf", "-.inf", "1e999", "inf", "NaN"}) {
    const std::string why = "'" + text + "' is not a finite number; give one, or leave the key out";
    CHECK(faults_of("parameters: {p: " + text + "}\nblocks:\n  a: {block: Gain, u: 1}\n") ==
          std::vector<std::string>{"test.yaml:1:17: p: " + why});
    CHECK(faults_of("blocks:\n  a: {block: Gain, u: 1, gain: " + text + "}\n") ==
          std::vector<std::string>{"test.yaml:2:32: a.gain: " + why});
    CHECK(faults_of("blocks:\n  a: {block: Gain, u: " + text + "}\n") ==
          std::vector<std::string>{"test.yaml:2:23: a.u: " + why});
    CHECK(faults_of("solver: rk4\nblocks:\n  a: {block: Integrator, u: 1, initial: " + text + "}\n") ==
          std::vector<std::string>{"test.yaml:3:41: a.initial: " + why});
  }
}

TEST_CASE("what is for people is a text, and a name names one thing") {
  const std::string block = "blocks: {c: {block: Constant, value: 1}}\n";
  const auto fault = [&](const std::string& yaml) {
    const auto refused = faults_of(yaml);
    REQUIRE(refused.size() == 1);
    return refused[0];
  };
  CHECK(fault("title: [a]\n" + block) == "test.yaml:1:8: title: a text is wanted here");
  CHECK(fault("solver: {a: b}\n" + block) ==
        "test.yaml:1:10: solver: solver has no 'a'; it has: name, relative, absolute, max_steps");
  CHECK(fault("reproduces: 15\n" + block) ==
        "test.yaml:1:13: reproduces: the original is a map: {figure: 15, section: 2.5.1}");
  CHECK(fault("blocks: {c: {block: [Constant]}}\n") == "test.yaml:1:21: c: 'block:' names one type, as Gain");
  CHECK(fault("blocks:\n  c:\n  next: {block: Constant, value: 1}\n") ==
        "test.yaml:2:3: c: must be a map such as {block: Gain, gain: 2, u: source}");
  CHECK(fault("stop: 1e300 s\n" + block) ==
        "test.yaml:1:7: stop: 1e+300 s are more than 9000000000000000 steps of 1 s");
}

TEST_CASE("a file without blocks is told nothing else") {
  CHECK(faults_of("record: c\n").size() == 1);
}

TEST_CASE("a decimal comma and a formula with a comma are called so") {
  const auto refused = faults_of("blocks: {c: {block: Constant, value: 0,5 N}}\n");
  REQUIRE(refused.size() == 1);
  CHECK_THAT(refused[0], Catch::Contains("Constant has no '5 N'; a comma ends a value"));
}

}  // namespace stepwire::diagram
