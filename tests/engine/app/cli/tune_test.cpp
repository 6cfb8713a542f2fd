#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;
using Catch::StartsWith;

namespace {

/// Returns a diagram that finds a lag of 0.2 s by the error of its response; `claims` is the value of
/// subject_to.
std::string tune_yaml(const std::string& claims = "[]") {
  return R"(stepwire: 1
title: A lag is tuned
step: 10 ms
stop: 2 s
solver: rk4
parameters: {tau: {value: 1 s, above: 0 s, doc: x}}
tune:
  parameters: {tau: {from: 10 ms, to: 10 s}}
  minimise: rms(lag - truth)
  subject_to: )" +
         claims + R"(
blocks:
  sine: {block: Sine, frequency: 1 Hz}
  truth: {block: Lag, u: sine, tau: 0.2 s}
  lag: {block: Lag, u: sine, tau: $tau}
record: [lag, truth]
claims:
  - {that: the lag is found, final: $tau, equals: 0.2 s, within: 0.5 %}
)";
}

nlohmann::json json_of(const Scratch& folder, const std::string& name) {
  return nlohmann::json::parse(content_of(folder.path(name)));
}

}  // namespace

TEST_CASE("tune finds the parameters, writes them with their history, and judges the claims with them") {
  const Scratch folder;
  folder.file("a.yaml", tune_yaml());
  const Done done = run_program(folder, {"tune", "a.yaml", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, StartsWith("tune: 1 parameter, ") && Contains("; bobyqa\n") && Contains(" s ") &&
                           Contains("from 1 s\n") && Contains("ok   the lag is found"));
  const nlohmann::json tune = json_of(folder, "out/tune.json");
  CHECK(tune["parameters"][0]["value"].get<double>() == Approx(0.2).epsilon(5e-3));
  CHECK(tune["parameters"][0]["unit"] == "s");
  CHECK(tune["feasible"] == true);
  CHECK_THAT(content_of(folder.path("out/tune-history.csv")),
             StartsWith("evaluation,start,state,tau [s],objective\n1,1,holds,1,"));
  CHECK_THAT(content_of(folder.path("out/tune-history.svg")), Contains("<svg"));
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
  const Done again = run_program(folder, {"run", "a.yaml", "--set-from", "out/parameters.yaml"});
  CHECK(again.code == 0);
  CHECK(run_program(folder, {"run", "a.yaml"}).code == 1);  // with the file's own value
}

TEST_CASE("Where claims never hold, tune names the one in the way, sets nothing and ends with 2") {
  const Scratch folder;
  folder.file("a.yaml", tune_yaml("[{that: it is above all, max: lag, at_least: 3}]"));
  const Done done = run_program(folder, {"tune", "a.yaml", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 2);
  CHECK_THAT(done.out, Contains("no point holds all claims") && Contains("FAIL it is above all") &&
                           Contains("note: 'it is above all' is in the way: nowhere nearer than 0.99"));
  CHECK(json_of(folder, "out/tune.json")["feasible"] == false);
  CHECK(json_of(folder, "out/tune.json")["claims"][0]["margin"].get<double>() < -2.0);
  CHECK_FALSE(std::filesystem::exists(folder.path("out/parameters.yaml")));
}

TEST_CASE("tune refuses a file without the section, and gives its result as JSON") {
  const Scratch folder;
  std::string without = tune_yaml();
  without.erase(without.find("tune:\n"), without.find("blocks:") - without.find("tune:\n"));
  folder.file("without.yaml", without);
  const Done refused = run_program(folder, {"tune", "without.yaml"});
  CHECK(refused.code == 2);
  CHECK_THAT(refused.err, Contains("has no section 'tune'; it names parameters and what is minimised"));
  folder.file("a.yaml", tune_yaml());
  const Done done = run_program(folder, {"tune", "a.yaml", "--json", "--evaluations", "5", "--threads", "1"});
  const nlohmann::json results = nlohmann::json::parse(done.out);
  CHECK(results[0]["tune"]["evaluations"] == 5);
  CHECK(results[0]["tune"]["converged"] == false);
}

TEST_CASE("An interrupted tune keeps the best so far, and says so") {
  const Scratch folder;
  std::string endless = tune_yaml();
  endless.replace(endless.find("  subject_to"), 0,
                  "  method: isres\n  evaluations: 10000000\n  tolerance: 1e-300\n");
  folder.file("a.yaml", endless);
  Call call;
  call.arguments = {"tune", "a.yaml", "--out", "out"};
  call.interrupt_after = 1.5;  // [s] some evaluations are done by then also on a busy machine
  const Done done = run_program(folder, call);
  INFO(done.err << done.out);
  CHECK(done.code == 130);
  CHECK_THAT(done.out, Contains("; interrupted: this is the best so far"));
  const nlohmann::json tune = json_of(folder, "out/tune.json");
  CHECK(tune["interrupted"] == true);
  CHECK(tune["objective"].get<double>() <= tune["start_objective"].get<double>());
  CHECK(std::filesystem::exists(folder.path("out/parameters.yaml")));
}

TEST_CASE("The gains in the example of a PID controller are those that tune finds", "[full]") {
  const Scratch folder;
  const std::string example = STEPWIRE_SOURCE_DIR "/diagrams/examples/141-pid-tuned.yaml";
  const Done done = run_program(folder, {"tune", example, "--starts", "1", "--json"});
  CHECK(done.code == 0);
  const nlohmann::json results = nlohmann::json::parse(done.out), tune = results[0]["tune"];
  const std::string file = content_of(example);
  for (const auto& parameter : tune["parameters"]) {
    const std::string key = "  " + parameter["name"].get<std::string>() + ": {value: ";
    const double written = std::stod(file.substr(file.find(key) + key.size()));
    CHECK(parameter["value"].get<double>() == Approx(written).epsilon(0.02));
  }
  CHECK(tune["parameters"].size() == 3);
  CHECK(tune["converged"] == true);
}

TEST_CASE("tune prints the Jacobian of its targets, in their deviations from bound to bound") {
  // The sum changes by 10/0.5 from bound to bound of a and of b, the difference by 10/0.1 and -10/0.1.
  const Scratch folder;
  folder.file("a.yaml", R"(stepwire: 1
title: Two numbers by their sum and their difference
step: 1 s
stop: 1 s
parameters: {a: {value: 0, doc: x}, b: {value: 0, doc: x}}
tune:
  parameters: {a: {from: -5, to: 5}, b: {from: -5, to: 5}}
  toward:
    - {that: the sum is 3, final: both, equals: 3, within: 0.5}
    - {that: the difference is 1, final: apart, equals: 1, within: 0.1}
blocks:
  both: {block: Sum, u: [$a, $b]}
  apart: {block: Sum, signs: "+-", u: [$a, $b]}
record: [both, apart]
)");
  const Done done = run_program(folder, {"tune", "a.yaml"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("target the sum is 3: 3, ") &&
                           Contains("\n    deviations from bound to bound: a 20, b 20\n") &&
                           Contains("\n    deviations from bound to bound: a 100, b -100\n"));
}

TEST_CASE("a tuning that has not converged ends with 1, and all its files are written") {
  const Scratch folder;
  std::string text = tune_yaml();
  text.erase(text.find("claims:\n"));
  folder.file("a.yaml", text);
  const Done done = run_program(folder, {"tune", "a.yaml", "--evaluations", "5", "--out", "out"});
  INFO(done.err << done.out);
  CHECK(done.code == 1);
  CHECK_THAT(done.out, Contains("not converged: allow more 'evaluations'"));
  CHECK(json_of(folder, "out/tune.json")["parameters"].size() == 1);
  CHECK_FALSE(content_of(folder.path("out/signals.csv")).empty());
}
