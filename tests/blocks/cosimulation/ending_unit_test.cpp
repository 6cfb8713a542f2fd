// Units that terminate the simulation: such a run ends as by `stop_when`.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"
#include "tests/support/units/units.hpp"

using namespace stepwire;

namespace {

/// A unit that terminates the simulation in a call, beside a block that reads it. It counts 100 more from its
/// end on, and each call but for values is an error then.
struct Ending {
  int version;
  std::string call, interface, head, deed = "end";

  run::RunResult result(const std::string& isolate) const {
    const Scratch scratch;
    const std::string path =
        testing::write_zip(scratch.path("end.fmu"), testing::bad_unit(version, deed + " " + call));
    return result_of(fmt::format(R"({}
blocks:
  unit: {{block: Fmu, file: {}, interface: {}, isolate: {}}}
  twice: {{block: Gain, u: unit.y, gain: 2}}
  x: {{block: Integrator, u: 1 1/s}}
record: [unit.y, twice, x]
)",
                                 head, path, interface, isolate));
  }

  /// The run ends at a time, whole, and its last row shows what the unit has at its end.
  void check(double time) const {
    for (const std::string isolate : {"true", "false"}) {
      INFO("FMI " << version << ", " << interface << ", " << call << ", " << head
                  << ", isolate: " << isolate);
      const run::RunResult run = result(isolate);
      CHECK(run.faults.empty());
      REQUIRE(run.diagnostics.size() == 1);
      CHECK(run.diagnostics[0].block == "unit");
      CHECK(run.diagnostics[0].text == "the unit has ended the run");
      CHECK(run.diagnostics[0].time == Approx(time));
      check_rows(run.recordings.front().table, time);
    }
  }
  static void check_rows(const table::Table& table, double time) {
    const std::vector<double>& times = column(table, "time");
    for (std::size_t row = 1; row < times.size(); ++row) CHECK(times[row] > times[row - 1]);
    CHECK(times.back() == Approx(time));
    CHECK(column(table, "unit.y").back() == Approx(time + 100.0));
    CHECK(column(table, "twice").back() == Approx(2.0 * (time + 100.0)));
    CHECK(column(table, "x").back() == Approx(time).margin(1e-12));
    if (times.size() > 1) CHECK(column(table, "unit.y")[times.size() - 2] < 1.0);
  }
};

}  // namespace

TEST_CASE("co-simulation that ends with a step ends the run behind it, whatever the version of FMI") {
  for (const int version : {2, 3})
    Ending{version, "DoStep", "co_simulation", "step: 10 ms\nstop: 1 s\nsolver: rk4"}.check(0.25);
}

TEST_CASE("co-simulation that ends within a step has its last row at the time of the end") {
  for (const int version : {2, 3})
    for (const std::string events :
         {"", "\nevents: locate\nstop_when: x > 5", "\nsolver: {name: dormand_prince, relative: 1e-6}"}) {
      const std::string solver = events.find("solver") == std::string::npos ? "\nsolver: rk4" : "";
      Ending{version, "DoStep", "co_simulation", "step: 70 ms\nstop: 0.98 s" + solver + events, "early"}
          .check(0.25);
    }
}

TEST_CASE("model exchange that ends in an event at a tick ends the run there") {
  for (const int version : {2, 3})
    for (const std::string events : {"", "\nevents: locate"})
      Ending{version, "Update", "model_exchange", "step: 0.1 s\nstop: 1 s\nsolver: rk4" + events}.check(0.3);
}

TEST_CASE("model exchange that ends in an event between ticks ends the run at the event that is located") {
  for (const int version : {2, 3})
    Ending{version, "Update", "model_exchange", "step: 70 ms\nstop: 0.98 s\nsolver: rk4\nevents: locate"}
        .check(0.3);
}

TEST_CASE("model exchange that ends as a step is completed ends the run there") {
  for (const int version : {2, 3})
    for (const std::string events : {"", "\nevents: locate"})
      Ending{version, "CompletedStep", "model_exchange", "step: 50 ms\nstop: 1 s\nsolver: rk4" + events}
          .check(0.25);
}

TEST_CASE("a unit that ends as it is initialized leaves the first row") {
  for (const int version : {2, 3})
    Ending{version, "Start", "model_exchange", "step: 50 ms\nstop: 1 s\nsolver: rk4"}.check(0.0);
}

TEST_CASE("a period of rows that the end is not one of has the row of the end as its last one") {
  const Scratch scratch;
  const std::string path = testing::write_zip(scratch.path("end.fmu"), testing::bad_unit(3, "end Update"));
  const table::Table table = run_text(fmt::format(R"(step: 0.1 s
stop: 1 s
solver: rk4
blocks:
  unit: {{block: Fmu, file: {}, interface: model_exchange}}
record: {{every: 0.2 s, signals: [unit.y]}}
)",
                                                  path));
  CHECK(column(table, "time").size() == 3);
  CHECK(column(table, "time").back() == Approx(0.3));
  CHECK(column(table, "unit.y").back() == Approx(100.3));
}
