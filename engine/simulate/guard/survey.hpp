#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulate/guard/bank.hpp"

namespace stepwire::guard {

/// Channel of a device, as its driver states it.
struct SurveyedChannel {
  std::string name, unit;
  double least = 0.0, most = 0.0;
};

/// Setting that a driver knows; `otherwise` is its default, std::nullopt if it is required.
struct KnownSetting {
  std::string key, doc;
  std::optional<std::string> otherwise{};
};

/// Answers of the driver of one device.
struct SurveyedDevice {
  std::string driver, doc;  ///< name and explanation
  bool is_clock = false;
  std::vector<KnownSetting> settings;
  std::string plugged_in;  ///< lines; "" for none
  std::vector<SurveyedChannel> inputs, outputs;
  std::string failure;  ///< a sentence on the driver; "" for none
};

/// Calls of each driver in a survey: load it; list what is plugged in; open the device and close it.
enum class SurveyDepth : std::uint32_t { load, list, open };

/// Default time for all calls of drivers in a survey [ns].
inline constexpr std::int64_t longest_survey = 10'000'000'000;

/// Calls the drivers of devices in a process of its own, so that one that crashes, ends its process or does
/// not return ends that one alone. Nothing moves. The process is killed after `limit` [ns].
///
/// Returns the answers in the order of the devices. Where one has ended the process, its `failure` alone is
/// set. std::nullopt once `interrupt` is true. Throws EnvironmentError where the process cannot be started.
std::optional<std::vector<SurveyedDevice>> survey(const std::vector<DeviceSettings>& devices,
                                                  SurveyDepth depth, std::int64_t limit = longest_survey,
                                                  const std::atomic<bool>* interrupt = nullptr);

/// Makes the survey whose call is in the memory of a descriptor, in the program of the guard. Returns its
/// exit status.
int run_survey(int memory);

}  // namespace stepwire::guard
