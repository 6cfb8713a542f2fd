#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;
using Catch::StartsWith;

namespace {

/// A lag that is to be found (0.2 s) beside the truth.
const std::string fit_yaml = R"(stepwire: 1
title: A lag is found
step: 10 ms
stop: $until
solver: rk4
parameters:
  tau: {value: 1 s, above: 0 s, doc: x}
  until: {value: 2 s, doc: x}
fit:
  parameters: {tau: {start: 1 s, bounds: [10 ms, 10 s]}}
  compare: [{model: lag, measured: truth}]
blocks:
  sine: {block: Sine, frequency: 1 Hz}
  truth: {block: Lag, u: sine, tau: 0.2 s}
  lag: {block: Lag, u: sine, tau: $tau}
record: [lag, truth]
claims:
  - {that: the lag is found, final: $tau, equals: 0.2 s, within: 1e-6 s}
)";

nlohmann::json json_file(const Scratch& folder, const std::string& name) {
  return nlohmann::json::parse(content_of(folder.path(name)));
}

}  // namespace

TEST_CASE("fit finds the parameters, writes them, and judges the claims with them") {
  const Scratch folder;
  folder.file("a.yaml", fit_yaml);
  const Done done = run_program(folder, {"fit", "a.yaml", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, StartsWith("fit: 1 number, 201 rows, ") && Contains("  tau  0.2 s"));
  const nlohmann::json fit = json_file(folder, "out/fit.json");
  CHECK(fit["parameters"][0]["value"].get<double>() == Approx(0.2));
  CHECK(fit["parameters"][0]["unit"] == "s");
  CHECK(fit["records"][0]["fit"][0].get<double>() > 99.99);
  CHECK(json_file(folder, "out/claims.json")[0]["holds"] == true);
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
}

TEST_CASE("run fits first, and where the call sets all that is sought it predicts and judges with that") {
  const Scratch folder;
  folder.file("a.yaml", fit_yaml);
  REQUIRE(run_program(folder, {"run", "a.yaml", "--out", "out"}).code == 0);
  const Done predicted = run_program(folder, {"run", "a.yaml", "--set-from", "out/parameters.yaml"});
  INFO(predicted.err << predicted.out);
  CHECK(predicted.code == 0);
  CHECK_THAT(predicted.out,
             StartsWith("fit: the call sets all parameters, by which 201 rows are predicted") &&
                 Contains("the record  100.00 %"));
  const Done given = run_program(folder, {"fit", "a.yaml", "--set", "tau=0.3s", "--out", "other"});
  CHECK(given.code == 1);  // the claim does not hold
  // Of a sine the lag gives gain 1/sqrt(1 + (w tau)^2) and phase -atan(w tau): 0.3 s is far from 0.2 s.
  const double agreement = json_file(folder, "other/fit.json")["records"][0]["fit"][0].get<double>();
  CHECK(agreement > 50.0);
  CHECK(agreement < 75.0);
  CHECK(run_program(folder, {"verify", "other"}).code == 0);
}

TEST_CASE("a parameter at its bound is a note, which --strict makes a failure") {
  const Scratch folder;
  std::string text = fit_yaml;
  text.replace(text.find("bounds: [10 ms, 10 s]"), 21, "bounds: [0.5 s, 10 s]");
  text.erase(text.find("claims:"));
  folder.file("a.yaml", text);
  const Done done = run_program(folder, {"fit", "a.yaml"});
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("note: tau is at its lower bound"));
  CHECK(run_program(folder, {"fit", "a.yaml", "--strict"}).code == 1);
  folder.file("good.yaml", fit_yaml);
  CHECK(run_program(folder, {"fit", "good.yaml", "--strict"}).code == 0);
}

TEST_CASE("a block that nothing reads is a note, which --strict makes a failure of check and run") {
  const Scratch folder;
  folder.file("a.yaml",
              "stepwire: 1\ntitle: t\nstep: 1 s\nstop: 1 s\nblocks:\n  a: {block: Constant, value: 1}\n"
              "  b: {block: Constant, value: 2}\nrecord: [a]\n");
  for (const char* verb : {"check", "run"}) {
    CHECK(run_program(folder, {verb, "a.yaml"}).code == 0);
    CHECK(run_program(folder, {verb, "a.yaml", "--strict"}).code == 1);
  }
}

TEST_CASE("a fit says of a constant record that it is constant, and Ceres says nothing") {
  const Scratch folder;
  std::string text = fit_yaml;
  text.replace(text.find("measured: truth"), 15, "measured: flat ");
  text.replace(text.find("truth: {block: Lag, u: sine, tau: 0.2 s}"), 40,
               "truth: {block: Lag, u: sine, tau: 0.2 s}\n  flat: {block: Constant, value: 0.1}");
  text.replace(text.find("record: [lag, truth]"), 20, "record: [lag, flat]");
  folder.file("a.yaml", text);
  const Done done = run_program(folder, {"fit", "a.yaml"});
  CHECK_THAT(done.out, Contains("the record  constant"));
  CHECK_THAT(done.out, !Contains("e+") && !Contains("nan"));
}

TEST_CASE("a fit that has not converged ends with 1, and all its files are written") {
  const Scratch folder;
  std::string text = fit_yaml;
  text.replace(text.find("  compare:"), 0, "  iterations: 1\n");
  text.erase(text.find("claims:"));
  folder.file("a.yaml", text);
  const Done done = run_program(folder, {"fit", "a.yaml", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 1);
  CHECK_THAT(done.out, Contains("not converged: allow more 'iterations'"));
  CHECK(json_file(folder, "out/fit.json")["converged"] == false);
  CHECK_THAT(content_of(folder.path("out/parameters.yaml")), Contains("tau"));
  CHECK_FALSE(content_of(folder.path("out/signals.csv")).empty());
}

TEST_CASE("any diagram takes what a fit wrote") {
  const Scratch folder;
  folder.file("a.yaml", fit_yaml);
  REQUIRE(run_program(folder, {"fit", "a.yaml", "--out", "out"}).code == 0);
  folder.file("b.yaml",
              "stepwire: 1\ntitle: b\nstep: 1 ms\nstop: 1 ms\nparameters: {tau: 1 s}\n"
              "blocks: {t: {block: Constant, value: $tau}}\nrecord: t\n"
              "claims: [{that: it is taken, final: t, equals: 0.2 s, within: 1e-6 s}]\n");
  CHECK(run_program(folder, {"run", "b.yaml"}).code == 1);
  CHECK(run_program(folder, {"run", "b.yaml", "--set-from", "out/parameters.yaml"}).code == 0);
  CHECK(run_program(folder, {"run", "b.yaml", "--set-from", "out/parameters.yaml", "--set", "tau=1s"}).code ==
        1);
  folder.file("map.yaml", "tau: {a: 1}\n");
  const Done refused = run_program(folder, {"run", "b.yaml", "--set-from", "map.yaml"});
  CHECK(refused.code == 2);
  CHECK_THAT(refused.err, StartsWith("map.yaml:1:6: tau: a file of settings has lines such as"));
}

TEST_CASE("a file without a section fit is refused by fit") {
  const Scratch folder;
  folder.file("a.yaml", lag_yaml);
  const Done done = run_program(folder, {"fit", "a.yaml"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("has no section 'fit'; it names parameters and records"));
}

TEST_CASE("check finds what is wrong with a fit before anything runs") {
  const Scratch folder;
  std::string text = fit_yaml;
  text.replace(text.find("measured: truth"), 15, "measured: trut ");
  folder.file("a.yaml", text);
  const Done done = run_program(folder, {"check", "a.yaml"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, StartsWith("a.yaml:11:") && Contains("did you mean 'truth'?"));
}

TEST_CASE("an interrupted fit ends with 130 and writes the best so far", "[full]") {
  const Scratch folder;
  std::string text = fit_yaml;
  text.replace(text.find("until: {value: 2 s"), 18, "until: {value: 2000 s");
  text.replace(text.find("blocks:"), 7, "  starts: 1000\nblocks:");
  folder.file("a.yaml", text);
  Call call;
  call.arguments = {"fit", "a.yaml", "--out", "out"};
  call.interrupt_after = 4.0;
  const Done done = run_program(folder, call);
  INFO(done.err << done.out);
  CHECK(done.code == 130);
  CHECK_THAT(done.out, Contains("interrupted: this is the best so far") && Contains("  tau  "));
  CHECK(json_file(folder, "out/fit.json")["interrupted"] == true);
  CHECK_THAT(content_of(folder.path("out/parameters.yaml")), Contains("tau: "));
}

TEST_CASE("a fit that is interrupted in its first run says so, and blames no file") {
  const Scratch folder;
  std::string text = fit_yaml;
  text.replace(text.find("step: 10 ms"), 11, "step: 1 us");
  text.replace(text.find("until: {value: 2 s"), 18, "until: {value: 60 s");
  text.replace(text.find("record: [lag, truth]"), 20, "record: {every: 10 ms, signals: [lag, truth]}");
  folder.file("a.yaml", text);
  Call call;
  call.arguments = {"fit", "a.yaml", "--engine", "interpreted", "--out", "out"};
  call.interrupt_after = 1.0;
  const Done done = run_program(folder, call);
  CHECK(done.code == 130);
  CHECK(done.err.empty());
  CHECK_THAT(done.out, StartsWith("fit: interrupted before the first run was done"));
  CHECK(content_of(folder.path("out/fit.json")).empty());
}
