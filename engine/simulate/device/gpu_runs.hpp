#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "engine/simulate/device/device.hpp"
#include "engine/simulate/device/ptx_compiler.hpp"
#include "engine/simulate/run/device_runs.hpp"

namespace stepwire::device {

/// Choice of the device for the runs of a sweep.
enum class DeviceUse {
  cpu,
  gpu,       ///< the GPU, for all that can go there
  automatic  ///< the GPU for sweeps that are large enough
};

/// Smallest sweep that goes to the GPU by itself: its runs, and the ticks of all of them together. Below it
/// the processor takes seconds, and compiler and driver take a part of that.
inline constexpr double least_runs = 10e3, least_ticks = 1e9;

/// Runs of sweeps on an NVIDIA GPU. Compiler and driver are sought at the first use.
class GpuRuns : public run::DeviceSource {
 public:
  /// Returns a device, or nullptr with the reason.
  using Opener = std::function<std::unique_ptr<Device>(std::string& why)>;

  explicit GpuRuns(DeviceUse use);
  GpuRuns(DeviceUse use, Opener opener) : use_(use), opener_(std::move(opener)) {}

  std::unique_ptr<run::DeviceRuns> open(const std::vector<run::PlanOfRuns>& members,
                                        const run::DeviceCall& call) override;

 private:
  /// Finds compiler and device. Returns false with the reason.
  bool find(std::string& why);

  const DeviceUse use_;
  const Opener opener_;
  std::mutex mutex_;
  std::unique_ptr<PtxCompiler> compiler_;
  std::shared_ptr<Device> device_;
};

}  // namespace stepwire::device
