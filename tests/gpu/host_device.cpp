#include "tests/gpu/host_device.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>

#include "engine/base/io/file.hpp"
#include "engine/simulate/codegen/library.hpp"

namespace stepwire {

namespace {

class HostKernel : public device::Kernel {
 public:
  using Function = void (*)(device::Piece);
  explicit HostKernel(Function function) : function_(function) {}
  void step(const device::Piece& piece) override { function_(piece); }

 private:
  Function function_;
};

}  // namespace

void* HostDevice::allocate(std::size_t bytes) {
  return std::malloc(bytes);
}

void HostDevice::release(void* memory) noexcept {
  std::free(memory);
}

void HostDevice::write(void* memory, const void* from, std::size_t bytes) {
  std::memcpy(memory, from, bytes);
}

void HostDevice::read(void* to, const void* memory, std::size_t bytes) {
  std::memcpy(to, memory, bytes);
}

std::unique_ptr<device::Kernel> HostDevice::load(const std::string& library) {
  void* loaded = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!loaded) throw device::DeviceError(::dlerror());
  return std::make_unique<HostKernel>(
      reinterpret_cast<HostKernel::Function>(::dlsym(loaded, device::kernel_name)));
}

std::string host_library(const device::KernelText& kernel, const std::string& stem, std::string& problem) {
  io::write_file(stem + ".cpp", kernel.source);
  std::vector<std::string> flags = codegen::library_flags();
  flags.emplace_back("-O1");
  problem = codegen::Compiler().compile(stem + ".cpp", stem + ".so", flags, {});
  return problem.empty() ? stem + ".so" : "";
}

}  // namespace stepwire
