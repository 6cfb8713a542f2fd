#include "engine/simulate/run/observer.hpp"

#include <catch2/catch.hpp>
#include <mutex>
#include <set>

#include "engine/simulate/run/drive.hpp"
#include "engine/simulate/run/run.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::run {

namespace {

const std::string ramp =
    "step: 1 s\nstop: 6 s\nsolver: rk4\nparameters: {k: 2}\nblocks:\n  c: {block: Constant, value: 1}\n"
    "  g: {block: Gain, gain: $k, u: c}\n  x: {block: Integrator, u: g}\n"
    "record: [x, {every: 3 s, signals: [g]}]\n";

/// Keeps what it is shown.
struct Witness : RunObserver {
  void begin(const ObservedRun& run) override {
    const std::lock_guard lock(mutex);
    begun.insert(run.index);
  }
  void row(const ObservedRun& run, std::size_t recording, std::span<const double> numbers) override {
    const std::lock_guard lock(mutex);
    rows[{run.index, recording}].emplace_back(numbers.begin(), numbers.end());
  }
  void end(const ObservedRun& run) override {
    const std::lock_guard lock(mutex);
    ended.insert(run.index);
  }

  std::mutex mutex;
  std::set<std::size_t> begun, ended;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::vector<double>>> rows;
};

/// Rows of a recording's run.
std::vector<std::vector<double>> rows_of(const record::Recording& recording, std::size_t first,
                                         std::size_t count) {
  std::vector<std::vector<double>> rows(count);
  for (std::size_t k = 0; k < count; ++k)
    for (const table::Column& column : recording.table.columns) rows[k].push_back(column.values[first + k]);
  return rows;
}

}  // namespace

TEST_CASE("an observer is shown every row that is recorded, while the run goes on") {
  const plan::Plan plan = plan_text(ramp);
  Witness witness;
  RunOptions options;
  options.observers = {&witness};
  const RunResult result = run_plan(plan, options);
  CHECK(witness.rows[{0, 0}] == rows_of(result.recordings[0], 0, 7));
  CHECK(witness.rows[{0, 1}] == rows_of(result.recordings[1], 0, 3));
  CHECK(witness.ended == std::set<std::size_t>{0});
}

TEST_CASE("an observer of a sweep is shown the rows of all its runs") {
  const DiagramFolder folder;
  folder.write("sweep.yaml", "stepwire: 1\n" + ramp + "sweep: {k: [1, 2, 3, 4]}\n");
  diagram::Loader loader(library());
  Witness witness;
  RunOptions options;
  options.observers = {&witness};
  options.threads = 2;
  const RunResult result = run_job(make_job(loader, folder.path("sweep.yaml")), options);
  CHECK(witness.begun == std::set<std::size_t>{0, 1, 2, 3});
  for (std::size_t run = 0; run < 4; ++run)
    for (std::size_t k = 0; k < 7; ++k) {
      CHECK(witness.rows[{run, 0}][k][1] == Approx(static_cast<double>((run + 1) * k)));
      CHECK(result.recordings[0].table.find("x")->values[7 * run + k] == witness.rows[{run, 0}][k][1]);
    }
}

TEST_CASE("an observer may keep a moment, set a value, go back, pause and stop") {
  struct Director : RunObserver {
    Flow before_tick(const ObservedRun& run) override {
      Executor& simulation = run.simulation;
      if (simulation.tick() == 2 && kept.values.empty()) kept = simulation.workspace();
      if (simulation.tick() == 4 && !returned) {
        returned = true;
        simulation.restore(kept);
        CHECK(simulation.set("k", "10") == Executor::Setting::done);
      }
      if (simulation.tick() == 3 && returned && !std::exchange(paused, true)) return Flow::pause;
      return simulation.tick() == 5 ? Flow::stop : Flow::go_on;
    }
    Workspace kept;
    bool returned = false, paused = false;
  };
  const plan::Plan plan = plan_text(ramp);
  Executor simulation(plan);
  record::RunRecording recording(plan);
  Drive drive(simulation, recording.recorders());
  Director director;
  RunObserver* const observers[] = {&director};
  drive.observers = observers;
  CHECK(drive.run() == Drive::End::paused);
  CHECK(simulation.tick() == 3);
  CHECK(drive.run() == Drive::End::stopped);
  const std::vector<record::Recording> recordings = recording.take();
  const std::vector<double>& x = recordings[0].table.find("x")->values;
  REQUIRE(x.size() == 5);
  for (std::size_t k = 0; k < 5; ++k) CHECK(x[k] == Approx(std::vector<double>{0, 2, 4, 14, 24}[k]));
}

}  // namespace stepwire::run
