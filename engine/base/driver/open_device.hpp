#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/driver/driver.h"

namespace stepwire::driver {

/// Shared object of a driver that was found.
struct FoundDriver {
  std::string name, file;
};

/// Returns the folders that are searched for drivers, in their order: lib/stepwire/drivers beside the program
/// or up to two levels above, then those of STEPWIRE_DRIVERS, separated by colons.
std::vector<std::string> driver_folders();

/// Returns the drivers in these folders by name; the first one of a name counts.
std::vector<FoundDriver> found_drivers();

/// Returns the file of a driver. Throws EnvironmentError with the known names where there is none of this
/// name.
std::string driver_file(const std::string& name);

/// Loads a driver for the rest of the process. Throws EnvironmentError where it cannot be loaded.
const stepwire_driver& load_driver(const std::string& file);

/// Returns the file of a program in lib/stepwire. Throws EnvironmentError where it is missing.
std::string program_file(const std::string& name);

using Settings = std::vector<std::pair<std::string, std::string>>;

/// Device behind a driver. Its functions between start() and stop() neither allocate nor throw.
class OpenDevice {
 public:
  /// Throws EnvironmentError with the driver's sentence.
  OpenDevice(const stepwire_driver& driver, const Settings& settings);
  ~OpenDevice();
  OpenDevice(const OpenDevice&) = delete;
  OpenDevice& operator=(const OpenDevice&) = delete;

  const std::vector<stepwire_channel>& inputs() const { return inputs_; }
  const std::vector<stepwire_channel>& outputs() const { return outputs_; }
  bool is_clock() const { return driver_.wait != nullptr; }

  /// Throws EnvironmentError with the driver's sentence.
  void start(std::int64_t period, const double* safe);
  /// False while no value has come since the start. Throws EnvironmentError where the device has failed.
  bool is_ready();
  /// Returns 1, 0 or -1 as `ready` of driver.h.
  int ready() noexcept { return driver_.ready ? driver_.ready(device_) : 1; }
  /// Return a result of driver.h; one that it does not have is a failure.
  int read(double* values) noexcept { return known(driver_.read(device_, values)); }
  int write(const double* values) noexcept { return known(driver_.write(device_, values)); }
  /// Has no effect before start().
  int safe() noexcept { return started_ ? known(driver_.safe(device_)) : STEPWIRE_OK; }
  int wait(std::int64_t limit) noexcept { return driver_.wait(device_, limit); }
  void stop() noexcept;
  /// Returns the line of counts.
  std::string report() const;

 private:
  static int known(int result) {
    return result >= STEPWIRE_OK && result <= STEPWIRE_ENDED ? result : STEPWIRE_FAILED;
  }

  const stepwire_driver& driver_;
  void* device_;
  bool started_ = false;
  std::vector<stepwire_channel> inputs_, outputs_;
};

}  // namespace stepwire::driver
