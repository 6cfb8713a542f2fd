#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/drivers/evdev/input_file.hpp"
#include "engine/drivers/support/settings.hpp"

namespace stepwire::evdev {

/// Way from the number of an axis to the value of its channel.
enum class Scaling {
  stick,    ///< -1 to 1 around the middle, 0 within the flat zone
  trigger,  ///< 0 to 1
  lever,    ///< a trigger beside a right stick of its own, otherwise a stick
  hat,      ///< a trigger where the range begins at 0, otherwise a stick
  width,    ///< [m] from the first edge, by the resolution or the setting `width`
  height,   ///< the same with `height`
  angle     ///< [rad], by the resolution; no channel without one
};

struct AxisRow {
  std::uint16_t code;
  const char* name;
  Scaling scaling;
  const char* doc;
};

/// Buttons from `first` to `last`: the channel is 1 while one of them is down.
struct KeyRow {
  std::uint16_t first, last;
  const char* name;
  const char* doc;
};

/// A kind of input devices: how one is known, and its channels.
struct Kind {
  const char* name;   ///< "gamepad"
  const char* needs;  ///< "one has the axes x and y, ..."
  bool (*fits)(const InputFile&);
  std::vector<AxisRow> axes;
  std::vector<KeyRow> keys;
  bool has_more_keys;  ///< further buttons are channels by their codes
};

/// Input device of the kernel. Values change with whole reports only. After a loss of reports, which the
/// kernel marks in its queue, the state is fetched.
class InputDevice {
 public:
  /// Opens the file of `path`, or the first device of the kind.
  InputDevice(const support::Settings& settings, const Kind& kind);

  const support::Channels& channels() const { return channels_; }
  void start(std::int64_t, const double*);
  int read(double* values) noexcept;
  int write(const double*) noexcept { return STEPWIRE_OK; }
  int safe() noexcept { return STEPWIRE_OK; }
  void stop() noexcept {}
  void report(char* text, std::size_t size) const;

 private:
  /// value = (number - zero) / span, without the flat zone, within least and most.
  struct Axis {
    std::size_t code;
    double zero, flat, span, least, most;
    int number;

    double value() const;
  };
  struct Button {
    std::size_t first, last;
  };

  static void make_ratio(Axis& axis, const input_absinfo& info, bool both_sides);
  void add(const AxisRow& row, const support::Settings& settings);
  void add(const KeyRow& row);
  void add_more_keys();
  double span_of_length(const AxisRow& row, const input_absinfo& info,
                        const support::Settings& settings) const;
  Scaling scaling_of(const AxisRow& row, const input_absinfo& info) const;
  bool fetch() noexcept;
  bool take(const input_event& event) noexcept;
  void show() noexcept;

  InputFile file_;
  support::Channels channels_;
  std::vector<Axis> axes_;
  std::vector<Button> buttons_;
  Keys down_;
  std::vector<double> values_;
  std::int64_t stale_, shown_ = 0;  ///< [ns]; stale_ 0: never
  bool dropped_ = false;            ///< at the end of the report the state is fetched
  std::uint64_t reports_ = 0, drops_ = 0;
};

/// Writes the devices of a kind that are plugged in, one line each.
void list_devices(const Kind& kind, char* text, std::size_t size);

}  // namespace stepwire::evdev
