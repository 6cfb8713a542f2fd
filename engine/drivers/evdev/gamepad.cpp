// Driver for gamepads and joysticks, as the kernel offers them.
#include "engine/drivers/evdev/input_device.hpp"
#include "engine/drivers/support/table.hpp"

namespace stepwire::evdev {
namespace {

bool is_gamepad(const InputFile& file) {
  const Keys& keys = file.keys();
  return file.axes().has(ABS_X) && file.axes().has(ABS_Y) && keys.has_any(BTN_JOYSTICK, BTN_THUMBR) &&
         !keys.has(BTN_STYLUS) && !keys.has(BTN_TOOL_PEN);
}

std::vector<AxisRow> gamepad_axes() {
  const char* const down = "down, or towards the user, is positive";
  const char* const lever = "0 to 1 beside a right stick rx, ry; otherwise -1 to 1";
  return {{ABS_X, "x", Scaling::stick, "right is positive"},
          {ABS_Y, "y", Scaling::stick, down},
          {ABS_Z, "z", Scaling::lever, lever},
          {ABS_RX, "rx", Scaling::stick, "right is positive"},
          {ABS_RY, "ry", Scaling::stick, down},
          {ABS_RZ, "rz", Scaling::lever, lever},
          {ABS_THROTTLE, "throttle", Scaling::trigger, ""},
          {ABS_RUDDER, "rudder", Scaling::stick, ""},
          {ABS_WHEEL, "wheel", Scaling::stick, ""},
          {ABS_GAS, "gas", Scaling::trigger, ""},
          {ABS_BRAKE, "brake", Scaling::trigger, ""},
          {ABS_HAT0X, "hat0x", Scaling::hat, "right is 1"},
          {ABS_HAT0Y, "hat0y", Scaling::hat, "down is 1"},
          {ABS_HAT1X, "hat1x", Scaling::hat, ""},
          {ABS_HAT1Y, "hat1y", Scaling::hat, ""},
          {ABS_HAT2X, "hat2x", Scaling::hat, ""},
          {ABS_HAT2Y, "hat2y", Scaling::hat, ""},
          {ABS_HAT3X, "hat3x", Scaling::hat, ""},
          {ABS_HAT3Y, "hat3y", Scaling::hat, ""}};
}

std::vector<KeyRow> gamepad_keys() {
  std::vector<KeyRow> rows;
  const auto add = [&](std::uint16_t first, std::initializer_list<const char*> names) {
    for (const char* const name : names) {
      rows.push_back({first, first, name, ""});
      ++first;
    }
  };
  add(BTN_JOYSTICK, {"trigger", "thumb", "thumb2", "top", "top2", "pinkie", "base", "base2", "base3", "base4",
                     "base5", "base6"});
  add(BTN_GAMEPAD, {"south", "east", "c", "north", "west", "button_z", "tl", "tr", "tl2", "tr2", "select",
                    "start", "mode", "thumbl", "thumbr"});
  add(BTN_DPAD_UP, {"dpad_up", "dpad_down", "dpad_left", "dpad_right"});
  return rows;
}

const Kind& gamepad() {
  static const Kind kind{"gamepad",      "one has the axes x and y, and buttons of a gamepad or joystick",
                         is_gamepad,     gamepad_axes(),
                         gamepad_keys(), true};
  return kind;
}

struct Gamepad : InputDevice {
  explicit Gamepad(const support::Settings& settings) : InputDevice(settings, gamepad()) {}
};

constexpr stepwire_known_setting settings[] = {
    {"path", "file of the device, /dev/input/event3 or one of by-id; the first gamepad otherwise", ""},
    {"stale",
     "age of the last report from which values are stale, 5 s; at rest there is none; never without it", ""},
    {nullptr, nullptr, nullptr}};

void list(char* text, std::size_t size) {
  list_devices(gamepad(), text, size);
}

}  // namespace
}  // namespace stepwire::evdev

extern "C" const stepwire_driver* stepwire_driver_v1(void) {
  static const stepwire_driver driver = stepwire::support::driver_table<stepwire::evdev::Gamepad>(
      "gamepad", "axes and buttons of gamepads and joysticks", stepwire::evdev::settings,
      stepwire::evdev::list);
  return &driver;
}
