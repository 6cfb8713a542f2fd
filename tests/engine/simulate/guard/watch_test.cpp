// Every fault of a loop or a rig leads to the safe values, at an instant that follows from the limits alone.
#include "engine/simulate/guard/watch.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include "engine/simulate/guard/running_guard.hpp"
#include "tests/support/rig_host.hpp"

namespace stepwire::guard {
namespace {

using Catch::Contains;
using Cause = Watch::Cause;

constexpr std::int64_t ms = 1'000'000;

/// One output from -1 to 1 with 20 in a second at most, safe at 0.25; inputs force and speed.
WatchLimits limits() {
  WatchLimits of;
  of.period = 10 * ms;
  of.late = 20 * ms;
  of.outputs = {{"coil", 0.25, -1.0, 1.0, 20.0}};
  of.inputs = {{"force", -50.0, 50.0, 1000.0}, {"speed"}};
  return of;
}

struct Fed {
  explicit Fed(const WatchLimits& of = limits()) : watch(of) {}

  /// One period later: the inputs, then the command.
  void step(double command, double force = 1.0, double speed = 0.0) {
    now += 10 * ms;
    const double inputs[] = {force, speed};
    watch.sensed(now, inputs);
    watch.commanded(now, &command);
  }
  double coil() const { return watch.outputs()[0]; }

  Watch watch;
  std::int64_t now = 0;
};

}  // namespace

TEST_CASE("commands within their limits pass to the bit") {
  Fed fed;
  CHECK(fed.coil() == 0.25);
  for (const double command : {0.3, 0.1 + 0.2, 0.15, -0.04}) {
    fed.step(command);
    CHECK(fed.coil() == command);
  }
}

TEST_CASE("each fault of a command or an input trips at its own step, with the safe value and its name") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const struct {
    std::function<void(Fed&)> fault;
    Cause cause;
    const char* text;
  } rows[] = {
      {[&](Fed& fed) { fed.step(nan); }, Cause::not_finite, "output coil was to become nan"},
      {[&](Fed& fed) { fed.step(-inf); }, Cause::not_finite, "output coil was to become -inf"},
      {[](Fed& fed) { fed.step(1.001); }, Cause::beyond,
       "output coil was to become 1.001; its limits are -1 and 1"},
      {[](Fed& fed) { fed.step(0.601); }, Cause::too_fast,
       "output coil was to become 0.601 from 0.4; its rate allows a change of 0.2"},
      {[&](Fed& fed) { fed.step(0.4, nan); }, Cause::input_bad, "input force became nan"},
      {[](Fed& fed) { fed.step(0.4, 50.1); }, Cause::input_range,
       "input force is 50.1; its range is -50 to 50"},
      {[](Fed& fed) { fed.step(0.4, 11.1); }, Cause::input_jump, "input force jumped to 11.1 from"},
  };
  for (const auto& row : rows) {
    Fed fed;
    fed.step(0.3);
    fed.step(0.4);
    REQUIRE(fed.coil() == 0.4);
    row.fault(fed);
    CHECK(fed.coil() == 0.25);
    CHECK(fed.watch.cause() == row.cause);
    CHECK_THAT(fed.watch.text(), Contains(row.text));
    fed.step(0.4);  // it is latched
    CHECK(fed.coil() == 0.25);
    CHECK(fed.watch.cause() == row.cause);
  }
}

TEST_CASE("a loop that is silent for two periods trips the watch, and one that is not yet late does not") {
  Fed fed;
  fed.watch.waited(1'000 * ms);  // before the first command nothing is late
  fed.step(0.4);
  CHECK(fed.watch.next_check() == fed.now + 20 * ms);
  fed.watch.waited(fed.now + 20 * ms);
  CHECK(fed.coil() == 0.4);
  fed.watch.waited(fed.now + 20 * ms + 1);
  CHECK(fed.coil() == 0.25);
  CHECK(fed.watch.cause() == Cause::late);
  CHECK_THAT(fed.watch.text(), Contains("nothing for 20 ms; it may for 20 ms"));
}

TEST_CASE("a guard whose keeper has ended trips for good") {
  Fed fed;
  fed.step(0.4);
  fed.watch.lost_keeper();
  fed.step(0.4);
  CHECK(fed.coil() == 0.25);
  CHECK_THAT(fed.watch.text(), Contains("the process stepwire_keeper has ended or is stopped"));
}

TEST_CASE("a late command may have moved as far as its rate allows in the time that passed") {
  Fed fed;
  fed.step(0.25);
  fed.now += 10 * ms;  // a step was dropped
  fed.step(0.25 + 0.39);
  CHECK_FALSE(fed.watch.tripped());
}

TEST_CASE("a sensor that does not change for its time is stuck") {
  WatchLimits of = limits();
  of.inputs[0].stuck = 30 * ms;
  Fed fed(of);
  for (int i = 0; i < 4; ++i) fed.step(0.3, 1.0);
  CHECK_FALSE(fed.watch.tripped());
  fed.step(0.3, 1.0);
  CHECK(fed.watch.cause() == Cause::input_stuck);
  Fed moves(of);
  for (int i = 0; i < 20; ++i) moves.step(0.3, 1.0 + 0.001 * i);
  CHECK_FALSE(moves.watch.tripped());
}

TEST_CASE("outputs follow the loop only while the dead-man input is held, and its release is final") {
  WatchLimits of = limits();
  of.dead_man = DeadMan{1, 0.5};
  Fed fed(of);
  fed.step(0.3);
  CHECK(fed.coil() == 0.25);
  fed.step(0.3, 1.0, 1.0);
  CHECK(fed.coil() == 0.3);
  fed.step(0.3, 1.0, 0.5);
  CHECK(fed.coil() == 0.25);
  CHECK(fed.watch.cause() == Cause::released);
}

TEST_CASE("a hand that closes lets the output leave its safe value no faster than its rate") {
  WatchLimits of = limits();
  of.dead_man = DeadMan{1, 0.5};
  Fed fed(of);
  for (int i = 0; i < 5; ++i) fed.step(0.25 + 0.15 * i);
  CHECK(fed.coil() == 0.25);
  fed.step(0.85, 1.0, 1.0);
  CHECK(fed.coil() == Approx(0.45));
  fed.step(0.85, 1.0, 1.0);
  CHECK(fed.coil() == Approx(0.65));
}

TEST_CASE("the ramp leads from the safe value to the commands in a straight line") {
  WatchLimits of = limits();
  of.ramp = 40 * ms;
  Fed fed(of);
  for (int i = 0; i <= 5; ++i) {
    fed.step(0.45);
    CHECK(fed.coil() == Approx(0.25 + 0.2 * std::min(1.0, i / 4.0)));
  }
}

TEST_CASE("energy is the integral of force and speed over a window of a second, in either direction") {
  WatchLimits of = limits();
  of.powers = {{"arm", {0}, {1}, false, 2.0}};
  for (const double sign : {1.0, -1.0}) {
    // A power of 5 W gives 0.05 J in each period after the first inputs; 41 of them are the first above 2 J.
    Fed fed(of);
    int steps = 0;
    while (!fed.watch.tripped() && steps < 1000) {
      fed.step(0.3, 5.0, sign);
      ++steps;
    }
    CHECK(steps == 42);
    CHECK(fed.watch.cause() == Cause::power);
    CHECK_THAT(fed.watch.text(), Contains(sign > 0 ? "arm was 2.05 J" : "arm was -2.05 J"));
  }
  Fed at_limit(of);
  for (int i = 0; i < 2000; ++i) at_limit.step(0.3, 2.0, 1.0);
  CHECK_FALSE(at_limit.watch.tripped());
}

TEST_CASE("what happened more than a second ago does not count, and all of what happened since does") {
  WatchLimits of = limits();
  of.powers = {{"arm", {0}, {1}, false, 2.0}};
  for (const auto& [pause, trips] : {std::pair{90, true}, {91, false}}) {
    Fed fed(of);
    fed.step(0.3, 0.0, 1.0);
    for (int i = 0; i < 10; ++i) fed.step(0.3, 10.0, 1.0);  // 1 J
    for (int i = 0; i < pause - 1; ++i) fed.step(0.3, 0.0, 1.0);
    fed.step(0.3, 10.0, 10.0);  // 1 J, or 0.9 + 1 J where the first period is just forgotten
    CHECK_FALSE(fed.watch.tripped());
    fed.step(0.3, 10.0, 1.4);
    CHECK(fed.watch.tripped() == trips);
  }
}

TEST_CASE("energies that come and go cancel, and after a second without any exactly none is left") {
  EnergyWindow window(0.3);
  std::int64_t now = 0;
  for (int i = 0; i < 300'000; ++i) window.add(now += ms / 4, (i % 2 == 0 ? 0.1 : -0.07) * std::sin(i));
  double sum = 0.0;  // of the bins that are in the window: this millisecond and the 999 before
  for (int i = 300'000 - 1; (i + 1) / 4 > 300'000 / 4 - 1000; --i)
    sum += (i % 2 == 0 ? 0.1 : -0.07) * std::sin(i);
  CHECK(window.energy() == Approx(sum).margin(1e-12));
  window.add(now + 1000 * ms, 0.0);
  CHECK(window.energy() == 0.0);
  window.add(now + 5000 * ms, 1e300);
  CHECK(window.energy() > 0.3);
  window.add(now + 6000 * ms, 0.0);
  CHECK(std::abs(window.energy()) < 1e-12);
}

TEST_CASE("a force over the change of a position is the same energy as over its speed") {
  WatchLimits of = limits();
  of.powers = {{"arm", {0}, {1, 0.001, 5.0}, true, 0.5}};  // a position in mm, with an offset that cancels
  Fed fed(of);
  int steps = 0;
  while (!fed.watch.tripped() && steps < 1000) fed.step(0.3, 10.0, 5.0 * ++steps);  // 0.05 J in a period
  CHECK(steps == 12);
}

TEST_CASE("between two parts of a loop the outputs rest at their safe values without a trip") {
  Fed fed;
  fed.step(0.4);
  fed.watch.rest();
  CHECK(fed.coil() == 0.25);
  fed.watch.waited(fed.now + 1'000 * ms);
  CHECK_FALSE(fed.watch.tripped());
  fed.now += 1'000 * ms;
  fed.step(0.4);
  CHECK(fed.coil() == 0.4);
}

// Commands come much faster than the period, as they do where each wake-up of the guard for its inputs is
// late.
TEST_CASE("commands do not keep a guard from its inputs") {
  const std::string name = "stepwire-test-reads-" + std::to_string(::getpid());
  RigHost rig(name);
  rig.step(1.0);
  GuardCall call{{{"rig", "shared", driver::driver_file("shared"), {{"name", name}, {"stale", "100 s"}}}},
                 {InputUse::held}};
  call.limits.period = 200 * ms;
  call.limits.late = 100'000 * ms;
  call.limits.inputs = {{"rig.force"}};
  call.limits.outputs = {{"rig.current"}};
  RunningGuard guard(call);
  guard.start();
  const double current = 0.5;
  double force = 0.0;
  for (int step = 0; step < 1000 && force != 2.0; ++step) {
    REQUIRE(guard.command(&current));
    rig.step(2.0);
    REQUIRE(guard.inputs(&force));
  }
  CHECK(force == 2.0);
}

namespace {

/// Returns a second map of the memory that this process shares with its guard.
Link link_of_guard() {
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code none;
    const std::string to = std::filesystem::read_symlink(entry.path(), none).string();
    if (to.find("stepwire-guard") != std::string::npos)
      return Link(io::Descriptor(::dup(std::stoi(entry.path().filename().string()))));
  }
  throw std::runtime_error("there is no guard");
}

}  // namespace

TEST_CASE("a guard that loses its processor while it writes inputs leaves the loop those before") {
  const std::string name = "stepwire-test-torn-" + std::to_string(::getpid());
  RigHost rig(name);
  rig.step(3.0);
  GuardCall call{{{"rig", "shared", driver::driver_file("shared"), {{"name", name}, {"stale", "100 s"}}}},
                 {InputUse::held}};
  call.limits.period = 10'000 * ms;  // no input is read meanwhile
  call.limits.late = 100'000 * ms;
  call.limits.inputs = {{"rig.force"}};
  call.limits.outputs = {{"rig.current"}};
  RunningGuard guard(call);
  guard.start();
  double force = 0.0;
  REQUIRE(guard.inputs(&force));
  CHECK(force == 3.0);
  const Link link = link_of_guard();
  link.inputs().begin();
  force = 0.0;
  CHECK(guard.inputs(&force));
  CHECK(force == 3.0);
  CHECK(guard.trouble().empty());
}

TEST_CASE("safe values reach each device that opens, and the others are named") {
  const std::string name = "stepwire-test-safe-" + std::to_string(::getpid());
  const std::string file = driver::driver_file("shared");
  RigHost rig(name);
  GuardCall call;
  call.devices = {{"gone", "shared", file, {{"name", name + "-none"}}, 1},
                  {"rig", "shared", file, {{"name", name}, {"stale", "100 s"}}, 1}};
  call.limits.outputs = {{"gone.current", 0.5}, {"rig.current", 0.125}};
  CHECK_THAT(set_safe(call),
             Catch::Contains("gone: driver shared: there is no shared memory") && !Catch::Contains("rig:"));
  CHECK(rig.step(1.0) == 0.125);
}

TEST_CASE("a guard renews the safe values as long as no command comes") {
  const std::string name = "stepwire-test-rests-" + std::to_string(::getpid());
  RigHost rig(name, "200 ms");
  rig.step(1.0);
  GuardCall call{{{"rig", "shared", driver::driver_file("shared"), {{"name", name}, {"stale", "100 s"}}}},
                 {InputUse::held}};
  call.limits.period = 10 * ms;
  call.limits.inputs = {{"rig.force"}};
  call.limits.outputs = {{"rig.current", 0.125}};
  RunningGuard guard(call);
  guard.start();
  ::usleep(500'000);
  CHECK(rig.is_fresh());
  CHECK(rig.step(1.0) == 0.125);
}

}  // namespace stepwire::guard
