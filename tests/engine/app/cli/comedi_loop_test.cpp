// A loop over the channels of a Comedi card: its driver calls a library with the functions of libcomedi,
// behind which a rig in software is the plant.
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <sstream>

#include "tests/engine/app/cli/program.hpp"
#include "tests/support/rig_host.hpp"

namespace {

using Catch::Contains;

const char* const plant_yaml = R"(stepwire: 1
title: A motor and its tachometer, in volts
step: 10 ms
stop: 1 s
solver: rk4
inputs: {dac0: {unit: V, default: 0 V}}
outputs: {adc0: {signal: motor, unit: V}}
blocks:
  twice: {block: Gain, u: dac0, gain: 2}
  motor: {block: Lag, u: twice, tau: 200 ms}
record: [motor, dac0]
)";

const char* const controller_yaml = R"(stepwire: 1
title: Speed is held in proportion to its error
step: 10 ms
stop: 1 s
inputs: {speed: {unit: V, default: 0 V}}
outputs: {voltage: {signal: control, unit: V, safe: 0 V}}
blocks:
  error:   {block: Sum, u: [2 V, speed], signs: "+-"}
  control: {block: Gain, u: error, gain: 1.5}
record: [speed, control]
)";

const char* const rig_yaml = R"(inputs: {speed: {device: card, channel: adc0}}
outputs: {voltage: {device: card, channel: dac0, limits: [-5 V, 5 V]}}
late: 2 s
)";

std::vector<double> last_row(const Scratch& folder, const std::string& file) {
  const std::vector<std::string> lines = lines_of(content_of(folder.path(file)));
  std::vector<double> numbers;
  std::istringstream words(lines.back());
  for (std::string word; std::getline(words, word, ',');) numbers.push_back(std::stod(word));
  return numbers;
}

}  // namespace

// With s the speed and v the voltage, both at rest: s = 2 v and v = 1.5 (2 V - s), so s = 1.5 V and v = 0.75
// V. A step of the output of 14 bits is 1.2 mV, one of the input of 16 bits 0.15 mV.
TEST_CASE("a loop over a converter of a Comedi card and back settles where the plant behind it has to be",
          "[full]") {
  const Scratch folder;
  const std::string name = "stepwire-card-" + std::to_string(::getpid());
  std::filesystem::create_directory(folder.path("plant"));
  folder.file("plant/a.yaml", plant_yaml);
  folder.file("a.yaml", controller_yaml);
  folder.file("rig.yaml",
              "devices: {card: {driver: comedi, inputs: adc0, outputs: dac0, library: " FAKE_COMEDI "}}\n" +
                  std::string(rig_yaml));
  stepwire::Beside plant(STEPWIRE_PROGRAM,
                         {"rig", "a.yaml", "--shared", name, "--rate", "100", "--duration", "600", "--policy",
                          "other", "--inhibit", "60 s", "--out", "out"},
                         folder.path("plant"));
  Call call;
  call.arguments = {"loop",       "a.yaml", "--io",     "rig.yaml", "--rate", "100",
                    "--duration", "5",      "--policy", "other",    "--out",  "out"};
  call.environment["FAKE_COMEDI_RIG"] = name;
  const Done done = run_program(folder, call);
  INFO(done.err);
  REQUIRE(done.code == 0);
  const std::vector<double> row = last_row(folder, "out/signals.csv");
  CHECK(row[row.size() - 2] == Approx(1.5).margin(3e-3));
  CHECK(row.back() == Approx(0.75).margin(4e-3));
  CHECK_THAT(run_program(folder, {"verify", "out"}).out, Contains("bit"));
  plant.send(SIGINT);
  CHECK(plant.end() == 130);
  // The plant has got the voltage in steps of the converter, and 0 V at the end of the loop.
  CHECK(last_row(folder, "plant/out/signals.csv").back() == Approx(0.0).margin(20.0 / 16383));
}
