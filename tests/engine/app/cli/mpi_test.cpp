#include <sys/types.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>

#include "tests/engine/app/cli/mpi_call.hpp"
#include "tests/engine/app/cli/small_study.hpp"

using Catch::Contains;

namespace {

using Words = std::vector<std::string>;

/// A verb with a file whose items take long enough to be seen, and what it writes to the same bytes each
/// time.
struct Verb {
  std::string name, text;
  Words words;  ///< behind verb and file
  std::string journal;
  Words same;

  Words call() const {
    Words all{name, "file.yaml"};
    all.insert(all.end(), words.begin(), words.end());
    return all;
  }
};

/// A lag that is looked for beside the truth, by the error of its response to a sine.
std::string search_yaml(const std::string& section) {
  return "stepwire: 1\ntitle: A lag is looked for\nstep: 1 ms\nstop: 100 s\nsolver: rk4\n"
         "parameters:\n  tau: {value: 1 s, above: 0 s, doc: x}\n  gain: {value: 3, doc: x}\n" +
         section + R"(blocks:
  sine: {block: Sine, frequency: 1 Hz}
  truth: {block: Lag, u: sine, tau: 0.2 s, gain: 2}
  lag: {block: Lag, u: sine, tau: $tau, gain: $gain}
record: {every: 1 s, signals: [lag, truth]}
)";
}

const std::string fit_section = R"(fit:
  parameters: {tau: {start: 1 s, bounds: [10 ms, 10 s]}, gain: {start: 3, bounds: [0.1, 10]}}
  compare: [{model: lag, measured: truth}]
  starts: 16
)";
const std::string tune_section = R"(tune:
  parameters: {tau: {from: 10 ms, to: 10 s}, gain: {from: 0.1, to: 10}}
  minimise: rms(lag - truth)
  starts: 16
  evaluations: 25
)";

Verb run_verb() {
  return {"run",
          endless_yaml + "sweep: {lag.tau: {from: 0.1 s, to: 0.2 s, count: 24}}\n",
          {"--stop", "3000 s", "--engine", "interpreted"},
          "points.journal",
          {"signals.csv", "signals.mat", "sweep.csv", "diagram.yaml"}};
}

Verb study_verb(const std::string& more) {
  return {
      "study",
      replaced(small_study(), "step: 10 ms", "step: 0.05 ms"),
      {"--repeat", more, "--engine", "interpreted"},
      "study.journal",
      {"signals.csv", "signals.mat", "trials.csv", "errors.csv", "study.json", "tables.txt", "claims.json"}};
}

Verb fit_verb() {
  return {"fit",
          search_yaml(fit_section),
          {"--engine", "interpreted"},
          "fit.journal",
          {"parameters.yaml", "signals.csv", "diagram.yaml"}};
}

Verb tune_verb() {
  return {"tune",
          search_yaml(tune_section),
          {"--engine", "interpreted"},
          "tune.journal",
          {"parameters.yaml", "tune-history.csv", "signals.csv", "diagram.yaml"}};
}

void run_alone(const Scratch& folder, const Verb& verb) {
  folder.file("file.yaml", verb.text);
  Words words = verb.call();
  words.insert(words.end(), {"--out", "whole"});
  const Done done = run_program(folder, words);
  INFO(done.err);
  REQUIRE(done.code == 0);
}

void check_same(const Scratch& folder, const Verb& verb) {
  for (const std::string& file : verb.same) {
    INFO(file);
    const std::string content = content_of(folder.path("whole/" + file));
    CHECK_FALSE(content.empty());
    CHECK(content == content_of(folder.path("shared/" + file)));
  }
  CHECK_FALSE(std::filesystem::exists(folder.path("shared/" + verb.journal)));
}

/// Runs it by three processes, of which one's worker is killed, and then again.
void lose_a_worker(const Verb& verb) {
  const Scratch folder;
  run_alone(folder, verb);
  const Done lost = run_by_three(
      folder, verb.call(), [&] { ::kill(processes_at_work(folder, verb.journal).workers.back(), SIGKILL); });
  INFO(lost.err);
  CHECK(lost.code == 3);
  CHECK_THAT(lost.err, Contains("has died (signal 9), and with it ") && Contains("the same call goes on"));
  const Done again = run_by_three(folder, verb.call());
  INFO(again.err);
  CHECK(again.code == 0);
  CHECK_THAT(again.err, Contains("are there from an earlier call") || Contains("are kept"));
  check_same(folder, verb);
}

}  // namespace

TEST_CASE("a sweep, a study, a fit and a tuning by processes of mpirun give the bytes of one process",
          "[full]") {
  if (!has_mpi()) return;
  Verb fit = fit_verb(), tune = tune_verb(), run = run_verb();
  for (Verb* verb : {&fit, &tune, &run}) verb->words.insert(verb->words.end(), {"--stop", "10 s"});
  run.words = {"--stop", "10 s"};
  Verb study = study_verb("3");
  study.text = small_study();
  for (const Verb& verb : {run, study, fit, tune}) {
    INFO(verb.name);
    const Scratch folder;
    run_alone(folder, verb);
    const Done done = run_by_three(folder, verb.call());
    INFO(done.err);
    CHECK(done.code == 0);
    CHECK(done.err.empty());
    check_same(folder, verb);
  }
}

TEST_CASE("where the worker of a process is killed, the call ends with 3 and the same one finishes a sweep",
          "[full]") {
  if (has_mpi()) lose_a_worker(run_verb());
}

TEST_CASE("where the worker of a process is killed, the call ends with 3 and the same one finishes a study",
          "[full]") {
  if (has_mpi()) lose_a_worker(study_verb("14"));
}

TEST_CASE("where the worker of a process is killed, the call ends with 3 and the same one finishes a fit",
          "[full]") {
  if (has_mpi()) lose_a_worker(fit_verb());
}

TEST_CASE("where the worker of a process is killed, the call ends with 3 and the same one finishes a tuning",
          "[full]") {
  if (has_mpi()) lose_a_worker(tune_verb());
}

TEST_CASE("where mpirun loses a process itself it ends all, and the same call finishes what is kept",
          "[full]") {
  if (!has_mpi()) return;
  const Verb verb = run_verb();
  const Scratch folder;
  run_alone(folder, verb);
  const Done lost = run_by_three(
      folder, verb.call(), [&] { ::kill(processes_at_work(folder, verb.journal).ranks.back(), SIGKILL); });
  INFO(lost.err);
  CHECK(lost.code == 128 + SIGKILL);
  const Done again = run_by_three(folder, verb.call());
  CHECK(again.code == 0);
  CHECK_THAT(again.err, Contains("of 24 points are there from an earlier call"));
  check_same(folder, verb);
}

TEST_CASE("processes of mpirun run a share of a sweep") {
  if (!has_mpi()) return;
  const Scratch folder;
  Verb verb = run_verb();
  verb.words = {"--stop", "10 s"};
  run_alone(folder, verb);
  Words words = verb.call();
  words.insert(words.end(), {"--part", "2/2"});
  const Done done = run_by_three(folder, words);
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("share 2 of 2, 12 of 24 points"));
  REQUIRE(run_program(folder, {"run", "file.yaml", "--stop", "10 s", "--part", "1/2", "--out", "one"}).code ==
          0);
  REQUIRE(run_program(folder, {"collect", "one", "shared", "--out", "all"}).code == 0);
  for (const std::string file : {"signals.csv", "signals.mat"})
    CHECK(content_of(folder.path("all/" + file)) == content_of(folder.path("whole/" + file)));
}

TEST_CASE("what is wrong in a person's trials is said once, as by one process") {
  if (!has_mpi()) return;
  const Scratch folder;
  folder.file("file.yaml", replaced(small_study(), "stop: ", "stop: 2 ms # "));
  const Done alone = run_program(folder, {"study", "file.yaml", "--out", "whole"});
  CHECK(alone.code == 2);
  const Done done = run_by_three(folder, {"study", "file.yaml"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains(alone.err));
}

TEST_CASE("processes share what can be shared, in a folder") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  CHECK_THAT(run_program(folder, {"run", "lag.yaml", "--mpi", "--out", "x"}).err,
             Contains("--mpi: needs a file with a section 'sweep', 'study' or 'fit'") ||
                 Contains("the folder 'mpi' that comes with stepwire is not there"));
}
