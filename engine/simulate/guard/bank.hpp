#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/driver/open_device.hpp"

namespace stepwire::guard {

/// Settings of one device of a rig.
struct DeviceSettings {
  std::string name, driver;
  std::string file;  ///< of the driver
  driver::Settings settings;
  std::size_t outputs = 0;  ///< count of its channels, as it was when the rig was checked
};

/// Use of the inputs of a device.
enum class InputUse : std::uint8_t {
  unused,  ///< none is wired
  held,    ///< values that are stale count on
  live     ///< values that are stale end the use of the devices
};

/// Devices of a rig as one: their channels are concatenated in the order of the devices.
class Bank {
 public:
  /// Opens all devices. Throws EnvironmentError.
  explicit Bank(const std::vector<DeviceSettings>& devices);

  std::size_t devices() const { return devices_.size(); }
  driver::OpenDevice& device(std::size_t index) { return *devices_[index].open; }
  std::size_t inputs() const { return inputs_; }
  std::size_t outputs() const { return outputs_; }
  std::size_t first_input(std::size_t device) const { return devices_[device].first_input; }
  std::size_t first_output(std::size_t device) const { return devices_[device].first_output; }

  /// Starts all devices, with a safe value for each output. Throws EnvironmentError.
  void start(std::int64_t period, const double* safe);
  /// Waits until each device with wired inputs has a value, or `goes_on` is false, at most for this time
  /// [ns]. Repeats the safe values until then, since the other side may wait for them. Throws
  /// EnvironmentError with the devices that are silent.
  void await_values(std::int64_t limit, const std::function<bool()>& goes_on);
  /// Return the worst result of driver.h of the devices; culprit() is the device that had it last.
  int read(double* inputs) noexcept;
  int write(const double* outputs) noexcept;
  int safe() noexcept;
  std::size_t culprit() const { return culprit_; }
  /// Sets the use of the inputs of each device.
  void use(const std::vector<InputUse>& uses);
  void stop() noexcept;
  /// Returns a line of counts for each device that has any, and one for each failure: "card: failed: .. ".
  std::vector<std::string> reports() const;

 private:
  struct One {
    std::string name;
    std::unique_ptr<driver::OpenDevice> open;
    std::size_t first_input = 0, first_output = 0;
    InputUse use = InputUse::live;
  };

  /// Returns the worse of two results.
  int worse(int worst, int result, std::size_t device) noexcept;
  /// Returns the names of devices with wired inputs that have no value yet.
  std::vector<std::string> silent();

  std::vector<One> devices_;
  std::size_t inputs_ = 0, outputs_ = 0, culprit_ = 0;
};

}  // namespace stepwire::guard
