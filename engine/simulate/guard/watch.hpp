#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulate/guard/energy_window.hpp"

namespace stepwire::guard {

inline constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Limits of one output channel, in the unit of the channel.
struct OutputLimits {
  std::string name;  ///< name in messages; for a wired channel with the place in the rig file
  double safe = 0.0;
  double least = -no_limit, most = no_limit;
  double rate = no_limit;  ///< largest change in a second
  std::string unit{};
};

/// Limits of one input channel, in the unit of the channel.
struct InputLimits {
  std::string name;  ///< as in OutputLimits
  double least = -no_limit, most = no_limit;
  double rate = no_limit;  ///< largest change in a second, such as a speed, or of a jump of an encoder
  std::int64_t stuck = 0;  ///< time after which an unchanged value is a fault [ns]; 0: never
  std::string unit{};
};

/// Input that must be above a number as long as outputs may differ from their safe values.
struct DeadMan {
  std::size_t input = 0;
  double above = 0.0;
};

/// Input in SI: scale * value of the channel + offset.
struct ScaledInput {
  std::size_t input = 0;
  double scale = 1.0, offset = 0.0;

  double of(const double* inputs) const { return scale * inputs[input] + offset; }
};

/// Limit of the energy in the last second: the integral of an effort (force, voltage) times a flow (speed,
/// current), or of a force over the change of a position.
struct PowerLimit {
  std::string name;
  ScaledInput effort, flow;
  bool flow_is_position = false;
  double most = no_limit;  ///< [J], in either direction
};

/// Limits of all channels, independent of the diagram.
struct WatchLimits {
  std::int64_t period = 1'000'000;   ///< of the loop [ns]
  std::int64_t late = 2'000'000;     ///< largest time between two commands [ns]
  std::int64_t ramp = 0;             ///< time in which outputs go from their safe values to the commands [ns]
  std::vector<std::string> devices;  ///< names
  std::vector<InputLimits> inputs;
  std::vector<OutputLimits> outputs;
  std::optional<DeadMan> dead_man;
  std::vector<PowerLimit> powers;
};

/// Decision on what the outputs of a rig are: the commands of a loop, or the safe values.
///
/// It is fed with times, inputs and commands, and has neither clock nor device. The first violation trips it,
/// and it stays tripped: the outputs are the safe values from then on. Nothing but text() allocates.
class Watch {
 public:
  enum class Cause {
    none,
    late,         ///< no command in time
    not_finite,   ///< a command that is not finite
    beyond,       ///< a command out of its limits
    too_fast,     ///< a command that changes too fast
    input_bad,    ///< an input that is not finite
    input_range,  ///< an input out of its range
    input_jump,   ///< an input that changes too fast
    input_stuck,  ///< an input that does not change
    power,        ///< too much energy in a second
    released,     ///< the dead-man input is released
    stale,        ///< a device has no new values
    device,       ///< a device fails
    keeper        ///< the keeper of the guard has ended or is stopped
  };

  explicit Watch(WatchLimits limits);

  /// Takes the inputs of an instant [ns].
  void sensed(std::int64_t now, const double* inputs) noexcept;
  /// Takes the command of an instant.
  void commanded(std::int64_t now, const double* values) noexcept;
  /// Trips where the last command is too old.
  void waited(std::int64_t now) noexcept;
  /// Returns to the safe values between two commands; the next command begins anew.
  void rest() noexcept;
  /// Trips for the result of driver.h of a device, unless it is OK.
  void accept(int result, std::size_t device) noexcept;

  /// Trips since the keeper of the guard has ended or is stopped.
  void lost_keeper() noexcept { trip(Cause::keeper); }

  /// Returns the present values of the outputs.
  const double* outputs() const { return outputs_.data(); }
  const double* safe() const { return safe_.data(); }
  bool tripped() const { return cause_ != Cause::none; }
  Cause cause() const { return cause_; }
  /// Returns why it tripped, in a sentence; "" if it has not.
  std::string text() const;
  /// Returns the time of the next check, if no command is taken before [ns].
  std::int64_t next_check() const { return last_command_ + limits_.late; }
  const WatchLimits& limits() const { return limits_; }

 private:
  /// `from` and `allowed` are the value before a change that is too large, and the largest change.
  void trip(Cause cause, std::size_t place = 0, double value = 0.0, double from = 0.0,
            double allowed = 0.0) noexcept;
  void check_input(std::size_t i, double value, std::int64_t now) noexcept;
  void check_powers(std::int64_t now, const double* inputs) noexcept;
  bool accepts(std::size_t i, double value, double seconds) noexcept;
  double ramp_share(std::int64_t now) const noexcept;
  void hold_safe() noexcept;
  std::string text_of_output() const;
  std::string text_of_change(const std::string& unit) const;
  std::string text_of_device() const;
  std::string text_of_input() const;

  WatchLimits limits_;
  std::vector<double> safe_, outputs_, commands_, inputs_;
  std::vector<EnergyWindow> energies_;
  std::vector<std::int64_t> changed_;  ///< of each input
  std::int64_t last_command_ = 0, last_sensed_ = 0, ramp_begin_ = 0;
  bool commanded_ = false, sensed_ = false, held_ = false;  ///< held_: the dead-man input was above once
  Cause cause_ = Cause::none;
  std::size_t place_ = 0;  ///< of the channel, limit of energy or device
  double value_ = 0.0, from_ = 0.0, allowed_ = 0.0;
};

}  // namespace stepwire::guard
