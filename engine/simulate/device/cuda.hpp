#pragma once

#include <memory>
#include <string>

#include "engine/simulate/device/device.hpp"

namespace stepwire::device {

/// Opens the first NVIDIA GPU by its driver, libcuda.so.1, which is loaded at the first call. Returns
/// nullptr, with the reason in `why` as a sentence, where driver or GPU are missing.
std::unique_ptr<Device> open_cuda(std::string& why);

}  // namespace stepwire::device
