// Drivers that fail, crash, end their process or do not return, behind the program.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>

#include "tests/engine/app/cli/processes.hpp"
#include "tests/engine/app/cli/program.hpp"
#include "tests/support/evdev/fake_input.hpp"
#include "tests/support/rig_host.hpp"

namespace {

using Catch::Contains;
using stepwire::Beside;
using stepwire::RigHost;

/// Diagram with one output of 0.5 A, safe at 0.125 A, behind the driver `broken` with settings.
struct BehindBroken {
  explicit BehindBroken(const std::string& settings, const std::string& more = "late: 1 s\n") {
    ::setenv("STEPWIRE_DRIVERS", FAKE_DRIVERS, 1);
    folder.file("a.yaml", R"(stepwire: 1
title: A coil
step: 10 ms
stop: 1 s
outputs: {current: {signal: coil, unit: A, safe: 0.125 A}}
blocks: {coil: {block: Constant, value: 0.5 A}}
record: [coil]
)");
    folder.file("rig.yaml",
                "devices: {bad: {driver: broken, file: written, " + settings +
                    "}}\noutputs: {current: {device: bad, channel: value, limits: [-1 A, 1 A]}}\n" + more);
  }
  ~BehindBroken() { ::unsetenv("STEPWIRE_DRIVERS"); }

  void begin(const std::string& duration = "60", const std::string& rate = "100") {
    loop.emplace(STEPWIRE_PROGRAM,
                 std::vector<std::string>{"loop", "a.yaml", "--io", "rig.yaml", "--rate", rate, "--duration",
                                          duration, "--policy", "other", "--out", "out"},
                 folder.path(""));
  }
  std::string errors() const { return content_of(folder.path(".err")); }
  std::vector<std::string> written() const { return lines_of(content_of(folder.path("written"))); }
  /// Waits until the device has got a line.
  bool gets(const std::string& line) const {
    for (int look = 0; look < 4000; ++look) {
      const auto lines = written();
      if (std::ranges::find(lines, line) != lines.end()) return true;
      ::usleep(5000);
    }
    return false;
  }

  Scratch folder;
  std::optional<Beside> loop;
};

}  // namespace

TEST_CASE("a driver that crashes or ends its process in open ends loop and io with 3 and a sentence") {
  for (const std::string guard : {"true", "false"})
    for (const auto& [how, text] : {std::pair{"crash", "was ended by signal 11 (Segmentation fault)"},
                                    {"exit", "has ended its process with exit code 0"}}) {
      const BehindBroken one(std::string("fails: open, how: ") + how, "guard: " + guard + "\n");
      for (const std::vector<std::string>& call :
           {std::vector<std::string>{"loop", "a.yaml", "--io", "rig.yaml", "--rate", "100"},
            {"io", "rig.yaml", "--duration", "0.1"}}) {
        const Done done = run_program(one.folder, call);
        CHECK(done.code == 3);
        CHECK_THAT(done.err,
                   Contains(std::string("bad: the driver broken ") + text + " in open or channels"));
      }
    }
}

TEST_CASE("a driver that does not return from open is left by an interruption") {
  for (const std::string guard : {"true", "false"}) {
    BehindBroken one("fails: open, how: hang", "guard: " + guard + "\n");
    one.begin();
    CHECK(one.loop->child("stepwire_guard") > 0);
    while (content_of(one.folder.path("written")).empty() &&
           ::access(one.folder.path("written").c_str(), 0) != 0)
      ::usleep(1000);
    one.loop->send(SIGINT);
    CHECK(one.loop->end() == 130);
    CHECK(processes_in(one.folder.path("")) == 0);
  }
}

TEST_CASE("a driver that crashes does not hide the others in the list") {
  const BehindBroken one("fails: open");
  for (const std::string what : {"load", "list"}) {
    Call call;
    call.arguments = {"devices"};
    call.environment["BROKEN_DRIVER"] = what;
    const Done done = run_program(one.folder, call);
    CHECK(done.code == 3);
    CHECK_THAT(done.out, Contains("file: plays a record") && Contains("shared: shared memory"));
    CHECK_THAT(done.err,
               Contains("the driver broken") && Contains(what == "load" ? "while it was loaded" : "in list"));
  }
}

TEST_CASE("a driver that does not return from stop is told, and leaves safe outputs and no process") {
  BehindBroken one("fails: stop, how: hang");
  one.begin("0.2");
  CHECK(one.loop->end() == 3);
  CHECK(one.written().back() == "safe 0.125");
  CHECK_THAT(one.errors(),
             Contains("the guard was killed since a driver of bad has not returned within 2 s") &&
                 Contains("the outputs are at their safe values"));
  CHECK(processes_in(one.folder.path("")) == 0);
}

TEST_CASE("a driver that does not return from safe is told by loop and keeper, which both end") {
  BehindBroken one("fails: safe, how: hang, when: now");
  one.begin();
  REQUIRE(one.gets("write 0.5"));
  one.folder.file("now", "");
  one.loop->send(SIGINT);
  CHECK(one.loop->end() == 130);
  CHECK(processes_in(one.folder.path("")) == 0);
  CHECK_THAT(one.errors(),
             Contains("the guard was killed since a driver of bad has not returned within 2 s") &&
                 Contains("the outputs may not be at their safe values") &&
                 Contains("the driver of bad does not return from safe"));
}

TEST_CASE("a driver that does not return from safe in place of a killed guard does not keep the loop",
          "[full]") {
  BehindBroken one("fails: safe, how: hang, when: now");
  one.begin("60", "10");
  REQUIRE(one.gets("write 0.5"));
  const int guard = one.loop->child("stepwire_guard");
  REQUIRE(guard > 0);
  one.folder.file("now", "");
  ::kill(guard, SIGKILL);
  CHECK(one.loop->end() == 3);
  CHECK_THAT(one.errors(), Contains("the guard was ended by signal 9") &&
                               Contains("a driver there does not return, and the outputs may not be"));
  for (int look = 0; look < 5 && processes_in(one.folder.path("")) > 0; ++look) {
  }
  CHECK(processes_in(one.folder.path("")) == 0);
}

// The guard is killed, the loop opens the device in its place and is stopped in a start of half a second.
TEST_CASE("a loop that is stopped while it has a device is ended by the keeper, and the safe value stays") {
  BehindBroken one("slow: 500 ms", "late: 5 s\n");
  one.begin("60", "10");
  REQUIRE(one.gets("write 0.5"));
  const int guard = one.loop->child("stepwire_guard");
  REQUIRE(guard > 0);
  ::kill(guard, SIGKILL);
  REQUIRE(one.gets("open " + std::to_string(one.loop->process())));
  one.loop->send(SIGSTOP);
  CHECK(one.loop->end() == 128 + SIGKILL);
  CHECK(processes_in(one.folder.path("")) == 0);
  CHECK(one.written().back() == "safe 0.125");
  CHECK_THAT(one.errors(), Contains("a third process has set all outputs to their safe values"));
}

TEST_CASE(
    "the button of a gamepad behind a guard lets outputs follow while it is down, and its release is final") {
  ::setenv("STEPWIRE_DRIVERS", FAKE_DRIVERS, 1);
  const Scratch folder;
  const FakePadFile pad(folder.path("events"));
  const std::string name = "stepwire-test-pad-" + std::to_string(::getpid());
  RigHost rig(name);
  folder.file("a.yaml", R"(stepwire: 1
title: A coil
step: 10 ms
stop: 1 s
outputs: {current: {signal: coil, unit: A, safe: 0.125 A}}
blocks: {coil: {block: Constant, value: 0.5 A}}
record: [coil]
)");
  folder.file("rig.yaml", "devices: {pad: {driver: fake_gamepad}, rig: {driver: shared, name: " + name +
                              "}}\noutputs: {current: {device: rig, channel: current, limits: [-1 A, 1 A]}}\n"
                              "dead_man: {device: pad, channel: tl}\nlate: 1 s\n");
  Beside loop(
      STEPWIRE_PROGRAM,
      {"loop", "a.yaml", "--io", "rig.yaml", "--rate", "100", "--duration", "60", "--policy", "other"},
      folder.path(""));
  REQUIRE(rig.steps_until(0.125, 3000) <= 3000);
  for (int step = 0; step < 50; ++step) CHECK(rig.step(1.0) == 0.125);
  pad.send(EV_KEY, BTN_TL, 1);
  CHECK(rig.steps_until(0.5, 300) <= 300);
  pad.send(EV_KEY, BTN_TL, 0);
  CHECK(rig.steps_until(0.125, 100) <= 100);
  pad.send(EV_KEY, BTN_TL, 1);
  for (int step = 0; step < 20; ++step) CHECK(rig.step(1.0) == 0.125);
  CHECK(loop.end() == 3);
  CHECK_THAT(content_of(folder.path(".err")), Contains("the dead-man input pad.tl was released"));
  ::unsetenv("STEPWIRE_DRIVERS");
}
