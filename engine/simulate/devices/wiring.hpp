#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulate/devices/io_request.hpp"
#include "engine/simulate/devices/ports.hpp"
#include "engine/simulate/guard/survey.hpp"
#include "engine/simulate/guard/watch.hpp"

namespace stepwire::devices {

/// Input of the diagram: scale * channel + offset, in SI, through a filter.
struct InputWire {
  std::size_t port = 0, channel = 0;  ///< places among the numbers of the diagram and of all devices
  double scale = 1.0, offset = 0.0;
  double filter = 1.0;  ///< share of the new value in a step
  std::string unit;     ///< SI; "" for a pure number
};

/// Output of the diagram, within its limits; the channel gets scale * output + offset.
struct OutputWire {
  std::string name;
  std::size_t port = 0, channel = 0;
  double scale = 1.0, offset = 0.0;
  double least = 0.0, most = 0.0;  ///< SI
  double step = guard::no_limit;   ///< largest change in a period, SI
};

/// Checked connection of a diagram with devices.
struct Wiring {
  std::vector<guard::DeviceSettings> devices;
  std::vector<guard::InputUse> uses;  ///< of the inputs of each device
  std::int64_t wait = 0;              ///< largest time to the first values [ns]
  std::vector<InputWire> inputs;
  std::vector<OutputWire> outputs;
  guard::WatchLimits limits;
  bool guarded = false;
  std::optional<std::size_t> clock;  ///< device
  std::vector<std::string> notes;    ///< ports and channels that are not wired
};

/// Returns the devices of a request, whose drivers are loaded in a process of their own for their settings.
/// Throws yaml::Error for unknown drivers and settings, and ProcessStopped once `interrupt` is true.
std::vector<guard::DeviceSettings> device_settings(const IoRequest& request,
                                                   const std::atomic<bool>* interrupt = nullptr);

/// Devices of a rig with the answers of their drivers.
struct KnownDevices {
  std::vector<guard::DeviceSettings> settings;
  std::vector<guard::SurveyedDevice> answers;
  std::string failures;  ///< of devices that do not open, with device, driver and reason
};

/// Opens the devices of a request in a process of its own, and closes them. Throws as device_settings(), also
/// where a driver refuses the value of a setting.
KnownDevices known_devices(const IoRequest& request, const std::atomic<bool>* interrupt = nullptr);

/// Ports of a loop.
struct Ports {
  std::vector<Port> inputs, outputs;

  static Ports of(const plan::Plan& plan);
  /// Returns those that a rig file names, with safe values of 0: inputs of any unit, outputs of that of their
  /// limits.
  static Ports of(const IoRequest& request);
};

/// Connects ports with the channels of devices. `period` is that of the loop [s]. Throws yaml::Error with all
/// faults, and EnvironmentError without one where a device does not open.
Wiring wire(const IoRequest& request, const Ports& ports, const KnownDevices& devices, double period);

}  // namespace stepwire::devices
