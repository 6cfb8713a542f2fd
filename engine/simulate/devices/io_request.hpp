#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/key.hpp"

namespace stepwire::devices {

/// Number of a rig file with its place; its unit is checked once the port is known.
struct PlacedNumber {
  unit::Quantity quantity;
  yaml::Mark mark;
};

/// Two numbers, "[0 A, 0.35 A]".
struct PlacedRange {
  PlacedNumber least, most;
};

struct DeviceRequest {
  struct Setting {
    std::string key, value;
    yaml::Mark mark;
  };

  std::string name, driver;
  yaml::Mark mark;
  std::vector<Setting> settings;
};

enum class Direction { forward, reverse };
enum class Stale { stop, hold };

/// Connection of an input of the diagram.
struct InputRequest {
  std::string port, device, channel, unit;
  yaml::Mark mark;
  std::optional<PlacedNumber> scale, offset, rate;
  std::optional<PlacedRange> range;
  double filter = 0.0;  ///< cutoff [Hz]; 0: none
  double stuck = 0.0;   ///< [s]; 0: never
  Direction direction = Direction::forward;
  Stale stale = Stale::stop;
};

/// Connection of an output of the diagram.
struct OutputRequest {
  std::string port, device, channel, unit;
  yaml::Mark mark;
  std::optional<PlacedNumber> scale, offset, rate, safe;
  std::optional<PlacedRange> limits;
  Direction direction = Direction::forward;
};

struct DeadManRequest {
  std::string device, channel;
  std::optional<PlacedNumber> above;
  yaml::Mark mark;
};

/// Limit of the energy in a second, of an input that is a force and one that is a speed or a position.
struct EnergyRequest {
  std::string name, force, speed, position;
  double most = 0.0;  ///< [J]
  yaml::Mark mark;
};

/// Content of a rig file: what is wired to what.
struct IoRequest {
  std::string file;
  std::vector<DeviceRequest> devices;
  std::vector<InputRequest> inputs;
  std::vector<OutputRequest> outputs;
  std::optional<DeadManRequest> dead_man;
  std::vector<EnergyRequest> energies;
  std::optional<bool> guard;   ///< std::nullopt: where a device has outputs
  std::optional<double> late;  ///< [s]; std::nullopt: one and a half periods
  yaml::Mark late_mark;
  double wait = 5.0;  ///< [s]
  double ramp = 0.0;  ///< [s]
  std::string clock;  ///< device; empty: the timer
  yaml::Mark clock_mark;
};

/// Reads a rig file. Throws yaml::Error with all faults.
IoRequest read_io(const std::string& file);

/// Returns the form of a rig file.
const yaml::Key& io_form();

}  // namespace stepwire::devices
