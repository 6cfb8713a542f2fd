// The driver `lsl` through the functions of liblsl, which a library of the tests has.
#include <dlfcn.h>
#include <catch2/catch.hpp>

#include "engine/base/driver/open_device.hpp"
#include "engine/base/io/environment_error.hpp"
#include "tests/support/lsl/fake_lsl.hpp"

namespace stepwire::driver {
namespace {

using Catch::Contains;

constexpr std::int64_t ms = 1'000'000;

/// The layer of the library, as new, with a stream of two channels. Its clock is an hour ahead.
FakeLayer& fresh_layer() {
  void* const library = ::dlopen(FAKE_LSL, RTLD_NOW | RTLD_LOCAL);
  REQUIRE(library);
  FakeLayer& layer = *reinterpret_cast<FakeLayer* (*)()>(::dlsym(library, "fake_layer"))();
  layer = FakeLayer();
  layer.streams.push_back({"Robot", "Force", "cell-1", 2, 1000.0, 2, 3600.0, false, {}});
  return layer;
}

void send(FakeLayer& layer, double time, const std::vector<double>& values) {
  layer.streams.front().samples.push_back({time + layer.streams.front().ahead, values});
}

Settings with_library(Settings settings) {
  settings.emplace_back("library", FAKE_LSL);
  return settings;
}

std::string refusal(const Settings& settings) {
  try {
    OpenDevice device(load_driver(driver_file("lsl")), settings);
    device.start(ms, nullptr);
    return "";
  } catch (const io::EnvironmentError& error) {
    return error.what();
  }
}

const Settings of_robot = with_library({{"read", "name=Robot"}, {"inputs", "force in N, angle in rad"}});

}  // namespace

TEST_CASE("the newest sample of a stream counts, with names and units of the settings") {
  FakeLayer& layer = fresh_layer();
  send(layer, 99.99, {1.0, 10.0});
  OpenDevice device(load_driver(driver_file("lsl")), of_robot);
  REQUIRE(device.inputs().size() == 2);
  CHECK(std::string(device.inputs()[1].name) + device.inputs()[1].unit == "anglerad");
  device.start(ms, nullptr);
  std::vector<double> values(2);
  CHECK(device.read(values.data()) == STEPWIRE_OK);
  CHECK(values == std::vector{1.0, 10.0});
  send(layer, 99.995, {2.0, 20.0});
  send(layer, 100.0, {3.0, 30.0});
  CHECK(device.read(values.data()) == STEPWIRE_OK);
  CHECK(values == std::vector{3.0, 30.0});
  CHECK_THAT(device.report(),
             Contains("3 samples") && Contains("10.000 ms old") && Contains("-3600000.000 ms"));
}

TEST_CASE("the age of a sample is that in the clock of this machine") {
  FakeLayer& layer = fresh_layer();
  send(layer, 99.95, {1.0, 0.0});
  OpenDevice device(load_driver(driver_file("lsl")), of_robot);
  device.start(ms, nullptr);
  std::vector<double> values(2);
  layer.clock = 100.049;
  CHECK(device.read(values.data()) == STEPWIRE_OK);
  layer.clock = 100.051;
  CHECK(device.read(values.data()) == STEPWIRE_STALE);
  CHECK(values[0] == 1.0);
  send(layer, 100.05, {2.0, 0.0});
  CHECK(device.read(values.data()) == STEPWIRE_OK);
}

TEST_CASE("between start and stop no call of the layer waits, and the clocks are compared before") {
  FakeLayer& layer = fresh_layer();
  send(layer, 100.0, {1.0, 0.0});
  OpenDevice device(load_driver(driver_file("lsl")), of_robot);
  device.start(ms, nullptr);
  CHECK(layer.corrections == 1);
  layer.timeouts.clear();
  std::vector<double> values(2);
  for (int i = 0; i < 5; ++i) device.read(values.data());
  CHECK(layer.timeouts == std::vector<double>(5, 0.0));
  CHECK(layer.corrections == 1);
}

TEST_CASE("outputs are samples of a stream with the rate of the loop, at last the safe ones") {
  FakeLayer& layer = fresh_layer();
  {
    OpenDevice device(load_driver(driver_file("lsl")),
                      with_library({{"outputs", "current in A, lamp"}, {"write", "Coil"}}));
    CHECK(layer.outlets.empty());
    const double safe[] = {0.25, 0.0}, values[] = {0.5, 1.0};
    device.start(2 * ms, safe);
    CHECK(device.write(values) == STEPWIRE_OK);
    CHECK(device.safe() == STEPWIRE_OK);
    REQUIRE(layer.outlets.size() == 1);
    const FakeStream& stream = layer.outlets.front();
    CHECK(stream.name + stream.type == "CoilControl");
    CHECK(stream.channels == 2);
    CHECK(stream.rate == 500.0);
    CHECK(stream.format == 2);
    CHECK(stream.samples[0].values == std::vector{0.5, 1.0});
    CHECK(stream.samples[1].values == std::vector{0.25, 0.0});
    layer.outlets.front().lost = true;
    CHECK(device.write(values) == STEPWIRE_FAILED);
  }
  CHECK(layer.open_outlets + layer.infos == 0);
}

TEST_CASE("a stream that is gone fails, and what was opened is closed") {
  FakeLayer& layer = fresh_layer();
  send(layer, 100.0, {1.0, 0.0});
  {
    OpenDevice device(load_driver(driver_file("lsl")), with_library({{"read", "type=Force"}}));
    CHECK(std::string(device.inputs()[1].name) == "c1");
    device.start(ms, nullptr);
    layer.streams.front().lost = true;
    std::vector<double> values(2);
    CHECK(device.read(values.data()) == STEPWIRE_FAILED);
  }
  CHECK(layer.inlets + layer.infos == 0);
}

TEST_CASE("without the library, the stream, or its samples the reason is told") {
  FakeLayer& layer = fresh_layer();
  CHECK_THAT(
      refusal({{"library", "libnone.so"}, {"outputs", "a"}}),
      Contains(
          "driver lsl: libnone.so cannot be loaded; packages of the Lab Streaming Layer are at https://"));
  CHECK_THAT(refusal(with_library({{"read", "name=Robo"}, {"wait", "3 s"}})),
             Contains("there is no stream with name=Robo"));
  CHECK(layer.timeouts == std::vector{3.0});
  CHECK_THAT(refusal(with_library({{"read", "Robot"}})), Contains("'read' is a property of a stream"));
  CHECK_THAT(refusal(with_library({{"inputs", "a"}})), Contains("inputs need the setting 'read'"));
  CHECK_THAT(refusal(with_library({})), Contains("neither 'read' nor 'outputs' gives a channel"));
  CHECK_THAT(refusal(with_library({{"read", "name=Robot"}, {"inputs", "a, b, c"}})),
             Contains("the stream has 2 channels, and 'inputs' names 3"));
  CHECK_THAT(refusal(of_robot), Contains("the stream has sent no sample in the time of 'wait'"));
  layer.streams.push_back({"Robot", "Force", "cell-2", 2, 1000.0, 2, 0.0, false, {}});
  CHECK_THAT(refusal(of_robot), Contains("there are several streams with name=Robot"));
  layer.streams.pop_back();
  layer.streams.front().format = 3;
  CHECK_THAT(refusal(of_robot), Contains("the stream has texts, not numbers"));
  layer.streams.front().format = 2;
  layer.streams.front().lost = true;
  CHECK_THAT(refusal(of_robot), Contains("the stream does not open in the time of 'wait'"));
  CHECK(layer.infos + layer.inlets == 0);
}

}  // namespace stepwire::driver
