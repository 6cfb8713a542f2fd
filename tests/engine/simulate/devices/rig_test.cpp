// From a rig file to channels: what is refused, and the numbers that pass between a diagram and the driver
// `file`.
#include <unistd.h>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <thread>

#include "engine/base/table/table_file.hpp"
#include "engine/simulate/devices/hosted_plant.hpp"
#include "engine/simulate/devices/wired_device.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::devices {
namespace {

using Catch::Contains;

const std::string diagram_yaml = R"(inputs:
  force: {unit: N, default: 3 N}
  arm: {unit: rad, default: [0, 0]}
outputs:
  current: {signal: coil, unit: A, safe: 0.1 A}
  angle: {signal: arm, safe: 0}
blocks:
  coil: {block: Gain, gain: 0.01 A/N, u: force}
record: [coil]
)";

/// A rig over the driver `file`, whose record has a row each 10 ms by reads.
struct Opened {
  explicit Opened(const std::string& rest, const std::string& record =
                                               "time [s],volt [V],turn [deg]\n0,1,180\n"
                                               "0.01,2,90\n0.02,4,0\n9,4,0\n")
      : plan(plan_text(diagram_yaml)), path(folder.file("rig.yaml", text(record, rest))) {}

  std::string text(const std::string& record, const std::string& rest) {
    return "devices:\n  card: {driver: file, pace: reads, play: " + folder.file("in.csv", record) +
           ", outputs: [drive in V, led], record: " + folder.path("out.csv") + "}\n" + rest;
  }
  void open() {
    rig.emplace(path, plan, 0.01);
    rig->device().start();
  }
  /// Returns the faults, "" for none.
  std::string faults() {
    try {
      open();
      return "";
    } catch (const yaml::Error& error) {
      return error.what();
    }
  }
  std::vector<double> read() {
    std::vector<double> values{3.0, 0.0, 0.0};
    rig->device().read(values.data());
    return values;
  }
  void write(double current) {
    const double outputs[] = {current, 0.0, 0.0};
    rig->device().write(outputs);
  }
  /// Returns a column of what the device got.
  std::vector<double> written(const std::string& column) {
    rig->finish();
    return table::read_csv(folder.path("out.csv")).find(column)->values;
  }

  Scratch folder;
  plan::Plan plan;
  std::string path;
  std::optional<Rig> rig;
};

}  // namespace

TEST_CASE("inputs have the scale, offset, direction and unit of their wires") {
  Opened one(R"(inputs:
  force: {device: card, channel: volt, scale: 20 N/V, offset: -5 N}
  arm.2: {device: card, channel: turn, direction: reverse}
)");
  one.open();
  const double pi = std::numbers::pi;
  CHECK(one.read() == std::vector{15.0, 0.0, -pi});
  CHECK(one.read() == std::vector{35.0, 0.0, -pi / 2});
  CHECK(one.rig->notes() == std::vector<std::string>{"input arm.1 is not wired and keeps its default",
                                                     "output current is not wired",
                                                     "output angle.1 is not wired",
                                                     "output angle.2 is not wired"});
}

TEST_CASE("a filter of first order goes the share of its cutoff in a step") {
  Opened one("inputs: {force: {device: card, channel: volt, scale: 1 N/V, filter: 5 Hz}}\n");
  one.open();
  const double share = 1.0 - std::exp(-2.0 * std::numbers::pi * 5.0 * 0.01);
  CHECK(one.read()[0] == 1.0);
  CHECK(one.read()[0] == Approx(1.0 + share));
  CHECK(one.read()[0] == Approx(1.0 + share + share * (3.0 - share)));
}

TEST_CASE("outputs are converted, kept within limits and rate, and end at the safe value") {
  Opened one(R"(outputs:
  current: {device: card, channel: drive, scale: 2 V/A, limits: [0 A, 0.35 A], rate: 10 A/s}
guard: false
)");
  one.open();
  for (const double current : {0.15, 0.5, 0.5, 0.5, 0.2, -1.0}) {
    one.read();
    one.write(current);
  }
  const double ends[] = {0.1, 0.0, 0.0};
  one.rig->device().rest(ends);
  const auto lines = one.rig->finish();
  CHECK_THAT(lines.back(),
             Contains("output current was held at its limits in 4 and at its rate in 3 of 6 steps"));
  const auto drive = one.written("drive");
  const std::vector expected{0.2, 0.3, 0.5, 0.7, 0.7, 0.5, 0.3};
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(drive[i] == Approx(expected[i]));
  CHECK(drive.back() == 0.2);
}

TEST_CASE("a value that is not finite ends the use of the devices at their safe values") {
  Opened one(
      "outputs: {current: {device: card, channel: drive, scale: 2 V/A, limits: [0 A, 1 A]}}\nguard: false\n");
  one.open();
  one.read();
  one.write(0.5);
  CHECK(one.rig->device().healthy());
  one.write(std::nan(""));
  CHECK_FALSE(one.rig->device().healthy());
  one.write(0.5);
  CHECK_THAT(one.rig->trouble(),
             Contains("rig.yaml:3, channel card.drive) was to become nan V; a command must be finite"));
  CHECK(one.written("drive") == std::vector{0.2, 1.0, 0.2, 0.2, 0.2});
}

TEST_CASE("a record that has ended ends the use of the devices, unless its last row is to hold") {
  const std::string short_record = "time [s],volt [V],turn [deg]\n0,1,0\n0.01,2,0\n";
  for (const std::string stale : {"stop", "hold"}) {
    Opened one("inputs: {force: {device: card, channel: volt, scale: 1 N/V, stale: " + stale + "}}\n",
               short_record);
    one.open();
    one.read();
    one.read();
    CHECK(one.rig->device().healthy());
    one.read();
    CHECK_FALSE(one.rig->device().healthy());  // an end is more than an old value
  }
}

namespace {

/// Memory that the other side of a rig shares, and the rig file for it.
struct Shared {
  std::string name = "stepwire-rig-test-" + std::to_string(::getpid());
  driver::OpenDevice host{
      driver::load_driver(driver::driver_file("shared")),
      {{"name", name}, {"role", "host"}, {"inputs", "coil in A"}, {"outputs", "hand in N"}}};
  Scratch folder;
  std::string file(const std::string& rest) const {
    return folder.file("rig.yaml",
                       "devices: {plant: {driver: shared, name: " + name +
                           "}}\ninputs: {force: {device: plant, channel: hand}}\n"
                           "outputs: {current: {device: plant, channel: coil, limits: [0 A, 1 A]}}\n" +
                           rest);
  }
};

}  // namespace

TEST_CASE("a loop begins with the first values of its devices, and shows its safe values until then") {
  for (const std::string guard : {"guard: false\n", "guard: true\n"}) {
    Shared other;
    const double zero = 0.0;
    other.host.start(10'000'000, &zero);
    std::thread later([&] {
      double coil = 0.0;
      while (coil != 0.1) other.host.read(&coil);
      const double hand = 7.0;
      other.host.write(&hand);
    });
    Rig rig(other.file(guard), plan_text(diagram_yaml), 0.01);
    rig.device().start();
    later.join();
    std::vector<double> inputs{3.0, 0.0, 0.0};
    rig.device().read(inputs.data());
    CHECK(inputs[0] == 7.0);
  }
}

TEST_CASE("a device that gives no value in time is named") {
  for (const std::string guard : {"guard: false\n", "guard: true\n"}) {
    Shared other;
    const double zero = 0.0;
    other.host.start(10'000'000, &zero);
    Rig rig(other.file("wait: 50 ms\n" + guard), plan_text(diagram_yaml), 0.01);
    CHECK_THROWS_WITH(rig.device().start(), Contains("plant: no value has come within 0.05 s"));
  }
}

TEST_CASE("a value that a driver refuses is a fault of the file at its setting") {
  const Scratch folder;
  const plan::Plan plan = plan_text(diagram_yaml);
  const std::string path = folder.file("rig.yaml", R"(devices:
  card: {driver: shared, name: rig, role: guest}
  line: {driver: udp, listen: 9001, stale: soon}
)");
  try {
    Rig(path, plan, 0.01);
    FAIL("the rig is taken");
  } catch (const yaml::Error& error) {
    CHECK_THAT(error.what(),
               Contains("rig.yaml:2:37: devices.card: driver shared: the setting 'role' is one of") &&
                   Contains("rig.yaml:3:37: devices.line: driver udp: the setting 'stale' is no"));
  }
}

TEST_CASE("a device that does not open hides no fault of its file") {
  const plan::Plan plan = plan_text(diagram_yaml);
  const auto rig_with = [&](const std::string& inputs) {
    const Scratch folder;
    Rig(folder.file("rig.yaml", "devices: {card: {driver: shared, name: never-there}}\ninputs:\n" + inputs),
        plan, 0.01);
  };
  CHECK_THROWS_WITH(rig_with("  forse: {device: card, channel: f}\n"
                             "  force: {device: card, channel: f, range: [5 N, -5 N], rate: 0 N/s}\n"),
                    Contains("3:3: forse: the diagram has no input 'forse'") &&
                        Contains("inputs.force.range: does not rise") &&
                        Contains("inputs.force.rate: must be above 0") && !Contains("shared memory"));
  CHECK_THROWS_AS(rig_with("  force: {device: card, channel: f}\n"), io::EnvironmentError);
  CHECK_THROWS_WITH(rig_with("  force: {device: card, channel: f}\n"),
                    Contains("card: driver shared: there is no shared memory"));
}

TEST_CASE("the range of a channel limits its input, and a range of the file within it") {
  const Scratch folder;
  const plan::Plan plan = plan_text(diagram_yaml);
  guard::SurveyedDevice answer;
  answer.inputs.push_back({"volt", "V", -10.0, 10.0});
  const auto limits = [&](const std::string& more) {
    const IoRequest request =
        read_io(folder.file("rig.yaml",
                            "devices: {card: {driver: file}}\ninputs: {force: {device: card, "
                            "channel: volt, scale: 2 N/V" +
                                more + "}}\n"));
    const Wiring wiring = wire(request, Ports::of(plan), {{{"card", "file", {}, {}}}, {answer}, ""}, 0.01);
    return std::pair(wiring.limits.inputs[0].least, wiring.limits.inputs[0].most);
  };
  CHECK(limits("") == std::pair(-10.0, 10.0));
  CHECK(limits(", range: [-4 N, 40 N]") == std::pair(-2.0, 10.0));
}

TEST_CASE("the faults of a rig file have their places, all at once") {
  Opened one(R"(inputs:
  forse: {device: card, channel: volt}
  force: {device: card, channel: volts, scale: 20 N/V}
  arm.1: {device: crad, channel: turn}
  arm.2: {device: card, channel: volt}
outputs:
  current: {device: card, channel: drive, scale: 2 V/N, limits: [0.35 A, 0 A], rate: 5 A}
  angle.1: {device: card, channel: led, limits: [1, 2]}
dead_man: {device: card, channel: button}
clock: card
)");
  const std::string faults = one.faults();
  INFO(faults);
  for (const char* text :
       {":4:3: forse: the diagram has no input 'forse'; did you mean 'force'?",
        ":5:3: inputs.force: the device 'card' has no input 'volts'; did you mean 'volt'?",
        ":6:3: inputs.arm.1: there is no device 'crad'; did you mean 'card'?",
        ":7:3: inputs.arm.2: is in rad, and its channel in V; 'scale' leads from one to the other, in rad/V",
        "outputs.current.scale: has the unit V/N; it must be in V/A", "outputs.current.limits: does not rise",
        "outputs.current.rate: has the unit A; it must be in A/s",
        "outputs.angle.1: has a safe value out of its limits",
        "dead_man: the device 'card' has no input 'button'", "clock: the driver of 'card' has no clock"})
    CHECK_THAT(faults, Contains(text));
}

TEST_CASE("keys, drivers and settings that are not known are refused with the nearest ones") {
  Opened key("inputs: {force: {device: card, channel: volt, skale: 20 N/V}}\n");
  CHECK_THAT(key.faults(), Contains("an input has no 'skale'; did you mean 'scale'?"));
  Opened number("inputs: {force: {device: card, channel: volt, scale: 20 N/V, filter: 20}}\n");
  CHECK_THAT(number.faults(), Contains("'20' is no number in Hz"));
  Opened missing("outputs: {current: {device: card, channel: drive, scale: 2 V/A}}\n");
  CHECK_THAT(missing.faults(), Contains("'limits' is missing"));
  Opened driver("");
  driver.path = driver.folder.file(
      "b.yaml", "devices: {a: {driver: fille}, b: {driver: shared}, c: {driver: file, plai: x}}\n");
  const std::string faults = driver.faults();
  CHECK_THAT(faults, Contains("b.yaml:1:11: devices.a: there is no driver 'fille'; there are ") &&
                         Contains("shared"));
  CHECK_THAT(faults, Contains("devices.b: the driver shared needs the setting 'name'"));
  CHECK_THAT(faults, Contains("the driver file has no 'plai'; did you mean 'play'?"));
}

TEST_CASE("a driver that fails is named with its function, or with the signal that ended its guard") {
  ::setenv("STEPWIRE_DRIVERS", FAKE_DRIVERS, 1);
  Opened one("");
  const auto trouble = [&](const std::string& fails, const std::string& guard) {
    one.path = one.folder.file("b.yaml", "devices: {bad: {driver: broken, fails: " + fails +
                                             "}}\noutputs: {current: {device: bad, channel: value, limits: "
                                             "[0 A, 1 A]}}\nguard: " +
                                             guard + "\n");
    try {
      one.open();
      one.write(0.5);
      one.rig->device().rest(nullptr);
      one.rig->finish();
      return one.rig->trouble();
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
  };
  for (const std::string guard : {"true", "false"}) {
    CHECK(trouble("open", guard) == "bad: driver broken: open has failed without a reason");
    CHECK(trouble("open, how: crash", guard) ==
          "bad: the driver broken was ended by signal 11 (Segmentation fault) in open or channels");
    CHECK(trouble("channels, how: exit", guard) ==
          "bad: the driver broken has ended its process with exit code 0 in open or channels");
    CHECK(trouble("close, how: exit", guard) ==
          "bad: the driver broken has ended its process with exit code 0 in close");
  }
  for (const std::string guard : {"true", "false"})
    CHECK_THAT(trouble("start", guard), Contains("driver broken: start has failed without a reason"));
  CHECK_THAT(trouble("start, how: crash", "true"),
             Contains("the guard was ended by signal 11") && Contains("while it started bad"));
  for (const std::string guard : {"true", "false"})
    CHECK(trouble("safe", guard) == "the device bad does not answer");
  CHECK(trouble("write", "false") == "the device bad does not answer");
}

TEST_CASE(
    "a driver that ends its process or does not return is found by a survey, which an interruption ends") {
  ::setenv("STEPWIRE_DRIVERS", FAKE_DRIVERS, 1);
  const std::string file = driver::driver_file("broken");
  const auto failures = [&](const std::string& fails, const std::string& how, guard::SurveyDepth depth,
                            const std::atomic<bool>* interrupt = nullptr) {
    const std::vector<guard::DeviceSettings> devices{
        {"good", "broken", file, {{"fails", ""}}}, {"bad", "broken", file, {{"fails", fails}, {"how", how}}}};
    const auto answers = guard::survey(devices, depth, 300'000'000, interrupt);
    return answers ? (*answers)[0].failure + (*answers)[1].failure : "interrupted";
  };
  using guard::SurveyDepth;
  CHECK(failures("start", "crash", SurveyDepth::open).empty());
  CHECK(failures("open", "crash", SurveyDepth::list).empty());
  CHECK(
      failures("open", "hang", SurveyDepth::open) ==
      "the driver broken has not returned within 0.3 s in open or channels; a larger 'wait' of the rig lets "
      "it take longer");
  const std::atomic<bool> interrupt = true;
  CHECK(failures("open", "hang", SurveyDepth::open, &interrupt) == "interrupted");
  ::setenv("BROKEN_DRIVER", "load", 1);
  CHECK(failures("", "error", SurveyDepth::load) ==
        "the driver broken has ended its process with exit code 0 while it was loaded");
  ::setenv("BROKEN_DRIVER", "list", 1);
  CHECK(failures("", "error", SurveyDepth::list) ==
        "the driver broken was ended by signal 11 (Segmentation fault) in list");
  ::unsetenv("BROKEN_DRIVER");
}

TEST_CASE("a limit of energy takes a force times a speed, or times a place") {
  const std::string wires =
      "inputs: {force: {device: card, channel: volt, scale: 1 N/V}, "
      "arm.1: {device: card, channel: turn}}\n";
  Opened product(wires + "energy: {wrong: {force: force, speed: arm.1, most: 5 J}}\n");
  CHECK_THAT(product.faults(), Contains("energy.wrong: force times arm.1 is in N; it must be in W"));
  Opened place(wires + "energy: {wrong: {force: arm.1, position: force, most: 5 J}}\n");
  CHECK_THAT(place.faults(), Contains("energy.wrong: arm.1 times force is in N; it must be in J"));
}

TEST_CASE("inputs that are pure numbers have no energy") {
  Opened one(
      "inputs: {force: {device: card, channel: volt, scale: 1 N/V}, "
      "push: {device: card, channel: volt, scale: 1 1/V}, pull: {device: card, channel: turn}}\n"
      "energy: {bare: {force: push, speed: pull, most: 5 J}}\n");
  one.plan = plan_text(R"(inputs: {force: {unit: N, default: 0 N}, push: {default: 0}, pull: {default: 0}}
blocks: {sum: {block: Sum, u: [push, pull]}}
record: [sum]
)");
  CHECK_THAT(one.faults(), Contains("energy.bare: push times pull is in 1; it must be in W"));
}

TEST_CASE("a number of a rig that makes no sense is refused once, with its place and its range") {
  const std::string out =
      "outputs: {current: {device: card, channel: drive, scale: 2 V/A, limits: [0 A, 1 A]";
  const std::string in = "inputs: {force: {device: card, channel: volt, scale: 1 N/V";
  for (const auto& [text, fault] : std::vector<std::pair<std::string, std::string>>{
           {"late: 1e300 s\n", ":3:7: late: 1e300 s is not allowed; it must be above 0 and at most 3600 s"},
           {"late: 1 ms\n", ":3:7: late: is 0.001 s; it must be the period of the loop or more, 0.01 s"},
           {"wait: 2 h\n", ":3:7: wait: 2 h is not allowed; it must be above 0 and at most 3600 s"},
           {"ramp: 1e300 s\n", ":3:7: ramp: 1e300 s is not allowed; it must be above 0 and at most 3600 s"},
           {"ramp: -1 s\n", "ramp: -1 s is not allowed; it must be above 0"},
           {in + ", stuck: 2 d}}\n", "stuck: 2 d is not allowed; it must be above 0 and at most 86400 s"},
           {in + ", filter: 2 MHz}}\n",
            "filter: 2 MHz is not allowed; it must be above 0 and at most 1000000 Hz"},
           {in + ", filter: 50 rad/s}}\n",
            "filter: is an angle per time, and a period has 2*pi rad; write it in Hz"},
           {in + ", filter: 3000 rpm}}\n",
            "filter: is an angle per time, and a period has 2*pi rad; write it in Hz"},
           {in + ", offset: 1e19 N}}\n",
            "offset: 1e19 N is not allowed; a number of a rig is at most 1e+18 in SI"},
           {in + ", range: [0 N, 1e300 N]}}\n", "1e300 N is not allowed"},
           {in + ", range: [1 V, 2 V]}}\n", "inputs.force.range: has the unit V; it must be in N"},
           {in + ", rate: 0 N/s}}\n", "inputs.force.rate: must be above 0"},
           {"inputs: {force: {device: card, channel: volt, scale: 1e-30 N/V}}\n",
            "inputs.force.scale: is 1e-30; its magnitude must be 1e-18 or more in SI"},
           {"inputs: {force: {device: card, channel: volt, scale: 0 N/V}}\n",
            "inputs.force.scale: is 0; its"},
           {out + ", safe: 2 A}}\n", "outputs.current: has a safe value out of its limits"},
           {out + ", safe: 1 V}}\n", "outputs.current.safe: has the unit V; it must be in A"},
           {"outputs: {current: {device: card, channel: drive, scale: 2 V/A, limits: [0 V, 1 V]}}\n",
            "outputs.current.limits: has the unit V; it must be in A"},
           {"outputs: {current: {device: card, channel: drive, scale: 2 V/A, limits: [1 A, 0 A]}}\n",
            "outputs.current.limits: does not rise; the least value is the first"},
           {in + "}}\nenergy: {e: {force: force, speed: force, most: 0 J}}\n",
            "most: 0 J is not allowed; it must be from 1e-12 to 1000000000000"}}) {
    Opened one(text);
    const std::string faults = one.faults();
    INFO(text << faults);
    CHECK_THAT(faults, Contains(fault));
    CHECK(std::ranges::count(faults, '\n') == 0);
  }
}

TEST_CASE("a filter that a slow loop cannot have is told") {
  Opened one("inputs: {force: {device: card, channel: volt, scale: 1 N/V, filter: 60 Hz}}\n");
  one.open();
  CHECK(one.rig->notes().front() ==
        "the filter of input force has no effect: 60 Hz is above half the rate of the loop, 50 Hz");
}

TEST_CASE("the threshold of a dead-man input is in the channel's unit, or has one of its dimension") {
  const auto trouble = [](const std::string& above) {
    Opened one(
        "inputs: {force: {device: card, channel: volt, scale: 1 N/V}}\n"
        "dead_man: {device: card, channel: turn, above: " +
        above + "}\nguard: false\n");
    one.open();
    for (int step = 0; step < 3; ++step) one.read();  // 180, 90 and 0 deg
    return one.rig->trouble();
  };
  CHECK_THAT(trouble("45"), Contains("card.turn was released"));
  CHECK_THAT(trouble("0.1 rev"), Contains("card.turn was released"));
  CHECK(trouble("-0.1 rev").empty());
  CHECK(trouble("200").empty());  // it was never held
  Opened other("dead_man: {device: card, channel: turn, above: 1 V}\n");
  CHECK_THAT(other.faults(), Contains("dead_man.above: has the unit"));
}

TEST_CASE("two outputs of one channel and an output without a safe value are refused") {
  Opened one(R"(outputs:
  current: {device: card, channel: drive, scale: 2 V/A, limits: [0 A, 1 A]}
  angle.1: {device: card, channel: drive, scale: 2 V, limits: [0, 1]}
)");
  CHECK_THAT(one.faults(), Contains("outputs.angle.1: the channel 'drive' has another output already"));
}

TEST_CASE("a fault of a rig in software lasts from its time to its end, or for good") {
  const auto plan = stepwire::plan_text(R"(inputs: {push: {default: 0}}
outputs: {place: {signal: slide, safe: 0}}
blocks: {slide: {block: Gain, gain: 1, u: push}}
record: [slide]
)");
  for (const auto& [fault, expected] : std::vector<std::pair<std::string, std::vector<double>>>{
           {"stuck:place@0.02s..0.04s", {0, 1, 1, 1, 4, 5}},
           {"jump:place=10@0.02s..30ms", {0, 1, 12, 3, 4, 5}},
           {"unplug@0.02s..0.04s", {0, 1, 1, 1, 4, 5}},
           {"unplug@0.02s", {0, 1, 1, 1, 1, 1}}}) {
    PlantCall call;
    call.driver = "shared";
    call.settings = {{"name", "stepwire-fault-test-" + std::to_string(::getpid())}};
    call.inhibit = 20.0;
    call.faults = {fault};
    HostedPlant plant(call, plan, 0.01);
    driver::OpenDevice client(driver::load_driver(driver::driver_file("shared")),
                              {{"name", call.settings.front().second}, {"stale", "20 s"}});
    const double safe = 0.0;
    client.start(10'000'000, &safe);
    std::vector<double> seen;
    for (int i = 0; i < 6; ++i) {
      double push = 0.0;
      const double place = i;
      plant.read(&push);
      plant.write(&place);
      client.read(&seen.emplace_back());
    }
    INFO(fault);
    CHECK(seen == expected);
  }
}

namespace {

const std::string slide_yaml = R"(inputs: {push: {default: 3}}
outputs: {place: {signal: slide, safe: 0}}
blocks: {slide: {block: Gain, gain: 1, u: push}}
record: [slide]
)";

PlantCall shared_plant() {
  PlantCall call;
  call.driver = "shared";
  call.settings = {{"name", "stepwire-plant-test-" + std::to_string(::getpid())}};
  call.inhibit = 20.0;
  return call;
}

driver::OpenDevice client_of(const PlantCall& call) {
  return {driver::load_driver(driver::driver_file("shared")),
          {{"name", call.settings.front().second}, {"stale", "20 s"}}};
}

}  // namespace

TEST_CASE("the inputs of a rig have their defaults before the first command") {
  const auto plan = plan_text(slide_yaml);
  const PlantCall call = shared_plant();
  HostedPlant plant(call, plan, 0.01);
  double push = 3.0;
  plant.read(&push);
  CHECK(push == 3.0);
  driver::OpenDevice client = client_of(call);
  const double safe = 0.0, command = 0.5;
  client.start(10'000'000, &safe);
  client.write(&command);
  plant.read(&push);
  CHECK(push == 0.5);
}

TEST_CASE("sensors with a latency show the first value until the next one has come") {
  const auto plan = plan_text(slide_yaml);
  PlantCall call = shared_plant();
  call.latency = 0.02;
  HostedPlant plant(call, plan, 0.01);
  driver::OpenDevice client = client_of(call);
  const double safe = 0.0;
  client.start(10'000'000, &safe);
  std::vector<double> seen;
  for (const double place : {5.0, 6.0, 7.0, 8.0, 9.0}) {
    double push = 0.0;
    plant.read(&push);
    plant.write(&place);
    client.read(&seen.emplace_back());
  }
  CHECK(seen == std::vector{5.0, 5.0, 5.0, 6.0, 7.0});
}

TEST_CASE("the inputs of a rig have their defaults again from the age of its option on") {
  const auto plan = plan_text(slide_yaml);
  PlantCall call = shared_plant();
  call.inhibit = 0.1;
  HostedPlant plant(call, plan, 0.01);
  driver::OpenDevice client = client_of(call);
  const double safe = 0.0, command = 0.5;
  client.start(10'000'000, &safe);
  client.write(&command);
  const auto pushed = [&] {
    double push = 3.0;
    plant.read(&push);
    return push;
  };
  CHECK(pushed() == 0.5);
  std::this_thread::sleep_for(std::chrono::milliseconds(110));
  CHECK(pushed() == 3.0);
  client.write(&command);
  CHECK(pushed() == 0.5);
}

TEST_CASE("shared memory has one client at a time") {
  const auto plan = plan_text(slide_yaml);
  const PlantCall call = shared_plant();
  HostedPlant plant(call, plan, 0.01);
  { const driver::OpenDevice first = client_of(call); }
  const driver::OpenDevice client = client_of(call);
  CHECK_THROWS_WITH(client_of(call), Contains("is in use by another loop"));
}

TEST_CASE("of two inputs of one channel the stricter limits hold") {
  Opened one(
      "inputs:\n  force: {device: card, channel: volt, scale: 1 N/V, rate: 10 N/s}\n"
      "  arm.1: {device: card, channel: volt, scale: 1 rad/V}\nguard: false\n");
  one.open();
  one.read();
  CHECK(one.rig->device().healthy());
  one.read();
  CHECK_FALSE(one.rig->device().healthy());
  CHECK_THAT(one.rig->trouble(), Contains("card.volt"));
}

}  // namespace stepwire::devices
