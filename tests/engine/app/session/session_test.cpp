// The application without a terminal.
#include "engine/app/session/session.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <mutex>
#include <set>

#include "blocks/register.hpp"
#include "engine/app/session/loop_run.hpp"
#include "tests/engine/app/cli/small_study.hpp"

namespace stepwire::session {

namespace {

const Registry& library() {
  static const Registry registry = blocks();
  return registry;
}

/// Counts what it is shown, from any thread.
struct Counting : run::RunObserver {
  void begin(const run::ObservedRun& run) override {
    const std::lock_guard lock(mutex);
    begun.insert(run.index);
  }
  void row(const run::ObservedRun&, std::size_t, std::span<const double>) override {
    const std::lock_guard lock(mutex);
    ++rows;
  }
  void end(const run::ObservedRun&) override {
    const std::lock_guard lock(mutex);
    ++ended;
  }

  std::mutex mutex;
  std::set<std::size_t> begun;
  std::size_t rows = 0, ended = 0;
};

std::string lag(const std::string& more) {
  return "stepwire: 1\ntitle: t\nstep: 1 ms\nstop: 50 ms\nsolver: rk4\nparameters: {tau: 10 ms}\nrecord: "
         "[lag]\n" +
         more + "blocks:\n  one: {block: Constant, value: 1}\n  lag: {block: Lag, tau: $tau, u: one}\n";
}

}  // namespace

TEST_CASE("a session watches a run, a sweep and a study by the same observer") {
  const Scratch folder;
  folder.file("lag.yaml", lag(""));
  folder.file("sweep.yaml", lag("sweep: {tau: [10 ms, 20 ms, 40 ms]}\n"));
  folder.file("study.yaml", small_study());
  Session session(library());
  const auto rows_of = [](const Outcome& outcome) { return outcome.result.recordings[0].table.rows(); };
  SECTION("run") {
    Counting counting;
    session.monitor().observers = {&counting};
    CHECK(rows_of(session.run(session.load(folder.path("lag.yaml")))) == 51);
    CHECK(counting.rows == 51);
  }
  SECTION("sweep") {
    Counting counting;
    session.monitor().observers = {&counting};
    CHECK(rows_of(session.run(session.load(folder.path("sweep.yaml")))) == 153);
    CHECK(counting.begun == std::set<std::size_t>{0, 1, 2});
    CHECK(counting.rows == 153);
    CHECK(counting.ended == 3);
  }
  SECTION("study: six people under four conditions") {
    Counting counting;
    session.monitor().observers = {&counting};
    LoadedModel model = session.load(folder.path("study.yaml"));
    const Outcome outcome = study_outcome(model, *session.study(model));
    CHECK(counting.begun.size() == 24);
    CHECK(*counting.begun.rbegin() == 23);
    CHECK(counting.ended == 24);
    CHECK(counting.rows > 24);
  }
}

TEST_CASE("a setting that is without effect at the first point of a sweep makes another study") {
  const Scratch folder;
  std::string text = replaced(small_study(), "(1 + 2*haptic + 4*visual)", "(1 + 2*felt*haptic + 4*visual)");
  text = replaced(text, "  sway: ",
                  "  learnt: {value: 1, doc: how well it is felt}\n"
                  "  felt: {value: = learnt, doc: what the sway has of it}\n  sway: ");
  folder.file("study.yaml", replaced(text, "study:\n", "sweep: {learnt: [1, 3]}\nstudy:\n"));
  Session session(library());
  const auto errors = [&](const std::vector<diagram::Setting>& settings, std::size_t point) {
    const LoadedModel model = session.load(folder.path("study.yaml"), {.settings = settings});
    std::vector<double> errors;
    for (const study::PathError& row : session.study(model)->at(point).errors.rows)
      errors.push_back(row.error);
    return errors;
  };
  CHECK(errors({}, 0) != errors({}, 1));
  CHECK(errors({{"felt", "1"}}, 1) == errors({}, 0));
}

TEST_CASE("a session watches a real-time loop, and ends it by an observer") {
  struct Stops : Counting {
    run::Flow before_tick(const run::ObservedRun& run) override {
      return run.simulation.tick() < 5 ? run::Flow::go_on : run::Flow::stop;
    }
  } stops;
  const Scratch folder;
  folder.file("lag.yaml", lag(""));
  LoopCall call;
  call.file = folder.path("lag.yaml");
  call.words.policy = "other";
  Monitor monitor;
  monitor.observers = {&stops};
  std::int64_t steps = 0;
  auto end = realtime::Loop::End::done;
  run_loop(call, library(), monitor, [&](const LoopOutcome& outcome) {
    steps = outcome.loop.simulation().tick();
    end = outcome.loop.end();
  });
  CHECK(end == realtime::Loop::End::stopped);
  CHECK(steps == 5);
  CHECK(stops.rows == 5);
  CHECK(stops.ended == 1);
}

TEST_CASE("a session returns what is wrong as an error, and prints nothing") {
  const Scratch folder;
  folder.file("a.yaml", lag("").replace(lag("").find("Lag"), 3, "Lak"));
  CHECK_THROWS_AS(Session(library()).load(folder.path("a.yaml")), yaml::Error);
}

TEST_CASE("a session tunes a model, shows how far it is, and loads it with what was found") {
  // 1 - exp(-t/tau) is 0.5 after 50 ms where tau is 50 ms/log 2.
  const Scratch folder;
  folder.file("lag.yaml", lag("tune:\n  parameters: {tau: {from: 5 ms, to: 1 s}}\n"
                              "  minimise: abs(final(lag) - 0.5)\n  method: subplex\n  tolerance: 1e-6\n"));
  Session session(library());
  double shown = 0.0;
  session.monitor().progress = [&](double fraction, const std::string&) {
    shown = std::max(shown, fraction);
  };
  const LoadedModel model = session.load(folder.path("lag.yaml"));
  const tuning::TuneResult result = session.tune(model, {.evaluations = 300});
  CHECK(result.numbers.at(0).value == Approx(0.05 / std::log(2.0)).epsilon(1e-4));
  CHECK(shown > 0.0);
  const Outcome outcome = session.run(session.tuned(model, result));
  CHECK(outcome.result.recordings[0].table.find("lag")->values.back() == Approx(0.5).margin(1e-4));
}

TEST_CASE("an interrupted session keeps what was recorded") {
  const Scratch folder;
  folder.file("lag.yaml", lag("").replace(lag("").find("50 ms"), 5, "10 s"));
  const std::atomic<bool> at_once = true;
  Monitor monitor;
  monitor.interrupt = &at_once;
  Session session(library(), monitor);
  const Outcome outcome = session.run(session.load(folder.path("lag.yaml")), run::ExecutionMode::interpreted);
  CHECK(outcome.early());
  CHECK(outcome.result.interrupted);
  const std::size_t rows = outcome.result.recordings[0].table.rows();
  CHECK(rows > 0);
  CHECK(rows < 10'001);
}

}  // namespace stepwire::session
