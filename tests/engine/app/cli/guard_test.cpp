// The guard of a loop: whatever ends or stops the loop, the outputs at the rig become the safe values.
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "tests/engine/app/cli/processes.hpp"
#include "tests/engine/app/cli/program.hpp"
#include "tests/support/rig_host.hpp"

namespace {

using Catch::Contains;
using stepwire::Beside;
using stepwire::RigHost;

constexpr double wanted = 0.5, safe = 0.125;  // [A]
constexpr int soon = 100;  // steps of the rig, 10 ms each, with which no machine is too busy

/// Loop at 100 Hz with a rig in this process; its output is 0.5 A at a force of 1 N.
struct Guarded {
  explicit Guarded(const std::string& more = "late: 100 ms\n") : rig(name()) {
    folder.file("a.yaml", R"(stepwire: 1
title: A coil that follows a force
step: 10 ms
stop: 1 s
inputs: {force: {unit: N, default: 1 N}}
outputs: {current: {signal: coil, unit: A, safe: 0.125 A}}
blocks: {coil: {block: Gain, u: force, gain: 0.5 A/N}}
record: [coil]
)");
    folder.file("rig.yaml", "devices: {rig: {driver: shared, stale: 1 s, name: " + name() +
                                "}}\ninputs: {force: {device: rig, channel: force, range: [-4 N, 4 N]}}\n"
                                "outputs: {current: {device: rig, channel: current, limits: [-1 A, 1 A]}}\n" +
                                more);
    begin();
  }

  static std::string name() { return "stepwire-test-" + std::to_string(::getpid()); }
  void begin() {
    loop.emplace(STEPWIRE_PROGRAM,
                 std::vector<std::string>{"loop", "a.yaml", "--io", "rig.yaml", "--rate", "100", "--duration",
                                          "60", "--policy", "other", "--out", "out"},
                 folder.path(""));
  }
  std::string errors() const { return content_of(folder.path(".err")); }

  Scratch folder;
  RigHost rig;
  std::optional<Beside> loop;
};

}  // namespace

TEST_CASE("a guarded loop that is interrupted ends with its safe value, its counts and its files") {
  Guarded one;
  REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
  one.loop->send(SIGINT);
  CHECK(one.rig.steps_until(safe, soon) <= soon);
  CHECK(one.loop->end() == 130);
  CHECK(one.errors().empty());
  CHECK_THAT(content_of(one.folder.path(".out")), Contains("rig: ") && Contains("changes seen"));
  CHECK(processes_in(one.folder.path("")) == 0);
  CHECK(run_program(one.folder, {"verify", "out"}).code == 0);
}

TEST_CASE("a loop that is interrupted while it waits for a first value ends with 130, at its safe value") {
  for (const std::string guard : {"guard: true\n", "guard: false\n"}) {
    Guarded one("wait: 100 s\n" + guard);
    REQUIRE(one.rig.silent_until(safe, 3000) <= 3000);
    one.loop->send(SIGINT);
    CHECK(one.loop->end() == 130);
    CHECK(one.errors().empty());
    CHECK(one.rig.silent_until(safe, 1) <= 1);
  }
}

TEST_CASE("a loop that is killed leaves the safe value at the rig, and no guard") {
  Guarded one;
  REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
  one.loop->send(SIGKILL);
  CHECK(one.rig.steps_until(safe, soon) <= soon);
  CHECK(one.loop->end() == 128 + SIGKILL);
  CHECK(processes_in(one.folder.path("")) == 0);
  CHECK_THAT(one.errors(),
             Contains("the loop has ended without finishing; its guard has set all outputs to their "
                      "safe values"));
}

TEST_CASE("a loop that is killed together with its guard leaves the safe value at the rig") {
  for (const bool guard_first : {true, false}) {
    Guarded one;
    REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
    const int guard = one.loop->child("stepwire_guard");
    REQUIRE(guard > 0);
    if (guard_first) ::kill(guard, SIGKILL);
    one.loop->send(SIGKILL);
    if (!guard_first) ::kill(guard, SIGKILL);
    CHECK(one.rig.steps_until(safe, soon) <= soon);
    CHECK(processes_in(one.folder.path("")) == 0);
  }
}

TEST_CASE("a loop that is stopped together with its guard leaves the safe value at the rig") {
  Guarded one;
  REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
  const int guard = one.loop->child("stepwire_guard");
  REQUIRE(guard > 0);
  ::kill(guard, SIGKILL);
  one.loop->send(SIGSTOP);
  CHECK(one.rig.steps_until(safe, soon) <= soon);
  one.loop->send(SIGKILL);
  CHECK(processes_in(one.folder.path("")) == 0);
}

TEST_CASE("a loop and a guard that are both stopped leave the safe value at the rig, by the keeper") {
  Guarded one("late: 1 s\n");
  REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
  const int guard = one.loop->child("stepwire_guard");
  REQUIRE(guard > 0);
  one.loop->send(SIGSTOP);
  for (int i = 0; i < 5; ++i) one.rig.step(1.0);  // until all of its threads are stopped
  ::kill(guard, SIGSTOP);
  CHECK(one.rig.steps_until(safe, 3 * soon) <= 3 * soon);
  for (int i = 0; i < 20; ++i) CHECK(one.rig.step(1.0) == safe);
  CHECK_THAT(one.errors(), Contains("the guard was ended since it did not run for") &&
                               Contains("a third process has set all outputs to their safe values"));
  one.loop->send(SIGCONT);
  CHECK(one.loop->end() == 3);
  CHECK(processes_in(one.folder.path("")) == 0);
}

TEST_CASE("a guard that is stopped with its loop for less than its limit goes on") {
  Guarded one("late: 20 s\n");
  REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
  const int guard = one.loop->child("stepwire_guard");
  REQUIRE(guard > 0);
  one.loop->send(SIGSTOP);
  for (int i = 0; i < 5; ++i) one.rig.step(1.0);  // until all of its threads are stopped
  ::kill(guard, SIGSTOP);
  for (int i = 0; i < 30; ++i) CHECK(one.rig.step(1.0) == wanted);
  ::kill(guard, SIGCONT);
  one.loop->send(SIGCONT);
  for (int i = 0; i < 30; ++i) CHECK(one.rig.step(1.0) == wanted);
  one.loop->send(SIGINT);
  CHECK(one.loop->end() == 130);
  CHECK(one.errors().empty());
}

TEST_CASE("a loop that only writes ends once the host of its memory has ended") {
  Guarded one("late: 100 ms\n");
  one.folder.file("rig.yaml", "devices: {rig: {driver: shared, name: " + Guarded::name() +
                                  "}}\noutputs: {current: {device: rig, channel: current, limits: [-1 A, 1 "
                                  "A]}}\nlate: 100 ms\n");
  one.loop->send(SIGKILL);
  one.loop->end();
  REQUIRE(processes_in(one.folder.path("")) == 0);  // its guard has the memory until then
  one.begin();
  REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
  one.rig.leave();
  CHECK(one.loop->end() == 3);
  CHECK_THAT(one.errors(), Contains("the device rig does not answer"));
}

TEST_CASE("a loop that is stopped is late, and gets its outputs back only by a new start") {
  Guarded one;
  REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
  one.loop->send(SIGSTOP);
  CHECK(one.rig.steps_until(safe, soon) <= soon);
  one.loop->send(SIGCONT);
  CHECK(one.loop->end() == 3);
  CHECK_THAT(one.errors(), Contains("the loop has written nothing for"));
  for (int i = 0; i < 20; ++i) CHECK(one.rig.step(1.0) == safe);
  one.begin();
  CHECK(one.rig.steps_until(wanted, 3000) <= 3000);
}

TEST_CASE("a loop whose guard is killed or stopped sets the safe value itself, and ends") {
  for (const int signal : {SIGKILL, SIGSTOP}) {
    Guarded one;
    REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
    const int guard = one.loop->child("stepwire_guard");
    REQUIRE(guard > 0);
    ::kill(guard, signal);
    CHECK(one.rig.steps_until(safe, soon) <= soon);
    CHECK(one.loop->end() == 3);
    CHECK_THAT(one.errors(), Contains(signal == SIGKILL ? "the guard was ended by signal 9"
                                                        : "the guard was stopped by signal 19") &&
                                 Contains("the outputs are at their safe values"));
    CHECK(processes_in(one.folder.path("")) == 0);
  }
}

TEST_CASE("a loop whose keeper is killed or stopped ends with its safe value and the reason") {
  for (const int signal : {SIGKILL, SIGSTOP}) {
    Guarded one;
    REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
    const int keeper = one.loop->child("stepwire_keeper", one.loop->child("stepwire_guard"));
    REQUIRE(keeper > 0);
    ::kill(keeper, signal);
    CHECK(one.rig.steps_until(safe, soon) <= soon);
    CHECK(one.loop->end() == 3);
    CHECK_THAT(one.errors(), Contains("the process stepwire_keeper has ended or is stopped"));
    for (int i = 0; i < 20; ++i) CHECK(one.rig.step(1.0) == safe);
    ::kill(keeper, SIGCONT);
    CHECK(processes_in(one.folder.path("")) == 0);
  }
}

TEST_CASE("rows of a loop are kept where it or its guard is killed, and the next loop removes them") {
  Guarded one;
  const auto rows = [&] { return lines_of(content_of(one.folder.path("out/signals.csv"))).size(); };
  REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
  for (int step = 0; step < 1000 && rows() < 20; ++step) one.rig.step(1.0);
  one.loop->send(SIGKILL);
  CHECK(one.loop->end() == 128 + SIGKILL);
  REQUIRE(processes_in(one.folder.path("")) == 0);
  CHECK(rows() >= 20);
  CHECK(content_of(one.folder.path("out/signals.csv")).ends_with("\n"));
  one.begin();
  for (int step = 0; step < 1000 && one.rig.step(1.0) != wanted; ++step) {
  }
  for (int step = 0; step < 50; ++step) one.rig.step(1.0);
  ::kill(one.loop->child("stepwire_guard"), SIGKILL);
  CHECK(one.loop->end() == 3);
  CHECK(rows() >= 20);
  CHECK(std::filesystem::exists(one.folder.path("out/loop.json")));
  CHECK(run_program(one.folder, {"verify", "out"}).code == 0);
}

TEST_CASE("a force out of its range trips the guard, which the loop reports") {
  Guarded one;
  REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
  int steps = 0;
  while (one.rig.step(5.0) != safe && steps < soon) ++steps;
  CHECK(steps < soon);
  CHECK(one.loop->end() == 3);
  CHECK_THAT(one.errors(), Contains("input inputs.force (rig.yaml:2, channel rig.force) is 5 N; its range is -4 to 4 N"));
}

TEST_CASE("a rig that offers nothing new ends the loop") {
  Guarded one;
  REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
  CHECK(one.loop->end() == 3);  // the rig does no step meanwhile
  CHECK_THAT(one.errors(), Contains("the device rig has no new values"));
  CHECK(one.rig.step(1.0) == safe);
}

TEST_CASE("a guarded loop rests while the program of its baseline runs, much longer than it may be late") {
  Guarded one;
  REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
  one.loop->send(SIGINT);
  CHECK(one.loop->end() == 130);
  one.folder.file("cyclictest", "#!/bin/sh\nsleep 1\necho '000007 000006'\n");
  std::filesystem::permissions(one.folder.path("cyclictest"), std::filesystem::perms::owner_all);
  const std::string path = one.folder.path("") + ":" + std::getenv("PATH");
  stepwire::Beside loop("/usr/bin/env",
                        {"PATH=" + path, STEPWIRE_PROGRAM, "loop", "a.yaml", "--io", "rig.yaml", "--rate",
                         "100", "--duration", "2", "--policy", "other", "--baseline"},
                        one.folder.path(""));
  for (int slice = 0; slice < 2; ++slice) {
    REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
    CHECK(one.rig.steps_until(safe, 3000) <= 3000);
  }
  CHECK(loop.end() == 0);
  CHECK(one.errors().empty());
}

TEST_CASE("a guard that cannot start says why, and nothing moves") {
  Guarded one;
  REQUIRE(one.rig.steps_until(wanted, 3000) <= 3000);
  one.folder.file("b.yaml", "devices: {rig: {driver: shared, name: stepwire-none}}\n");
  const Done done = run_program(one.folder, {"loop", "a.yaml", "--io", "b.yaml", "--rate", "100"});
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Contains("driver shared: there is no shared memory /stepwire-none; its host"));
}
