// Units of others that exit or hang, in the program and in a process of their own.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "engine/base/table/table_file.hpp"
#include "tests/engine/app/cli/processes.hpp"
#include "tests/engine/app/cli/program.hpp"
#include "tests/support/units/units.hpp"

using Catch::Contains;

namespace {

/// A call that runs a unit with a misdeed for 1000 ticks.
Call with_unit(const Scratch& folder, const std::string& deed, const std::string& keys) {
  stepwire::testing::write_zip(folder.path("bad.fmu"), stepwire::testing::bad_unit(3, deed));
  folder.file("bad.yaml", fmt::format("stepwire: 1\ntitle: a unit\nstep: 1 ms\nstop: 1 s\nblocks:\n"
                                      "  wheel: {{block: Fmu, file: bad.fmu{}}}\nrecord: [wheel.y]\n",
                                      keys));
  return {{"run", "bad.yaml", "--out", "out"}, {{"STEPWIRE_HELPER_LIMIT", "0.4"}}};
}

}  // namespace

TEST_CASE("a unit that exits or hangs in a process of its own ends the run, whose rows are written") {
  for (const std::string deed : {"_exit", "exit", "hang"}) {
    const Scratch folder;
    const Done done = run_program(folder, with_unit(folder, deed + " DoStep", ""));
    INFO(done.err);
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Contains("wheel") && Contains("its process in fmi3DoStep"));
    CHECK(stepwire::table::read_csv(folder.path("out/signals.csv")).rows() == 250);
    CHECK(processes_in(folder.path("")) == 0);
  }
}

TEST_CASE("a unit in the program that exits or hangs ends it with status 3 and a sentence") {
  for (const std::string deed : {"exit", "quick_exit", "hang"})
    for (const std::string call : {"DoStep", "Instantiate", "FreeInstance"}) {
      const Scratch folder;
      const Done done = run_program(folder, with_unit(folder, deed + " " + call, ", isolate: false"));
      INFO(deed << " " << call << ": " << done.err);
      CHECK(done.code == 3);
      CHECK_THAT(done.err, Contains("wheel: the unit ") && Contains("bad.fmu") && Contains("in fmi3" + call));
      CHECK_THAT(done.err, Contains(deed == "hang" ? "STEPWIRE_HELPER_LIMIT allows more seconds"
                                                   : "ended the program by"));
      CHECK_THAT(done.err, Contains("with isolate: true that ends the run with a message"));
    }
}

TEST_CASE("what an isolated unit prints is no part of a table on the standard output") {
  const Scratch folder;
  Call call = with_unit(folder, "print DoStep", "");
  call.arguments = {"run", "bad.yaml", "--csv", "-"};
  const Done done = run_program(folder, call);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Catch::StartsWith("time [s],wheel.y") && !Contains("printed"));
  CHECK_THAT(done.err, Contains("printed"));
}

TEST_CASE("a unit that leaves the folder of the call does not take the results with it") {
  for (const std::string keys : {"", ", isolate: false"}) {
    const Scratch folder;
    CHECK(run_program(folder, with_unit(folder, "chdir DoStep", keys)).code == 0);
    CHECK(stepwire::table::read_csv(folder.path("out/signals.csv")).rows() == 1001);
  }
}

TEST_CASE("processes that an isolated unit makes end with it") {
  const Scratch folder;
  CHECK(run_program(folder, with_unit(folder, "fork Initialize", "")).code == 0);
  CHECK(processes_in(folder.path("")) == 0);
}

TEST_CASE("an interruption ends a run whose unit hangs, in the program with a sentence, else with its rows",
          "[full]") {
  for (const std::string keys : {"", ", isolate: false"}) {
    const Scratch folder;
    Call call = with_unit(folder, "hang DoStep", keys);
    call.environment.clear();
    call.interrupt_after = 2.0;
    call.signals = {SIGTERM};
    const Done done = run_program(folder, call);
    INFO(keys << ": " << done.err);
    CHECK(done.code == 130);
    CHECK(done.seconds < 30.0);
    CHECK_THAT(done.err, Contains("fmi3DoStep"));
    if (keys.empty()) CHECK(stepwire::table::read_csv(folder.path("out/signals.csv")).rows() == 250);
    CHECK(processes_in(folder.path("")) == 0);
  }
}

TEST_CASE("the process of a unit that hangs ends with a program that is killed") {
  const Scratch folder;
  Call call = with_unit(folder, "hang DoStep", ", isolate: true");
  call.environment.clear();
  call.interrupt_after = 2.0;
  call.signals = {SIGKILL};
  CHECK(run_program(folder, call).code == 128 + SIGKILL);
  CHECK(processes_in(folder.path("")) == 0);
}
