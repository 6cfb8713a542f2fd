#pragma once

#include <memory>
#include <string>

#include "engine/simulate/device/device.hpp"
#include "engine/simulate/device/kernel_text.hpp"

namespace stepwire {

/// Device whose memory and kernels are those of this process, for tests without a GPU.
class HostDevice : public device::Device {
 public:
  std::string name() const override { return "host"; }
  std::size_t free_memory() override { return std::size_t{1} << 30; }
  void* allocate(std::size_t bytes) override;
  void release(void* memory) noexcept override;
  void write(void* memory, const void* from, std::size_t bytes) override;
  void read(void* to, const void* memory, std::size_t bytes) override;
  /// Loads the shared library at a path, in place of PTX.
  std::unique_ptr<device::Kernel> load(const std::string& library) override;
};

/// Compiles the text of a kernel for the processor. Returns the path of the library; an empty text with the
/// compiler's messages in `problem` on failure.
std::string host_library(const device::KernelText& kernel, const std::string& stem, std::string& problem);

}  // namespace stepwire
