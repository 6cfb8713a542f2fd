#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <thread>

#include "engine/base/table/table_file.hpp"
#include "engine/simulate/realtime/loop_recorder.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/engine/simulate/realtime/fakes.hpp"

namespace stepwire::realtime {

namespace {

const std::string two_rates_yaml = R"(step: 1 ms
inputs: {force: {unit: N, default: [1 N, 2 N]}}
blocks:
  wave: {block: Sine, frequency: 10 Hz}
  push: {block: Saturation, lower: -9 N, upper: 9 N, u: force}
record:
  - wave
  - {every: 5 ms, signals: [push]}
)";

}  // namespace

TEST_CASE("rows come out of the ring as they went in, from one thread to another") {
  RowRing ring(64);
  std::thread giver([&] {
    for (double k = 0; k < 20'000; ++k)
      for (const double row[3] = {k, 2 * k, 3 * k}; !ring.push(row, 3);) std::this_thread::yield();
  });
  bool same = true;
  double numbers[3];
  for (double k = 0; k < 20'000; ++k) {
    for (std::size_t got = 0; got < 3; got += ring.pop(numbers + got, 3 - got)) std::this_thread::yield();
    same = same && numbers[0] == k && numbers[1] == 2 * k && numbers[2] == 3 * k;
  }
  giver.join();
  CHECK(same);
}

TEST_CASE("a row for which the ring has no room is left out whole") {
  RowRing ring(8);
  const double row[3] = {1, 2, 3};
  CHECK(ring.push(row, 3));
  CHECK(ring.push(row, 3));
  CHECK_FALSE(ring.push(row, 3));
  double numbers[8];
  CHECK(ring.pop(numbers, 3) == 3);
  CHECK(ring.push(row, 3));
  CHECK(ring.pop(numbers, 8) == 6);
}

TEST_CASE("a writer that is stuck loses rows, which are counted, and does not hold the loop") {
  LoopRig rig(counting_yaml, options_of(100), 5 * 10);
  rig.loop.serve(100);
  CHECK(rig.loop.end() == Loop::End::done);
  CHECK(rig.loop.deadlines().missed() == 0);
  CHECK(rig.recorder.rows() == 10);
  CHECK(rig.recorder.lost() == 90);
  CHECK(rig.rows(5).back()[2] == 9);
}

TEST_CASE("after a jam the rows go on with the tick that is then") {
  LoopRig rig(counting_yaml, options_of(30), 5 * 10);
  rig.clock.at_sleep = [&](std::int64_t sleeps) {
    if (sleeps == 21) rig.rows(5);
  };
  rig.loop.serve(30);
  CHECK(rig.recorder.lost() == 10);
  const auto rows = rig.rows(5);
  CHECK(rows.front()[2] == 20);
  CHECK(rows.back()[2] == 29);
}

TEST_CASE("the files have time, tick and wall, and the signals as a run names them") {
  const plan::Plan plan = plan_text(two_rates_yaml);
  const auto files = loop_files(plan);
  REQUIRE(files.size() == 3);
  CHECK(files[0].name == "signals.csv");
  CHECK(files[1].name == "signals-2.csv");
  CHECK(files[2].name == "inputs.csv");
  std::string heads;
  for (const LoopFile& file : files) table::append_csv_head(heads, file.columns);
  CHECK(heads ==
        "time [s],tick,wall [s],wave\n"
        "time [s],tick,wall [s],push.1 [N],push.2 [N]\n"
        "time [s],tick,force.1 [N],force.2 [N]\n");
}

TEST_CASE("what a loop records is what a run records, to the last bit") {
  const Scratch scratch;
  LoopRig rig(two_rates_yaml, options_of(2000));
  RowWriter writer(rig.ring, scratch.path("out"), loop_files(rig.plan));
  rig.loop.serve(2000);
  writer.finish();
  CHECK(writer.rows() == rig.recorder.rows());
  CHECK(writer.lost() + rig.recorder.lost() == 0);
  const run::RunResult run = run::run_plan(plan_text(two_rates_yaml + "stop: 1.999 s\n"));
  for (const std::size_t file : {0u, 1u}) {
    const table::Table loop =
        table::read_csv(scratch.path(file == 0 ? "out/signals.csv" : "out/signals-2.csv"));
    for (table::Column column : run.recordings[file].table.columns) {
      column.values.resize(loop.rows());  // a run records its last tick, too, where the period skips it
      CHECK(loop.find(column.name)->values == column.values);
    }
  }
  const table::Table inputs = table::read_csv(scratch.path("out/inputs.csv"));
  CHECK(inputs.rows() == 2000);
  CHECK(inputs.find("tick")->values.back() == 1999);
  CHECK(inputs.find("force.2")->values.back() == 2.0);
}

TEST_CASE("ticks are written in all digits") {
  const Scratch scratch;
  RowRing ring(64);
  RowWriter writer(ring, scratch.path("out"), {{"a.csv", {{"time", "s", {}}, {"tick", "", {}}}}});
  const double row[3] = {0, 100.0, 100'000};
  CHECK(ring.push(row, 3));
  writer.finish();
  CHECK(io::read_file(scratch.path("out/a.csv")) == "time [s],tick\n100,100000\n");
}

TEST_CASE("a disk that fills up loses rows, which are counted, and the files keep whole rows") {
  const Scratch scratch;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 200'000;
  LoopRig rig(counting_yaml, options_of(20'000), 1 << 20);
  RowWriter writer(rig.ring, scratch.path("out"), loop_files(rig.plan));
  setrlimit(RLIMIT_FSIZE, &small);
  rig.loop.serve(20'000);
  writer.finish();
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK(rig.recorder.lost() == 0);
  CHECK(writer.lost() > 0);
  CHECK(writer.rows() + writer.lost() == 20'000);
  CHECK(writer.trouble() == scratch.path("out/signals.csv") + ": File too large");
  const table::Table table = table::read_csv(scratch.path("out/signals.csv"));
  CHECK(static_cast<std::int64_t>(table.rows()) == writer.rows());
}

TEST_CASE("a signal with the name of a column of the loop is refused") {
  const plan::Plan plan = plan_text("blocks:\n  tick: {block: Constant, value: 1}\nrecord: [tick]\n");
  CHECK_THROWS_WITH(loop_files(plan),
                    "test.yaml:3:10: tick: is also the name of a column that a loop records; give the block "
                    "another name");
}

}  // namespace stepwire::realtime
