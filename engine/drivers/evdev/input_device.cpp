#include "engine/drivers/evdev/input_device.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

#include "engine/drivers/evdev/system.hpp"
#include "engine/drivers/support/newest.hpp"

namespace stepwire::evdev {

namespace {

constexpr std::size_t events_of_read = 64;
constexpr int most_reads = 64;  // of one call: more than the queue of the kernel
constexpr double millimetres = 1e3;
const char* const need_of_group = "your user needs the group 'input' to read them";

InputFile open_path(const std::string& path, const Kind& kind) {
  std::optional<InputFile> file = InputFile::open(path);
  if (!file) {
    const std::string reason = errno == ENOTTY ? "it is no input device" : std::strerror(errno);
    throw std::runtime_error("the device " + path + " cannot be opened: " + reason);
  }
  if (!kind.fits(*file))
    throw std::runtime_error(path + " (" + file->name() + ") is no " + kind.name + ": " + kind.needs);
  return std::move(*file);
}

InputFile open_first(const Kind& kind) {
  int closed = 0;
  for (const std::string& path : System::files()) {
    std::optional<InputFile> file = InputFile::open(path);
    if (file && kind.fits(*file)) return std::move(*file);
    closed += !file && errno == EACCES ? 1 : 0;
  }
  std::string text = std::string("there is no ") + kind.name + " in /dev/input";
  if (closed > 0) text += "; " + std::to_string(closed) + " files there are closed, " + need_of_group;
  throw std::runtime_error(text);
}

}  // namespace

/// Scales an axis to 0 to 1, or to -1 to 1 around its middle.
void InputDevice::make_ratio(Axis& axis, const input_absinfo& info, bool both_sides) {
  const double least = info.minimum, most = info.maximum;
  if (both_sides) axis.zero = 0.5 * (least + most);
  if (both_sides) axis.least = -1.0;
  const double way = most - axis.zero;
  axis.flat = info.flat > 0 && info.flat < way ? info.flat : 0.0;
  axis.span = way - axis.flat;
}

double InputDevice::Axis::value() const {
  const double from_zero = number - zero, way = std::max(0.0, std::abs(from_zero) - flat);
  return std::clamp(std::copysign(way, from_zero) / span, least, most);
}

InputDevice::InputDevice(const support::Settings& settings, const Kind& kind)
    : file_(settings.has("path") ? open_path(settings.text("path"), kind) : open_first(kind)),
      stale_(settings.time("stale", 0.0)) {
  for (const AxisRow& row : kind.axes)
    if (file_.axes().has(row.code)) add(row, settings);
  for (const KeyRow& row : kind.keys)
    if (file_.keys().has_any(row.first, row.last)) add(row);
  if (kind.has_more_keys) add_more_keys();
  values_.assign(channels_.table().size(), 0.0);
}

Scaling InputDevice::scaling_of(const AxisRow& row, const input_absinfo& info) const {
  const bool has_right_stick = file_.axes().has(ABS_RX) && file_.axes().has(ABS_RY);
  if (row.scaling == Scaling::lever) return has_right_stick ? Scaling::trigger : Scaling::stick;
  if (row.scaling == Scaling::hat) return info.minimum >= 0 ? Scaling::trigger : Scaling::stick;
  return row.scaling;
}

/// Returns the numbers of an axis in a meter.
double InputDevice::span_of_length(const AxisRow& row, const input_absinfo& info,
                                   const support::Settings& settings) const {
  const char* const key = row.scaling == Scaling::width ? "width" : "height";
  const double length = settings.length(key, 0.0);
  if (length < 0.0) support::Settings::refuse(key, "must be above 0");
  if (length > 0.0) return (static_cast<double>(info.maximum) - info.minimum) / length;
  if (info.resolution > 0) return millimetres * info.resolution;
  throw std::runtime_error(file_.path() + " (" + file_.name() + ") has no resolution of its axis " +
                           row.name + "; the setting '" + key +
                           "' has the length of the axis, such as 0.2 m");
}

void InputDevice::add(const AxisRow& row, const support::Settings& settings) {
  input_absinfo info{};
  if (!file_.fetch(row.code, info) || info.maximum <= info.minimum) return;
  const Scaling scaling = scaling_of(row, info);
  const double least = info.minimum, most = info.maximum;
  const char* unit = "";
  Axis axis{row.code, least, 0.0, 1.0, 0.0, 1.0, info.value};
  if (scaling == Scaling::angle) {
    if (info.resolution <= 0) return;
    axis.zero = 0.0;
    axis.span = info.resolution;
    axis.least = least / axis.span;
    axis.most = most / axis.span;
    unit = "rad";
  } else if (scaling == Scaling::width || scaling == Scaling::height) {
    axis.span = span_of_length(row, info, settings);
    axis.most = (most - least) / axis.span;
    unit = "m";
  } else {
    make_ratio(axis, info, scaling == Scaling::stick);
  }
  channels_.add(row.name, STEPWIRE_INPUT, "analog", unit, axis.least, axis.most, row.doc);
  axes_.push_back(axis);
}

void InputDevice::add(const KeyRow& row) {
  channels_.add(row.name, STEPWIRE_INPUT, "digital", "", 0.0, 1.0, row.doc);
  buttons_.push_back({row.first, row.last});
}

/// Adds the buttons that no row has, by their codes.
void InputDevice::add_more_keys() {
  for (std::size_t code = BTN_MISC; code < KEY_CNT; ++code) {
    const bool is_known = std::any_of(buttons_.begin(), buttons_.end(), [code](const Button& one) {
      return one.first <= code && code <= one.last;
    });
    if (is_known || !file_.keys().has(code)) continue;
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "button_%03zx", code);
    channels_.add(name.data(), STEPWIRE_INPUT, "digital", "", 0.0, 1.0, "");
    buttons_.push_back({code, code});
  }
}

void InputDevice::start(std::int64_t, const double*) {
  if (!fetch())
    throw std::runtime_error("the device " + file_.path() + " does not answer: " + std::strerror(errno));
}

/// Fetches the state of all axes and buttons.
bool InputDevice::fetch() noexcept {
  for (Axis& axis : axes_) {
    input_absinfo info{};
    if (!file_.fetch(axis.code, info)) return false;
    axis.number = info.value;
  }
  if (!file_.fetch(down_)) return false;
  show();
  return true;
}

void InputDevice::show() noexcept {
  double* value = values_.data();
  for (const Axis& axis : axes_) *value++ = axis.value();
  for (const Button& one : buttons_) *value++ = down_.has_any(one.first, one.last) ? 1.0 : 0.0;
  shown_ = support::monotonic();
}

/// Takes an event. Returns false where the device does not answer.
bool InputDevice::take(const input_event& event) noexcept {
  if (event.type == EV_SYN && event.code == SYN_DROPPED) {
    dropped_ = true;
    ++drops_;
  } else if (event.type == EV_SYN && event.code == SYN_REPORT) {
    ++reports_;
    if (std::exchange(dropped_, false)) return fetch();
    show();
  } else if (event.type == EV_ABS) {
    for (Axis& axis : axes_)
      if (axis.code == event.code) axis.number = event.value;
  } else if (event.type == EV_KEY && event.code < KEY_CNT) {
    down_.set(event.code, event.value != 0);
  }
  return true;
}

int InputDevice::read(double* values) noexcept {
  std::array<input_event, events_of_read> events;
  for (int i = 0; i < most_reads; ++i) {
    const std::optional<std::size_t> count = file_.read(events.data(), events.size());
    if (!count) return STEPWIRE_FAILED;
    if (*count == 0) break;
    for (std::size_t k = 0; k < *count; ++k)
      if (!take(events[k])) return STEPWIRE_FAILED;
  }
  std::copy(values_.begin(), values_.end(), values);
  return stale_ > 0 && support::monotonic() - shown_ > stale_ ? STEPWIRE_STALE : STEPWIRE_OK;
}

void InputDevice::report(char* text, std::size_t size) const {
  std::snprintf(text, size, "%s (%s): %llu reports, %llu times some were dropped and the state fetched",
                file_.path().c_str(), file_.name().c_str(), static_cast<unsigned long long>(reports_),
                static_cast<unsigned long long>(drops_));
}

void list_devices(const Kind& kind, char* text, std::size_t size) {
  std::size_t used = 0;
  int closed = 0;
  for (const std::string& path : System::files()) {
    const std::optional<InputFile> file = InputFile::open(path);
    closed += !file && errno == EACCES ? 1 : 0;
    if (file && kind.fits(*file) && used < size)
      used += static_cast<std::size_t>(
          std::snprintf(text + used, size - used, "    %s  %s\n", path.c_str(), file->name().c_str()));
  }
  if (closed > 0 && used < size)
    std::snprintf(text + used, size - used, "    %d files of /dev/input are closed; %s\n", closed,
                  need_of_group);
}

}  // namespace stepwire::evdev
