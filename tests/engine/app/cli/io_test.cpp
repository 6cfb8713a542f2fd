// Loops with devices, and the verbs for them. Timing is never checked.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "engine/base/table/table_file.hpp"
#include "tests/engine/app/cli/program.hpp"

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
  REQUIRE(drive.size() >= 22);  // safe at first, 20 steps, safe at last
  CHECK(drive.front() == 1.0);
  CHECK(drive.back() == 1.0);
  for (std::size_t i = 0; i < 20; ++i)
    CHECK(drive[i + 1] == Approx(0.8 * (i < 5 ? 1.0 : i < 10 ? 2.0 : 3.0)));
  const auto report = nlohmann::json::parse(content_of(folder.path("out/loop.json")));
  CHECK(report["end"] == "done");
  CHECK(report["read"]["count"] == 20);
  CHECK(report["write"]["count"] == 20);
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
  CHECK_THAT(done.err, Contains("the device has no new values"));
  const auto report = nlohmann::json::parse(content_of(folder.path("out/loop.json")));
  CHECK(report["faults"] == nlohmann::json{"the device has no new values"});
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
