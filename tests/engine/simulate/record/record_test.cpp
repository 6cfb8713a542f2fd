#include <catch2/catch.hpp>

#include "engine/simulate/record/recorder.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::record {

TEST_CASE("record takes several periods, states, vectors and all, each signal once") {
  const run::RunResult result = result_of(R"(blocks:
  v: {block: Constant, value: [1, 2]}
  x: {block: Integrator, u: v}
solver: rk4
step: 0.5 s
record:
  - v
  - {every: 1 s, signals: [x, x.x]}
  - v
  - {every: 1.5 s, signals: all}
)");
  REQUIRE(result.recordings.size() == 3);
  const auto names = [&](std::size_t recording) {
    std::vector<std::string> list;
    for (const table::Column& column : result.recordings[recording].table.columns)
      list.push_back(column.name);
    return list;
  };
  CHECK(names(0) == std::vector<std::string>{"time", "v.1", "v.2"});
  CHECK(names(1) == std::vector<std::string>{"time", "x.1", "x.2", "x.x.1", "x.x.2"});
  CHECK(names(2) == std::vector<std::string>{"time", "v.1", "v.2", "x.1", "x.2"});
  CHECK(column(result.recordings[0].table, "time").size() == 7);
  CHECK(column(result.recordings[1].table, "time") == std::vector<double>{0, 1, 2, 3});
  CHECK(column(result.recordings[2].table, "time") == std::vector<double>{0, 1.5, 3});
  CHECK(column(result.recordings[1].table, "x.2").back() == Approx(6.0));
}

TEST_CASE("a recording that no memory holds is refused before the run") {
  const DiagramFolder folder;
  folder.write("long.yaml",
               "stepwire: 1\nstep: 1 ns\nstop: 1000 s\nblocks:\n  c: {block: Clock}\nrecord: c\n");
  diagram::Loader loader(library());
  REQUIRE_THROWS_WITH(run::make_job(loader, folder.path("long.yaml")),
                      Catch::Contains("long.yaml:6:9: record") && Catch::Contains("GB"));
}

TEST_CASE("a run of very many rows begins with few of them, and what it has recorded stays in its place") {
  const plan::Plan plan = plan_text("blocks:\n  t: {block: Clock}\nstep: 1 s\nstop: 10000000 s\nrecord: t\n");
  RunRecording recording(plan);
  Recorder& recorder = recording.recorders().front();
  std::vector<double> values(plan.layout.size, 0.0);
  const std::int64_t count = 2 * Recorder::rows_at_once + 3;
  for (std::int64_t tick = 0; tick < count; ++tick) {
    values.assign(values.size(), static_cast<double>(tick));
    recorder.record(tick, values.data());
  }
  const auto& columns = recording.finished().front().table;
  REQUIRE(column(columns, "t").size() == static_cast<std::size_t>(count));
  for (std::size_t row = 0; row < column(columns, "t").size(); row += 1001)
    REQUIRE(column(columns, "t")[row] == static_cast<double>(row));
  recording.restart();
  recorder.record(0, values.data());
  CHECK(column(recording.take().front().table, "t").size() == 1);
}

TEST_CASE("a recorder that goes back replaces what it kept from there on") {
  const plan::Plan plan =
      plan_text("blocks:\n  t: {block: Clock}\nstop: 9 s\nrecord: {every: 2 s, signals: t}\n");
  RunRecording recording(plan);
  Recorder& recorder = recording.recorders().front();
  std::vector<double> values(plan.layout.size, 1.0);
  for (std::int64_t tick = 0; tick <= 9; ++tick) recorder.record(tick, values.data());
  recorder.go_back_to(3);
  values.assign(values.size(), 2.0);
  for (std::int64_t tick = 3; tick <= 7; ++tick) recorder.record(tick, values.data());
  CHECK(column(recording.take().front().table, "t") ==
        std::vector<double>{1, 1, 2, 2});  // at 0, 2, 4 and 6 s
}

}  // namespace stepwire::record
