// Driver for tablets with a pen, as the kernel offers them.
#include "engine/drivers/evdev/input_device.hpp"
#include "engine/drivers/support/table.hpp"

namespace stepwire::evdev {
namespace {

bool is_tablet(const InputFile& file) {
  return file.axes().has(ABS_X) && file.axes().has(ABS_Y) && file.keys().has(BTN_TOOL_PEN);
}

const Kind& tablet() {
  static const Kind kind{"tablet",
                         "one has the axes x and y, and a pen",
                         is_tablet,
                         {{ABS_X, "x", Scaling::width, "from the left edge"},
                          {ABS_Y, "y", Scaling::height, "from the upper edge down"},
                          {ABS_PRESSURE, "pressure", Scaling::trigger, "1 is the largest"},
                          {ABS_TILT_X, "tilt_x", Scaling::angle, "to the right"},
                          {ABS_TILT_Y, "tilt_y", Scaling::angle, "towards the user"}},
                         {{BTN_TOUCH, BTN_TOUCH, "tip", "1 while the tip touches"},
                          {BTN_TOOL_PEN, BTN_TOOL_AIRBRUSH, "near", "1 while a pen is seen"},
                          {BTN_TOOL_RUBBER, BTN_TOOL_RUBBER, "rubber", "1 while its other end is seen"},
                          {BTN_STYLUS, BTN_STYLUS, "stylus", "button of the pen"},
                          {BTN_STYLUS2, BTN_STYLUS2, "stylus2", "button of the pen"}},
                         false};
  return kind;
}

struct Tablet : InputDevice {
  explicit Tablet(const support::Settings& settings) : InputDevice(settings, tablet()) {}
};

constexpr stepwire_known_setting settings[] = {
    {"path", "file of the device, /dev/input/event3 or one of by-id; the first tablet otherwise", ""},
    {"width", "of the whole range of x, in place of the resolution: 0.3 m", ""},
    {"height", "of the whole range of y", ""},
    {"stale",
     "age of the last report from which values are stale, 5 s; at rest there is none; never without it", ""},
    {nullptr, nullptr, nullptr}};

void list(char* text, std::size_t size) {
  list_devices(tablet(), text, size);
}

}  // namespace
}  // namespace stepwire::evdev

extern "C" const stepwire_driver* stepwire_driver_v1(void) {
  static const stepwire_driver driver = stepwire::support::driver_table<stepwire::evdev::Tablet>(
      "tablet", "place, pressure and tilt of the pen of a tablet", stepwire::evdev::settings,
      stepwire::evdev::list);
  return &driver;
}
