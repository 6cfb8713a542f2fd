// The drivers `gamepad` and `tablet`, linked with calls of the system that the tests answer as the kernel
// does.
#include <dlfcn.h>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "engine/base/driver/open_device.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/simulate/devices/wired_device.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/evdev/fake_input.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::driver {
namespace {

using Catch::Contains;

/// A driver with its devices in memory, none of them at first.
struct Plugged {
  explicit Plugged(const std::string& name) : driver(name) {
    ::setenv("STEPWIRE_DRIVERS", FAKE_DRIVERS, 1);
    void* const library = ::dlopen(driver_file(driver).c_str(), RTLD_NOW | RTLD_LOCAL);
    REQUIRE(library);
    all = reinterpret_cast<FakeInputs* (*)()>(::dlsym(library, "fake_inputs"))();
    all->clear();
  }
  ~Plugged() { ::unsetenv("STEPWIRE_DRIVERS"); }

  FakeInput& add(const std::string& path, const std::string& name) {
    all->reserve(16);
    FakeInput& one = all->emplace_back();
    one.path = path;
    one.name = name;
    return one;
  }
  void open(const Settings& settings = {}) {
    device.emplace(load_driver(driver_file(driver)), settings);
    device->start(1'000'000, nullptr);
  }
  std::string refusal(const Settings& settings = {}) {
    try {
      open(settings);
      return "";
    } catch (const io::EnvironmentError& error) {
      return error.what();
    }
  }
  int read() {
    values.assign(device->inputs().size(), -99.0);
    return device->read(values.data());
  }
  /// Returns the value of a channel that the last read() gave.
  double value(const std::string& channel) const {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (channel == device->inputs()[i].name) return values[i];
    FAIL("no channel " << channel);
    return 0.0;
  }

  std::string driver, text;
  FakeInputs* all = nullptr;
  std::optional<OpenDevice> device;
  std::vector<double> values;
};

/// A pad as the driver xpad of the kernel offers it.
FakeInput& add_pad(Plugged& plugged, const std::string& path = "/dev/input/event3") {
  FakeInput& pad = plugged.add(path, "Pad");
  for (const int code : {ABS_X, ABS_Y, ABS_RX, ABS_RY}) pad.axis(code, -32768, 32767, 128);
  for (const int code : {ABS_Z, ABS_RZ}) pad.axis(code, 0, 255);
  for (const int code : {ABS_HAT0X, ABS_HAT0Y}) pad.axis(code, -1, 1);
  pad.keys = {BTN_SOUTH, BTN_EAST, BTN_TL, BTN_TRIGGER_HAPPY1};
  return pad;
}

FakeInput& add_tablet(Plugged& plugged, int resolution = 100) {
  FakeInput& tablet = plugged.add("/dev/input/event5", "Pen");
  tablet.axis(ABS_X, 0, 20000, 0, resolution);
  tablet.axis(ABS_Y, 1000, 11000, 0, resolution);
  tablet.axis(ABS_PRESSURE, 0, 2047);
  tablet.axis(ABS_TILT_X, -64, 63, 0, 57);
  tablet.keys = {BTN_TOUCH, BTN_TOOL_PEN, BTN_TOOL_RUBBER, BTN_STYLUS};
  return tablet;
}

}  // namespace

TEST_CASE("sticks of a gamepad go from -1 to 1 without a step at the flat zone, triggers from 0 to 1") {
  Plugged plugged("fake_gamepad");
  FakeInput& pad = add_pad(plugged);
  plugged.open();
  const double middle = -0.5, way = 32767.5 - 128.0;
  for (const auto& [number, expected] : {std::pair{0, 0.0},
                                         {127, 0.0},
                                         {-128, 0.0},
                                         {128, (128 - middle - 128.0) / way},
                                         {16000, (16000 - middle - 128.0) / way},
                                         {32767, 1.0},
                                         {-32768, -1.0}}) {
    pad.send(EV_ABS, ABS_X, number);
    pad.send(EV_ABS, ABS_Y, -1 - number);
    pad.report();
    REQUIRE(plugged.read() == STEPWIRE_OK);
    CHECK(plugged.value("x") == Approx(expected).margin(1e-12));
    CHECK(plugged.value("y") == Approx(-expected).margin(1e-12));
  }
  pad.send(EV_ABS, ABS_Z, 51);
  pad.send(EV_ABS, ABS_HAT0Y, -1);
  pad.report();
  plugged.read();
  CHECK(plugged.value("z") == Approx(0.2));
  CHECK(plugged.value("rz") == 0.0);
  CHECK(plugged.value("hat0y") == -1.0);
}

TEST_CASE("a pad whose second stick is z and rz has no triggers there, and brake and gas are some") {
  Plugged plugged("fake_gamepad");
  FakeInput& pad = plugged.add("/dev/input/event0", "Another");
  for (const int code : {ABS_X, ABS_Y, ABS_Z, ABS_RZ}) pad.axis(code, 0, 255, 15, 0, 128);
  for (const int code : {ABS_GAS, ABS_HAT2X}) pad.axis(code, 0, 1023);
  pad.axis(ABS_BRAKE, 0, 0);  // without a range
  pad.keys = {BTN_TRIGGER};
  plugged.open();
  pad.send(EV_ABS, ABS_Z, 0);
  pad.send(EV_ABS, ABS_GAS, 1023);
  pad.send(EV_ABS, ABS_HAT2X, 1023);
  pad.report();
  plugged.read();
  CHECK(plugged.value("z") == -1.0);
  CHECK(plugged.value("rz") == 0.0);  // 128 of 0 to 255 is in the flat zone
  CHECK(plugged.value("gas") == 1.0);
  CHECK(plugged.value("hat2x") == 1.0);
  CHECK(plugged.values.size() == 7);
}

TEST_CASE("buttons are 0 or 1, also those that are down at the start and those without a name") {
  Plugged plugged("fake_gamepad");
  FakeInput& pad = add_pad(plugged);
  pad.down = {BTN_TL};
  plugged.open();
  plugged.read();
  CHECK(plugged.value("tl") == 1.0);
  CHECK(plugged.value("south") == 0.0);
  for (const int state : {1, 2, 0}) {  // 2: a repeat
    pad.send(EV_KEY, BTN_SOUTH, state);
    pad.send(EV_KEY, BTN_TRIGGER_HAPPY1, state);
    pad.report();
    plugged.read();
    CHECK(plugged.value("south") == (state != 0 ? 1.0 : 0.0));
    CHECK(plugged.value("button_2c0") == plugged.value("south"));
  }
}

TEST_CASE("an event counts once its report is complete") {
  Plugged plugged("fake_gamepad");
  FakeInput& pad = add_pad(plugged);
  plugged.open();
  pad.send(EV_KEY, BTN_SOUTH, 1);
  pad.report();
  pad.send(EV_KEY, BTN_EAST, 1);
  plugged.read();
  CHECK(plugged.value("south") == 1.0);
  CHECK(plugged.value("east") == 0.0);
  pad.report();
  plugged.read();
  CHECK(plugged.value("east") == 1.0);
}

TEST_CASE("after reports that the kernel dropped the state is that of the device, not of the queue") {
  Plugged plugged("fake_gamepad");
  FakeInput& pad = add_pad(plugged);
  plugged.open();
  pad.send(EV_KEY, BTN_EAST, 1);
  pad.report();
  plugged.read();
  pad.send(EV_KEY, BTN_EAST, 0);  // these two are lost with the queue
  pad.send(EV_KEY, BTN_SOUTH, 1);
  pad.report();
  for (int i = 0; i < 31; ++i) {
    pad.send(EV_ABS, ABS_X, i);
    pad.report();
  }
  REQUIRE(pad.queue.front().code == SYN_DROPPED);
  REQUIRE(plugged.read() == STEPWIRE_OK);
  CHECK(plugged.value("east") == 0.0);
  CHECK(plugged.value("south") == 1.0);
  CHECK_THAT(plugged.device->report(), Contains("event3 (Pad)") && Contains("1 times some were dropped"));
}

TEST_CASE("up to the end of a dropped report its events do not count") {
  Plugged plugged("fake_gamepad");
  FakeInput& pad = add_pad(plugged);
  plugged.open();
  pad.send(EV_SYN, SYN_DROPPED, 0);
  pad.send(EV_ABS, ABS_X, 32767);
  pad.report();
  pad.axes[ABS_X].value = -32768;  // has moved on since
  plugged.read();
  CHECK(plugged.value("x") == -1.0);
}

TEST_CASE("a gamepad that is unplugged fails, also while its state is fetched") {
  Plugged plugged("fake_gamepad");
  FakeInput& pad = add_pad(plugged);
  plugged.open();
  CHECK(plugged.read() == STEPWIRE_OK);
  pad.unplugged = true;
  CHECK(plugged.read() == STEPWIRE_FAILED);
  CHECK(pad.opened == 1);
  plugged.device.reset();
  CHECK(pad.opened == 0);
}

TEST_CASE("the first device that is a gamepad is opened, a named one in its place") {
  Plugged plugged("fake_gamepad");
  FakeInput& board = plugged.add("/dev/input/event0", "Keyboard");
  board.keys = {KEY_A};
  FakeInput& pen = plugged.add("/dev/input/event1", "Pad of a tablet");
  pen.axis(ABS_X, 0, 1);
  pen.axis(ABS_Y, 0, 1);
  pen.keys = {BTN_SOUTH, BTN_STYLUS};
  FakeInput& first = add_pad(plugged, "/dev/input/event3");
  FakeInput& second = add_pad(plugged, "/dev/input/event12");
  plugged.open();
  CHECK(std::array{board.opened, pen.opened, first.opened, second.opened} == std::array{0, 0, 1, 0});
  plugged.device.reset();
  plugged.open({{"path", "/dev/input/event12"}});
  CHECK(second.opened == 1);
  std::array<char, 400> text{};
  load_driver(driver_file("fake_gamepad")).list(text.data(), text.size());
  CHECK(std::string(text.data()) == "    /dev/input/event3  Pad\n    /dev/input/event12  Pad\n");
}

TEST_CASE("without a gamepad, with another device, or without permission the reason is told") {
  Plugged plugged("fake_gamepad");
  CHECK_THAT(plugged.refusal(), Contains("driver gamepad: there is no gamepad in /dev/input"));
  plugged.add("/dev/input/event0", "Keyboard").keys = {KEY_A};
  plugged.add("/dev/input/event1", "?").closed = true;
  CHECK_THAT(plugged.refusal(), Contains("1 files there are closed, your user needs the group 'input'"));
  CHECK_THAT(plugged.refusal({{"path", "/dev/input/event0"}}),
             Contains("/dev/input/event0 (Keyboard) is no gamepad: one has the axes x and y, and buttons"));
  CHECK_THAT(plugged.refusal({{"path", "/dev/input/event1"}}),
             Contains("cannot be opened: Permission denied"));
  CHECK_THAT(plugged.refusal({{"path", "/dev/input/event9"}}), Contains("cannot be opened: No such file"));
  for (const FakeInput& one : *plugged.all) CHECK(one.opened == 0);
}

TEST_CASE("with the calls of the system itself a file that is no input device is refused") {
  for (const char* const name : {"gamepad", "tablet"}) {
    const auto open = [name](const std::string& path) {
      OpenDevice(load_driver(driver_file(name)), {{"path", path}});
    };
    CHECK_THROWS_WITH(open("/dev/null"), Contains("/dev/null cannot be opened: it is no input device"));
    CHECK_THROWS_WITH(open("/dev/stepwire-none"), Contains("cannot be opened: No such file"));
  }
}

TEST_CASE("a device at rest is stale only where an age is stated") {
  Plugged plugged("fake_gamepad");
  FakeInput& pad = add_pad(plugged);
  plugged.open({{"stale", "1 ns"}});
  CHECK(plugged.read() == STEPWIRE_STALE);
  plugged.device.reset();
  plugged.open({{"stale", "20 s"}});
  pad.report();
  CHECK(plugged.read() == STEPWIRE_OK);
}

TEST_CASE(
    "a pen has its place in meters by the resolution of the tablet, tilt in radians and pressure to 1") {
  Plugged plugged("fake_tablet");
  FakeInput& tablet = add_tablet(plugged);  // 100 steps in a millimeter
  plugged.open();
  const auto& x = plugged.device->inputs().front();
  CHECK(std::string(x.unit) == "m");
  CHECK(x.most == Approx(0.2));
  tablet.send(EV_KEY, BTN_TOOL_PEN, 1);
  tablet.send(EV_KEY, BTN_TOUCH, 1);
  tablet.send(EV_ABS, ABS_X, 5000);
  tablet.send(EV_ABS, ABS_Y, 3000);
  tablet.send(EV_ABS, ABS_PRESSURE, 2047);
  tablet.send(EV_ABS, ABS_TILT_X, -57);
  tablet.report();
  REQUIRE(plugged.read() == STEPWIRE_OK);
  CHECK(plugged.value("x") == Approx(0.05));
  CHECK(plugged.value("y") == Approx(0.02));
  CHECK(plugged.value("pressure") == 1.0);
  CHECK(plugged.value("tilt_x") == Approx(-1.0));
  CHECK(plugged.value("tip") + plugged.value("near") == 2.0);
  CHECK(plugged.value("rubber") + plugged.value("stylus") == 0.0);
  tablet.send(EV_KEY, BTN_TOOL_PEN, 0);
  tablet.send(EV_KEY, BTN_TOOL_RUBBER, 1);
  tablet.report();
  plugged.read();
  CHECK(plugged.value("near") + plugged.value("rubber") == 2.0);
}

TEST_CASE("a tablet without a resolution needs its width and height, and has no tilt without one") {
  Plugged plugged("fake_tablet");
  FakeInput& tablet = add_tablet(plugged, 0);
  tablet.axes[ABS_TILT_X].resolution = 0;
  CHECK_THAT(plugged.refusal(),
             Contains("/dev/input/event5 (Pen) has no resolution of its axis x; the setting "
                      "'width' has the length of the axis"));
  CHECK_THAT(plugged.refusal({{"width", "0.4 m"}}), Contains("its axis y; the setting 'height'"));
  CHECK_THAT(plugged.refusal({{"width", "0.4"}}), Contains("'width' needs a unit, one of m, cm, mm"));
  CHECK_THAT(plugged.refusal({{"width", "-1 m"}}), Contains("'width' must be above 0"));
  plugged.open({{"width", "40 cm"}, {"height", "200 mm"}});
  tablet.send(EV_ABS, ABS_X, 5000);
  tablet.send(EV_ABS, ABS_Y, 11000);
  tablet.report();
  plugged.read();
  CHECK(plugged.value("x") == Approx(0.1));
  CHECK(plugged.value("y") == Approx(0.2));
  for (const auto& one : plugged.device->inputs()) CHECK(std::string(one.name) != "tilt_x");
}

TEST_CASE(
    "the button of a gamepad is a dead-man: outputs follow while it is down, and its release is final") {
  const Plugged plugged("fake_gamepad");
  const Scratch folder;
  const FakePadFile pad(folder.path("events"));
  const std::string record = folder.path("out.csv");
  const auto rig = folder.file("rig.yaml", R"(devices:
  pad: {driver: fake_gamepad}
  card: {driver: file, pace: reads, outputs: drive in A, record: )" +
                                               record + R"(}
inputs: {stick: {device: pad, channel: x}}
outputs: {current: {device: card, channel: drive, limits: [0 A, 2 A]}}
dead_man: {device: pad, channel: tl, above: 0.5}
guard: false
)");
  const auto plan = stepwire::plan_text(R"(inputs: {stick: {default: 0}}
outputs: {current: {signal: coil, unit: A, safe: 0.25 A}}
blocks: {coil: {block: Gain, gain: 2 A, u: stick}}
record: [coil]
)");
  for (const auto& [rest, fault] :
       {std::pair{"{device: pad, channel: x, range: [2, 3]}}\n",
                  "inputs.stick.range: leads to 2 to 3; the channel gives -1 to 1"},
        {"{device: pad, channel: x}}\ndead_man: {device: pad, channel: tl, above: 1}\n",
         "dead_man.above: is 1; it must be 0 or more and below 1"}}) {
    const std::string file =
        folder.file("b.yaml", std::string("devices: {pad: {driver: fake_gamepad}}\ninputs: {stick: ") + rest);
    CHECK_THROWS_WITH(devices::Rig(file, plan, 0.01), Contains(fault));
  }
  devices::Rig opened(rig, plan, 0.01);
  opened.device().start();
  double stick = 0.0;
  const double current = 1.5;
  const auto step = [&](int button) {
    pad.send(EV_KEY, BTN_TL, button);
    pad.send(EV_ABS, ABS_X, 32767);
    opened.device().read(&stick);
    opened.device().write(&current);
  };
  for (const int button : {0, 1, 1, 0, 1}) step(button);
  CHECK(stick == 1.0);
  CHECK_THAT(opened.trouble(), Contains("dead-man input pad.tl was released"));
  opened.finish();
  const auto written = table::read_csv(record).find("drive")->values;
  const std::vector<double> first(written.begin(), written.begin() + 5);
  CHECK(first == std::vector{0.25, 0.25, 1.5, 1.5, 0.25});
}

}  // namespace stepwire::driver
