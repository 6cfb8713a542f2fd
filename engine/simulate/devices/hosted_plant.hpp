#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/driver/open_device.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/simulate/devices/loop_rig.hpp"
#include "engine/simulate/devices/ports.hpp"

namespace stepwire::devices {

/// Fault of a sensor of a rig in software: "stuck:force@2 s", "jump:angle=0.5 rad@2 s", "nan:force@2 s",
/// "unplug@2 s"; until an end in "unplug@2 s..2.02 s".
struct PlantFault {
  enum class Kind { stuck, jump, nan, unplug };
  Kind kind = Kind::stuck;
  std::string output;  ///< empty for unplug
  double by = 0.0;     ///< of a jump, SI
  double time = 0.0;   ///< [s]
  double end = std::numeric_limits<double>::infinity();
};

/// Way in which a plant is offered to a controller.
struct PlantCall {
  std::string driver;         ///< "shared" or "udp"
  driver::Settings settings;  ///< without the channels
  double latency = 0.0;       ///< by which outputs are seen later [s]
  double inhibit = 0.1;       ///< age of a command from which the amplifiers give the inputs' defaults [s]
  std::int64_t seed = 1;      ///< of the noise
  std::vector<std::string> quanta, noises;  ///< "angle=0.09 deg": step of an output, standard deviation
  std::vector<std::string> faults;          ///< see PlantFault
};

/// Plant of a loop, offered through a driver as if it were hardware: the inputs of its diagram are what a
/// controller writes, its outputs what that reads, in SI.
class HostedPlant : public LoopRig, public realtime::Device {
 public:
  /// Opens the driver. Throws Error for names and numbers that are wrong, and EnvironmentError.
  HostedPlant(const PlantCall& call, const plan::Plan& plan, double period);

  realtime::Device& device() override { return *this; }
  std::vector<std::string> finish() override;

  void read(double* inputs) noexcept override;
  void write(const double* outputs) noexcept override;

 private:
  struct Sensor {
    std::string name;
    double quantum = 0.0, noise = 0.0;
    double held = 0.0;
  };

  void open(const PlantCall& call, double period);
  void begin(const double* outputs) noexcept;
  void apply_faults() noexcept;
  void set_each(const std::vector<std::string>& texts, double Sensor::*member);
  double number(const std::string& text, const Port& port) const;
  std::size_t sensor(const std::string& name, const std::string& text) const;
  PlantFault fault_of(const std::string& text) const;

  std::vector<Port> in_, out_;
  std::unique_ptr<driver::OpenDevice> open_;
  std::vector<Sensor> sensors_;
  std::vector<PlantFault> faults_;
  std::vector<double> defaults_, commands_, shown_, delay_line_;
  std::size_t delay_ = 0;  ///< periods
  std::int64_t seed_, steps_ = 0, inhibited_ = 0;
  double period_;
  bool unplugged_ = false, began_ = false;
  bool commanded_ = false;  ///< true once a first command has come
  bool has_shown_ = false;  ///< true once the sensors have shown a first value
};

}  // namespace stepwire::devices
