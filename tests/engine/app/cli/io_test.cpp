// Loops with devices, and the verbs for them. Timing is never checked.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/table/table_file.hpp"
#include "tests/engine/app/cli/program.hpp"
#include "tests/support/rig_host.hpp"

namespace {

using Catch::Contains;

const std::string follow_yaml = R"(stepwire: 1
title: A coil that follows a force
step: 10 ms
stop: 1 s
inputs: {force: {unit: N, default: 1 N}}
outputs: {current: {signal: coil, unit: A, safe: 0.25 A}}
blocks:
  coil: {block: Gain, u: force, gain: 0.1 A/N}
record: [coil]
)";

const std::string rig_yaml = R"(devices:
  card: {driver: file, pace: reads, play: in.csv, outputs: drive in V, record: out.csv}
inputs:
  force: {device: card, channel: volt, scale: 2 N/V}
outputs:
  current: {device: card, channel: drive, scale: 4 V/A, limits: [0 A, 2 A]}
guard: false
)";

/// Runs the loop at 100 Hz with the rig.
Done loop(const Scratch& folder, const std::string& rig, const std::string& duration = "0.2") {
  folder.file("a.yaml", follow_yaml);
  folder.file("rig.yaml", rig);
  return run_program(folder, {"loop", "a.yaml", "--io", "rig.yaml", "--rate", "100", "--duration", duration,
                              "--policy", "other", "--overrun", "catch-up", "--out", "out"});
}

}  // namespace

TEST_CASE("a loop reads and writes the devices of its rig, ends at the safe value, and is verified") {
  const Scratch folder;
  folder.file("in.csv", "time [s],volt [V]\n0,1\n0.05,2\n0.1,3\n9,3\n");
  const Done done = loop(folder, rig_yaml);
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("  read ") && Contains("  write ") && Contains("card: 20 reads"));
  const auto out = stepwire::table::read_csv(folder.path("out.csv"));
  const auto& drive = out.find("drive")->values;
  REQUIRE(drive.size() >= 22);  // safe until the first step, 20 steps, safe at last
  CHECK(drive.front() == 1.0);
  CHECK(drive.back() == 1.0);
  const auto first = std::ranges::find_if(drive, [](double value) { return value != 1.0; });
  REQUIRE(drive.end() - first > 20);
  for (std::ptrdiff_t i = 0; i < 20; ++i) CHECK(first[i] == Approx(0.8 * (i < 5 ? 1.0 : i < 10 ? 2.0 : 3.0)));
  const auto report = nlohmann::json::parse(content_of(folder.path("out/loop.json")));
  CHECK(report["end"] == "done");
  CHECK(report["device_read"]["count"] == 20);
  CHECK(report["device_write"]["count"] == 20);
  CHECK(report["devices"].size() == 1);
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
}

TEST_CASE("a device that has nothing new ends a loop with 3, its reason, and the safe value") {
  const Scratch folder;
  folder.file("in.csv", "time [s],volt [V]\n0,1\n0.05,2\n");
  const Done done = loop(folder, rig_yaml);
  INFO(done.err << done.out);
  CHECK(done.code == 3);
  CHECK_THAT(done.out, Contains("ended by a device"));
  CHECK_THAT(done.err, Contains("the device card has no new values"));
  const auto report = nlohmann::json::parse(content_of(folder.path("out/loop.json")));
  CHECK(report["faults"] == nlohmann::json{"the device card has no new values"});
  CHECK(stepwire::table::read_csv(folder.path("out.csv")).find("drive")->values.back() == 1.0);
}

TEST_CASE("a rig with faults moves nothing") {
  const Scratch folder;
  folder.file("in.csv", "time [s],volt [V]\n0,1\n");
  const Done done = loop(folder, rig_yaml + "late: 1 m\nramp: fast\n");
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("rig.yaml:8:7: late: '1 m' is no number in s") &&
                           Contains("rig.yaml:9:7: ramp: 'fast' is no number with a unit"));
  CHECK_FALSE(std::filesystem::exists(folder.path("out.csv")));
}

TEST_CASE("the drivers are listed with their settings") {
  const Scratch folder;
  const Done done = run_program(folder, {"devices"});
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("file: plays a record") && Contains("latency") &&
                           Contains("shared: shared memory") && Contains("name of the shared memory") &&
                           Contains("required"));
}

TEST_CASE("a driver of one's own is found in the folder that STEPWIRE_DRIVERS names, and a bad one is told") {
  const Scratch folder;
  std::filesystem::create_directory(folder.path("own"));
  folder.file("own/mine.so", "no object");
  Call call;
  call.arguments = {"devices"};
  call.environment["STEPWIRE_DRIVERS"] = folder.path("own");
  const Done done = run_program(folder, call);
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Contains("own/mine.so cannot be loaded"));
}

TEST_CASE("the duration of io is a time above 0") {
  const Scratch folder;
  folder.file("in.csv", "time [s],volt [V]\n0,1\n9,1\n");
  folder.file("a.yaml", rig_yaml);
  for (const std::string bad : {"0", "-1", "nan", "2 N", "2 h"}) {
    const Done done = run_program(folder, {"io", "a.yaml", "--duration", bad});
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Contains("--duration " + bad + ": must be above 0 and at most 1 h"));
  }
  CHECK(run_program(folder, {"io", "a.yaml", "--duration", "30 ms"}).code == 0);
}

namespace {

/// A plant in one process and its controller in another one, at 100 Hz by shared memory.
struct Pair {
  Pair() {
    folder.file("plant.yaml", R"(stepwire: 1
title: A slide that is driven at a speed
step: 10 ms
stop: 1 s
solver: euler
inputs: {speed: {unit: m/s, default: 0 m/s}}
outputs: {place: {signal: slide, safe: 0 m}}
blocks: {slide: {block: Integrator, u: speed}}
record: [slide]
)");
    folder.file("control.yaml", R"(stepwire: 1
title: A controller of a place
step: 10 ms
stop: 1 s
inputs: {place: {unit: m, default: 0 m}}
outputs: {speed: {signal: drive, safe: 0 m/s}}
blocks:
  error: {block: Sum, signs: "+-", u: [1 m, place]}
  drive: {block: Gain, u: error, gain: 5 1/s}
record: [place, drive]
)");
    folder.file(
        "rig.yaml",
        "devices: {rig: {driver: shared, name: " + name +
            ", stale: 2 s}}\ninputs: {place: {device: rig, channel: place}}\noutputs: {speed: {device: rig, "
            "channel: speed, limits: [-4 m/s, 4 m/s]}}\nlate: 1 s\n");
  }

  std::vector<std::string> rig(const std::vector<std::string>& more) const {
    std::vector<std::string> all{"rig",      "plant.yaml", "--shared",  name,  "--rate", "100",
                                 "--policy", "other",      "--inhibit", "2 s", "--out",  "plant"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Done control() const {
    for (int look = 0; look < 500 && !std::filesystem::exists("/dev/shm/" + name); ++look) ::usleep(10'000);
    return run_program(folder, {"loop", "control.yaml", "--io", "rig.yaml", "--rate", "100", "--duration",
                                "3", "--policy", "other", "--out", "control"});
  }
  std::vector<double> places(const std::string& of) const {
    return stepwire::table::read_csv(folder.path(of))
        .find(of.starts_with("plant") ? "slide" : "place")
        ->values;
  }

  Scratch folder;
  std::string name = "stepwire-pair-" + std::to_string(::getpid());
};

}  // namespace

TEST_CASE("a controller moves a plant in another process, and both are verified bit by bit") {
  const Pair pair;
  stepwire::Beside plant(STEPWIRE_PROGRAM, pair.rig({"--duration", "5", "--quantum", "place=0.001m"}),
                         pair.folder.path(""));
  const Done done = pair.control();
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK(plant.end() == 0);
  CHECK(pair.places("control/signals.csv").back() == Approx(1.0).margin(0.002));
  for (const double place : pair.places("control/signals.csv"))
    CHECK(std::abs(place * 1000 - std::round(place * 1000)) < 1e-9);
  for (const char* side : {"control", "plant"}) CHECK(run_program(pair.folder, {"verify", side}).code == 0);
  CHECK_FALSE(std::filesystem::exists("/dev/shm/" + pair.name));
}

TEST_CASE("a sensor of the rig that becomes no number ends the controller") {
  const Pair pair;
  stepwire::Beside plant(STEPWIRE_PROGRAM, pair.rig({"--duration", "5", "--fault", "nan:place@0.5s"}),
                         pair.folder.path(""));
  const Done done = pair.control();
  CHECK(done.code == 3);
  CHECK_THAT(
      done.err,
      Contains("input inputs.place (rig.yaml:2, channel rig.place) became nan m; look at the sensor") &&
          !Contains("solver"));
}

TEST_CASE("what is asked of a rig wrongly is refused with what would be right") {
  const Pair pair;
  for (const auto& [options, text] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--noise", "plac=1m"}, "--plac"},
           {{"--noise", "place=1N"}, "is not in m, the unit of place"},
           {{"--fault", "bend:place@1s"}, "is no fault; such as stuck:force@2s"},
           {{"--fault", "unplug@2s..1s"}, "ends before it begins"},
           {{"--fault", "nan:place@-1s"}, "begins before the rig does; its time is 0 s or more"},
           {{"--fault", "unplug@2s..soon"}, "'soon' is no time, such as '2 s'"},
           {{"--latency", "2"}, "must be a time"}}) {
    const Done done = run_program(pair.folder, pair.rig(options));
    INFO(done.err);
    CHECK(done.code == 2);
    if (text != "--plac")
      CHECK_THAT(done.err, Contains(text));
    else
      CHECK_THAT(done.err, Contains("the diagram has no output 'plac'; did you mean 'place'?"));
  }
}

TEST_CASE("the inputs of a rig are shown in SI, and one output is moved within its limits") {
  const Scratch folder;
  folder.file("in.csv", "time [s],volt [V]\n0,1\n9,1\n");
  folder.file("rig.yaml", R"(devices:
  card: {driver: file, pace: reads, play: in.csv, outputs: drive in V, record: out.csv}
inputs: {force: {device: card, channel: volt, scale: 2 N/V}}
outputs: {current: {device: card, channel: drive, scale: 4 V/A, limits: [0 A, 2 A]}}
)");
  const Done done = run_program(folder, {"io", "rig.yaml", "--set", "current=5A", "--duration", "0.3"});
  INFO(done.err << done.out);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("  force 2 N\n") && Contains("output current was held at its limits"));
  const auto drive = stepwire::table::read_csv(folder.path("out.csv")).find("drive")->values;
  CHECK(*std::ranges::max_element(drive) == 8.0);
  CHECK(drive.back() == 0.0);
  for (const auto& [set, text] : std::vector<std::pair<std::string, std::string>>{
           {"curent=5A", "must be an output of the rig with a value"},
           {"current=0.5", "has no unit; current is in A: current=0.05A"},
           {"current=5V", "current is in A"}}) {
    const Done refused = run_program(folder, {"io", "rig.yaml", "--set", set});
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Contains(text));
  }
}

TEST_CASE("an output that io moves keeps its rate where io has lost its processor") {
  const Scratch folder;
  const std::string name = "stepwire-test-" + std::to_string(::getpid());
  stepwire::RigHost rig(name);
  folder.file("rig.yaml", "devices: {rig: {driver: shared, name: " + name +
                              "}}\noutputs: {current: {device: rig, channel: current, limits: [0 A, 0.5 A], "
                              "rate: 0.25 A/s, safe: 0 A}}\nlate: 10 s\n");
  stepwire::Beside io(STEPWIRE_PROGRAM, {"io", "rig.yaml", "--set", "current=0.5A", "--duration", "20"},
                      folder.path(""));
  double current = rig.step(1.0);
  for (int look = 0; look < 3000 && !(current > 0.0); ++look) current = rig.step(1.0);
  REQUIRE(current > 0.0);
  for (int pause = 0; pause < 3; ++pause) {
    io.send(SIGSTOP);
    ::usleep(1'500'000);
    io.send(SIGCONT);
    ::usleep(100'000);
  }
  CHECK(rig.steps_until(0.5, 1500) <= 1500);
  io.send(SIGINT);
  CHECK(io.end() == 0);
  CHECK(content_of(folder.path(".err")).empty());
}

TEST_CASE("a record on a full disk ends io and loop with 3") {
  const Scratch folder;
  folder.file("in.csv", "time [s],volt [V]\n0,1\n9,1\n");
  folder.file("a.yaml", follow_yaml);
  std::string rig = rig_yaml.substr(0, rig_yaml.find("guard")) + "late: 1 s\n";
  rig.replace(rig.find("out.csv"), 7, "/dev/full");
  for (const std::string guard : {"true", "false"}) {
    folder.file("rig.yaml", rig + "guard: " + guard + "\n");
    for (const std::vector<std::string>& call :
         {std::vector<std::string>{"io", "rig.yaml", "--set", "current=1A", "--duration", "0.2"},
          {"loop", "a.yaml", "--io", "rig.yaml", "--rate", "100", "--duration", "0.2", "--policy",
           "other"}}) {
      const Done done = run_program(folder, call);
      INFO(done.err << done.out);
      CHECK(done.code == 3);
      CHECK_THAT(done.err, Contains("card: the record /dev/full has 0 of ") &&
                               Contains(" rows: No space left on device"));
      CHECK_THAT(done.out, Contains("card: ") && Contains(" reads, "));
    }
  }
}

TEST_CASE("a record that a full disk has cut has whole rows, and their number is told") {
  const Scratch folder;
  folder.file("in.csv", "time [s],volt [V]\n0,1\n9,1\n");
  std::string names;
  for (int i = 0; i < 100; ++i) names += ", drive" + std::to_string(i);
  folder.file("rig.yaml",
              "devices:\n  card: {driver: file, pace: reads, play: in.csv, record: out.csv, "
              "outputs: [drive in A" +
                  names +
                  "]}\noutputs: {current: {device: card, channel: "
                  "drive, limits: [0 A, 2 A]}}\nguard: false\n");
  Call call;
  call.arguments = {"io", "rig.yaml", "--set", "current=1A", "--duration", "2"};
  call.max_bytes_of_file = 16'000;
  const Done done = run_program(folder, call);
  INFO(done.err << done.out);
  CHECK(done.code == 3);
  const std::string record = content_of(folder.path("out.csv"));
  CHECK_THAT(record, Catch::StartsWith("time [s],drive [A],drive0,") && Catch::EndsWith("\n"));
  const auto rows = lines_of(record).size() - 1;
  CHECK(rows > 3);
  CHECK(stepwire::table::read_csv(folder.path("out.csv")).rows() == rows);
  CHECK_THAT(done.err, Contains("card: the record out.csv has " + std::to_string(rows) + " of ") &&
                           Contains(" rows: File too large"));
}

TEST_CASE("an angle is shown in rad, a pure number without a unit, and a missing record with its path") {
  const Scratch folder;
  folder.file("in.csv", "time [s],turn [deg],knob\n0,180,0.5\n9,180,0.5\n");
  const auto rig = [&](const std::string& record) {
    folder.file("rig.yaml", "devices: {card: {driver: file, pace: reads, play: " + record +
                                "}}\ninputs: {angle: {device: card, channel: turn}, knob: {device: card, "
                                "channel: knob}}\n");
    return run_program(folder, {"io", "rig.yaml", "--duration", "0.02"});
  };
  CHECK_THAT(rig("in.csv").out, Contains("  angle 3.14159 rad  knob 0.5\n"));
  const Done done = rig("none.csv");
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Contains("the record none.csv does not exist"));
}

TEST_CASE("the check for real time has a cure for each weak line") {
  const Scratch folder;
  const Done done = run_program(folder, {"realtime-check"});
  CHECK(done.code <= 1);
  CHECK_THAT(done.out,
             Contains("kernel: ") && Contains("isolated processors: ") && Contains("locked memory: "));
  if (done.code == 1) CHECK_THAT(done.out, Contains("weak"));
}
