#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "engine/simulate/run/lane_runner.hpp"

namespace stepwire::run {

/// Runs of the plans of one call on a device, such as a GPU. Thread-safe.
class DeviceRuns {
 public:
  virtual ~DeviceRuns() = default;
  /// Returns the number of runs of a member that the device makes together; 0 if it makes none.
  virtual std::size_t at_once(std::size_t member) const = 0;
  /// Makes runs of a member from time 0 to their ends. Returns false, with the runs at time 0, if the
  /// processor has to make them.
  virtual bool run(std::size_t member, std::vector<PendingRun>& runs) = 0;
  virtual DeviceReport report() const = 0;
};

/// Use of the runs that a call makes.
struct DeviceCall {
  const std::atomic<bool>* interrupt;  ///< may be nullptr
  unsigned threads;                    ///< threads that bring runs
  bool keeps_rows;                     ///< false if only the last row of each run is kept
};

/// Source of runs on a device.
class DeviceSource {
 public:
  virtual ~DeviceSource() = default;
  /// Prepares the device for the runs of these plans, which must outlive the result.
  virtual std::unique_ptr<DeviceRuns> open(const std::vector<PlanOfRuns>& members,
                                           const DeviceCall& call) = 0;
};

}  // namespace stepwire::run
